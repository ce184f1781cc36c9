"""The window and what ties document, panels and viewport together."""
