"""The command line: ``risorius new, solve, info, render, export, animate, demo, gallery, edit``."""

from __future__ import annotations

from app.cli.main import main
from app.cli.screen import Screen

__all__ = ["Screen", "main"]
