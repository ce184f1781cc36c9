"""Where what can be made again is kept."""

from __future__ import annotations

import os
from pathlib import Path

import platformdirs


def cache_folder() -> Path:
    """Where solutions and compiled loops are kept; ``RISORIUS_CACHE`` in the environment names another folder."""
    named = os.environ.get("RISORIUS_CACHE")
    return Path(named) if named else Path(platformdirs.user_cache_dir("risorius", appauthor=False))
