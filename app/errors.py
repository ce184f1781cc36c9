"""Errors of what a person asks of the editor."""

from __future__ import annotations

from facemodel.errors import RisoriusError


class NumberError(RisoriusError):
    """Text or a value that is no number, or no number that may stand here."""
