"""The template skull, derived from the skin and tables of soft-tissue depth."""

from facemodel.making.skull.make import arches_of, make_skull, with_bones_about_teeth

__all__ = ["arches_of", "make_skull", "with_bones_about_teeth"]
