"""The difference between two ordered collections of named values: those that changed, came and went, and the order."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Generic, TypeVar

Item = TypeVar("Item")

Order = tuple[str, ...]


@dataclass(frozen=True, eq=False)
class KeyedDelta(Generic[Item]):
    """What turns one collection into another, and back.

    Attributes
    ----------
    before : by name, the values that are replaced or taken out
    after : by name, the values that replace them or are put in
    orders : all names before and after; none if the same ones stand in the same order
    """

    before: Mapping[str, Item] = field(default_factory=dict)
    after: Mapping[str, Item] = field(default_factory=dict)
    orders: tuple[Order, Order] | None = None

    @property
    def changes(self) -> bool:
        """Whether anything is different."""
        return bool(self.before or self.after) or self.orders is not None

    @property
    def touched(self) -> frozenset[str]:
        """Names of the values that are not as they were."""
        return frozenset(self.before) | frozenset(self.after)

    def do(self, items: tuple[Item, ...], name_of: Callable[[Item], str]) -> tuple[Item, ...]:
        """The collection as it is after."""
        return _arranged(items, name_of, self.after, self.orders[1] if self.orders else None)

    def undo(self, items: tuple[Item, ...], name_of: Callable[[Item], str]) -> tuple[Item, ...]:
        """The collection as it was before."""
        return _arranged(items, name_of, self.before, self.orders[0] if self.orders else None)

    def then(self, later: KeyedDelta[Item]) -> KeyedDelta[Item]:
        """Both differences as one; a value that comes back to what it was is in it no more."""
        before = {**{n: item for n, item in later.before.items() if n not in self.touched}, **self.before}
        after = {**{n: item for n, item in self.after.items() if n not in later.touched}, **later.after}
        same = {name for name in before if after.get(name) is before[name]}
        first, last = self.orders or later.orders, later.orders or self.orders
        orders = (first[0], last[1]) if first and last and first[0] != last[1] else None
        return KeyedDelta(
            {name: item for name, item in before.items() if name not in same},
            {name: item for name, item in after.items() if name not in same},
            orders,
        )


def keyed_delta(before: tuple[Item, ...], after: tuple[Item, ...], name_of: Callable[[Item], str]) -> KeyedDelta[Item]:
    """The difference between two collections of frozen values, in which every name stands once."""
    old, new = ({name_of(item): item for item in items} for items in (before, after))
    moved = {name for name in (*old, *new) if old.get(name) is not new.get(name)}
    orders = None if tuple(old) == tuple(new) else (tuple(old), tuple(new))
    return KeyedDelta(
        {name: item for name, item in old.items() if name in moved},
        {name: item for name, item in new.items() if name in moved},
        orders,
    )


def _arranged(
    items: tuple[Item, ...], name_of: Callable[[Item], str], put: Mapping[str, Item], order: Order | None
) -> tuple[Item, ...]:
    standing = {**{name_of(item): item for item in items}, **put}
    return tuple(standing[name] for name in (map(name_of, items) if order is None else order))
