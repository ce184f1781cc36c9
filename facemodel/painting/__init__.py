"""Painting the layers of a face: distances on the skin, brushes, regions, layers; pure functions and frozen values."""
