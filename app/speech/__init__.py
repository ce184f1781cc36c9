"""Sounds of a text, estimated by a program that is installed beside Risorius."""

from app.speech.espeak import espeak_program, sounds_of_text, spoken_sound

__all__ = ["espeak_program", "sounds_of_text", "spoken_sound"]
