"""Workspaces: each its own panel, tools and drawing over the same face, so that switching never loses the view."""
