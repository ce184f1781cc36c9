"""The template skull, derived from the skin and tables of soft-tissue depth."""

from facemodel.making.skull.make import make_skull

__all__ = ["make_skull"]
