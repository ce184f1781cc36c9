"""Sculpting the field of an action unit by hand: corrections as layers over what is solved; pure functions."""
