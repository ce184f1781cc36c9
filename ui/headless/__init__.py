"""Pictures and films without a window: one expression, a sheet of all of them, an animation; no screen is needed."""

from ui.headless.film import film_frames
from ui.headless.gallery import gallery_to_file
from ui.headless.picture import render_image, render_to_file

__all__ = ["film_frames", "gallery_to_file", "render_image", "render_to_file"]
