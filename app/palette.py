"""Finding an action by a few of its letters."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from app.actions import Action, Context
from app.actions.edit import set_expression_text
from app.expression_text import parse_expression
from facemodel.errors import RisoriusError

START = 8.0
"""For a letter that begins a word, or follows one that does: “ue” finds “undo edit” before “queue”."""

NEXT = 6.0
"""For any other letter that follows the one before."""

WHOLE = 4.0
"""For ending with the end of a word: “au 2” finds “AU 2” before “AU 22”."""

LETTER = 1.0

SKIP = 0.05
"""Lost for each letter passed over, so that of two equal matches the shorter one is first."""

ASIDE = 0.3
"""What a match in menu or hint is worth beside one in the title."""

NO_MATCH = float("-inf")


@dataclass(frozen=True)
class Match:
    """An action that was found.

    Attributes
    ----------
    action : it
    score : larger is better
    letters : places in its title of the letters that were typed
    """

    action: Action
    score: float
    letters: tuple[int, ...] = ()


def rank(query: str, actions: Sequence[Action]) -> list[Match]:
    """The actions that match every word of the query, best first; all in their order for an empty query.

    A word matches where its letters come one after the other in the title, or where it stands as it is in the menu
    or the hint.  Letters that begin words count most, then letters in a row.
    """
    words = _plain(query).split()
    found = [match for action in actions if (match := _match(words, action)) is not None]
    return sorted(found, key=lambda match: (-match.score, len(match.action.title))) if words else found


def typed_expression(query: str, context: Context) -> Action | None:
    """The action that shows an expression typed as ``12=0.8 1L=50%``; none if the query is no expression."""
    units = context.document.project.units
    try:
        parse_expression(query, units)
    except RisoriusError:
        return None
    text = " ".join(query.split())
    return Action(
        "expression.typed",
        f"Show {text}",
        lambda context: set_expression_text(context, query, text),
        hint="Show this expression and nothing else",
    )


def _match(words: Sequence[str], action: Action) -> Match | None:
    title = _plain(action.title)
    aside = _plain(" ".join((*action.menu, action.hint)))
    total, letters = 0.0, set[int]()
    for word in words:
        score, places = _aligned(word, title)
        in_aside = ASIDE * (START + NEXT * (len(word) - 1)) if word in aside else NO_MATCH
        if max(score, in_aside) == NO_MATCH:
            return None
        if score >= in_aside:
            letters.update(places)
        total += max(score, in_aside)
    return Match(action, total, tuple(sorted(letters)))


@dataclass(frozen=True)
class _Path:
    """The letters found so far: what they are worth, where they stand, whether the last ones begin a word."""

    score: float = 0.0
    places: tuple[int, ...] = ()
    begins: bool = False

    def to(self, place: int, starts: bool) -> _Path:
        """One letter on."""
        follows = bool(self.places) and place == self.places[-1] + 1
        begins = starts or (follows and self.begins)
        worth = START if begins else NEXT if follows else LETTER
        return _Path(self.score + worth, (*self.places, place), begins)


def _aligned(word: str, text: str) -> tuple[float, tuple[int, ...]]:
    """The best way to find the letters of a word in this order in a text: its score and the places."""
    starts = [k == 0 or not text[k - 1].isalnum() for k in range(len(text))]
    paths = {-1: _Path()}
    for letter in word:
        paths = {
            place: max((path.to(place, starts[place]) for path in before), key=_score)
            for place, here in enumerate(text)
            if here == letter and (before := [path for end, path in paths.items() if end < place])
        }
    best: tuple[float, tuple[int, ...]] = (NO_MATCH, ())
    for place, path in paths.items():
        whole = WHOLE if path.begins and not text[place + 1 : place + 2].isalnum() else 0.0
        best = max(best, (path.score + whole - SKIP * (len(text) - len(word)), path.places))
    return best


def _score(path: _Path) -> float:
    return path.score


def _plain(text: str) -> str:
    """Lower case without accents, letter by letter, so that places stay."""
    return "".join(unicodedata.normalize("NFD", letter)[0].lower()[:1] or letter for letter in text)
