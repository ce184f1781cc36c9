"""Muscles and their models: given a face, a model returns forces or displacements (design section 5)."""

from facemodel.muscles.muscle import Cosine, Fibre, Muscle, Sphincter
from facemodel.muscles.profile import Profile, Profiles

__all__ = ["Cosine", "Fibre", "Muscle", "Profile", "Profiles", "Sphincter"]
