"""Pictures without a window: one expression, or a sheet of all of them; no screen is needed."""

from ui.headless.gallery import gallery_to_file
from ui.headless.picture import render_image, render_to_file

__all__ = ["gallery_to_file", "render_image", "render_to_file"]
