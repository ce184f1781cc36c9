"""Arithmetic in number fields: ``0.5+0.1``, ``80%``, ``1/3``, ``-(2 - 0,5)``."""

from __future__ import annotations

import math
import re

from app.errors import NumberError

LONGEST = 200
"""Characters; keeps nested parentheses within Python's own recursion."""

TOKEN = re.compile(r"\s*((?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?|\S)")
DIGITS = frozenset("0123456789")
SPELLINGS = str.maketrans({"−": "-", "–": "-", "×": "*", "·": "*", "÷": "/"})


def evaluate(text: str) -> float:
    """Value of numbers joined by ``+ - * /``, parentheses and a trailing ``%``; ``0,5`` is ``0.5``.

    Raises
    ------
    NumberError
        If the text is anything else, or its value is not finite.
    """
    if not text.strip():
        raise NumberError("The field is empty; type a number such as 0.5 or 80%.")
    if len(text) > LONGEST:
        raise NumberError(f"“{text[:20]}…” is too long for a number; use at most {LONGEST} characters.")
    reader = _Reader(text)
    value = reader.sum()
    reader.expect_end()
    if not math.isfinite(value):
        raise NumberError(f"“{text.strip()}” has no finite value; type a number such as 0.5 or 80%.")
    return value


class _Reader:
    """Recursive descent over the tokens of one text."""

    def __init__(self, text: str) -> None:
        self._text = text.strip()
        self._tokens = TOKEN.findall(text.translate(SPELLINGS))
        self._next = 0

    def sum(self) -> float:
        value = self._product()
        while (sign := self._take("+", "-")) is not None:
            term = self._product()
            value = value + term if sign == "+" else value - term
        return value

    def expect_end(self) -> None:
        if self._next < len(self._tokens):
            raise self._wrong()

    def _product(self) -> float:
        value = self._signed()
        while (sign := self._take("*", "/")) is not None:
            factor = self._signed()
            if sign == "*":
                value *= factor
            else:
                value = value / factor if factor else math.nan
        return value

    def _signed(self) -> float:
        sign = self._take("+", "-")
        if sign is not None:
            return -self._signed() if sign == "-" else self._signed()
        return self._percent()

    def _percent(self) -> float:
        value = self._number()
        while self._take("%") is not None:
            value /= 100
        return value

    def _number(self) -> float:
        if self._take("(") is not None:
            value = self.sum()
            if self._take(")") is None:
                raise self._wrong()
            return value
        token = self._peek()
        if DIGITS.isdisjoint(token):
            raise self._wrong()
        self._next += 1
        return float(token.replace(",", "."))

    def _peek(self) -> str:
        return self._tokens[self._next] if self._next < len(self._tokens) else ""

    def _take(self, *tokens: str) -> str | None:
        token = self._peek()
        if token not in tokens:
            return None
        self._next += 1
        return token

    def _wrong(self) -> NumberError:
        where = f"at “{self._peek()}”" if self._peek() else "at its end"
        return NumberError(f"“{self._text}” is not a number {where}; use digits, + - * / ( ) and %.")
