"""Errors of what a person asks of the editor."""

from __future__ import annotations

from facemodel.errors import RisoriusError


class NumberError(RisoriusError):
    """Text or a value that is no number, or no number that may stand here."""


class UnitError(RisoriusError):
    """An action unit or emotion cannot be changed as it was asked for; all of them stay as they were."""
