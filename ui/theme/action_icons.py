"""Which glyph stands for which action."""

from __future__ import annotations

from collections.abc import Mapping

GLYPHS: Mapping[str, str] = {
    "file.open": "folder-open-outline",
    "file.save": "content-save-outline",
    "file.screenshot": "camera-outline",
    "edit.undo": "undo",
    "edit.redo": "redo",
    "edit.copy": "content-copy",
    "edit.paste": "content-paste",
    "edit.reset": "restore",
    "edit.link": "link-variant",
    "edit.search": "magnify",
    "edit.palette": "chevron-right-box-outline",
    "view.front": "face-man-outline",
    "view.three-quarter": "face-man-profile",
    "view.left": "head-outline:mirrored",
    "view.right": "head-outline",
    "view.turntable": "axis-z-rotate-clockwise",
    "view.head": "fit-to-page-outline",
    "view.frame": "image-filter-center-focus",
    "view.skull": "skull-outline",
    "view.muscles": "arm-flex-outline",
    "view.forces": "arrow-top-right",
    "view.supports": "pin-outline",
    "view.wireframe": "vector-triangle",
    "view.influence": "blur",
    "tool.select": "cursor-default-outline",
    "tool.sculpt": "gesture",
    "tool.brush": "brush-outline",
    "tool.lasso": "lasso",
    "tool.fill": "format-color-fill",
    "tool.fibre": "vector-curve",
    "tool.ring": "ellipse-outline",
    "tool.move-skull": "cursor-move",
    "tool.turn-skull": "rotate-orbit",
    "tool.scale-skull": "resize",
    "face.information": "information-outline",
    "solve.now": "play-outline",
    "solve.cancel": "stop",
    "window.theme": "theme-light-dark",
    "help.shortcuts": "keyboard-outline",
}
"""Glyphs of Material Design Icons by action id; an action that is not here has none."""
