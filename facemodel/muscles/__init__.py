"""Muscles and their models: given a surface, a model returns forces (design section 5)."""

from facemodel.muscles.muscle import Fibre, Muscle, Sphincter

__all__ = ["Fibre", "Muscle", "Sphincter"]
