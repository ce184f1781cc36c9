"""Expressions as text, to be copied and pasted: ``12L=0.8 12R=0.8 17=0.25``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from app.arithmetic import evaluate
from app.errors import NumberError
from app.intensity import parse_code
from facemodel.actions import ActionUnit, Expression, field_names, resolve

NEUTRAL = "neutral"
SCORE = re.compile(r"\s*[LR]?\d+[LR]?([A-E]\s*(\+|$)|\s*\+)", re.IGNORECASE)
PAIR = re.compile(r"\s*([^=]+?)\s*[=:]\s*([^\s;=]+?)(?:[\s;]+|,(?=\s|$)|$)")


def format_expression(expression: Expression, units: Sequence[ActionUnit]) -> str:
    """The weights in the order of the units, so exactly that `parse_expression` returns the same."""
    order = {name: place for place, name in enumerate(field_names(units))}
    active = sorted((name for name in expression if expression[name] != 0), key=lambda n: order.get(n, len(order)))
    return " ".join(f"{name}={expression[name]!r}" for name in active) or NEUTRAL


def parse_expression(text: str, units: Sequence[ActionUnit]) -> dict[str, float]:
    """Weights by field from pairs such as ``12=0.8``, ``AU1L=50%`` or ``lip corner puller R = 1/2``.

    Pairs are separated by white space, semicolons or commas; a later one overrides an earlier one.  A text without
    pairs may be a score of FACS, such as ``1B+2C+L12D``.

    Raises
    ------
    UnknownNameError
        If a name is no action unit.
    NumberError
        If a weight is no number, or the text is not made of such pairs.
    """
    if text.strip().lower() == NEUTRAL:
        return {}
    if "=" not in text and ":" not in text and SCORE.match(text):
        return parse_code(text, units)
    weights: dict[str, float] = {}
    place = 0
    while text[place:].strip():
        pair = PAIR.match(text, place)
        if pair is None:
            shown = " ".join(text[place:].split())[:30]
            raise NumberError(f"“{shown}” is no expression; write pairs such as 12=0.8 1L=50%.")
        for name in resolve(pair[1], units):
            weights[name] = evaluate(pair[2])
        place = pair.end()
    if not weights:
        raise NumberError("There is no expression in the text; write pairs such as 12=0.8 1L=50%.")
    return weights
