"""Solutions by content: another face is another key, a damaged entry is none, and a bad disk costs only time."""

import os
import time
from collections.abc import Callable
from dataclasses import fields, is_dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from facemodel.actions import JawMotion
from facemodel.cache import (
    ABANDONED,
    KEPT,
    cached_solution,
    keep_solution,
    solution_key,
    solve_cached,
)
from facemodel.face import Face
from facemodel.folders import cache_folder
from facemodel.project import Project, Settings
from facemodel.solve import Solution, solve_project
from tests.app.conftest import small_project

SMALL = small_project()


@pytest.fixture(scope="module")
def solved() -> Solution:
    return solve_project(SMALL)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("RISORIUS_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def entries(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.npz"))


def same(one: Solution, other: Solution) -> bool:
    """Return whether two solutions agree to the last bit, display and figures included."""

    def pieces(value: object) -> list[object]:
        if is_dataclass(value):
            return [piece for each in fields(value) for piece in pieces(getattr(value, each.name))]
        return [value]

    return all(
        a.dtype == b.dtype and np.array_equal(a, b) if isinstance(a, np.ndarray) else a == b
        for a, b in zip(pieces(one), pieces(other), strict=True)
    )


def test_what_is_kept_comes_back_to_the_last_bit(folder: Path, solved: Solution) -> None:
    assert cached_solution(SMALL) is None
    assert keep_solution(SMALL, solved)
    found = cached_solution(SMALL)
    assert found is not None
    assert same(found, solved)
    assert [path.suffix for path in folder.iterdir()] == [".npz"]


def test_it_is_solved_once(folder: Path) -> None:
    told: list[tuple[str, float]] = []
    first = solve_cached(SMALL, lambda text, share: told.append((text, share)))
    assert any("Factorising" in text for text, _ in told)
    told.clear()
    second = solve_cached(SMALL, lambda text, share: told.append((text, share)))
    assert told == [("Read 6 fields from the cache", 1.0)]
    assert same(first, second)


def nudged(face: Face, place: str) -> Face:
    """Return the face with one number of one array changed by its last bit."""
    *outer, name = place.split(".")
    holder: object = face
    for step in outer:
        holder = getattr(holder, step)
    array = getattr(holder, name).copy()
    flat = array.reshape(-1)
    flat[0] = ~flat[0] if array.dtype == bool else flat[0] + 1 if array.dtype.kind in "iu" else np.nextafter(flat[0], 9)
    changed = replace(holder, **{name: array})  # type: ignore[type-var]
    for depth in range(len(outer) - 1, -1, -1):
        holder = face
        for step in outer[:depth]:
            holder = getattr(holder, step)
        changed = replace(holder, **{outer[depth]: changed})  # type: ignore[type-var]
    assert isinstance(changed, Face)
    return changed


@pytest.mark.parametrize(
    "place",
    [
        "skin.positions",
        "skin.triangles",
        "solved",
        "chart",
        "skull.anchors",
        "skull.jawbone",
        "skull.jaw.axis",
        "layers.direction",
        "layers.stretching",
        "layers.bending",
        "layers.stiffness",
        "layers.supports",
    ],
)
def test_the_last_bit_of_any_array_makes_another_face(place: str) -> None:
    assert solution_key(replace(SMALL, face=nudged(SMALL.face, place))) != solution_key(SMALL)


def _first_muscle(**changes: object) -> Callable[[Project], Project]:
    return lambda p: replace(p, muscles=(replace(p.muscles[0], **changes), *p.muscles[1:]))  # type: ignore[arg-type]


def _first_unit(**changes: object) -> Callable[[Project], Project]:
    return lambda p: replace(p, units=(replace(p.units[0], **changes), *p.units[1:]))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "change",
    [
        _first_muscle(strength=0.021),
        _first_muscle(kappa=2.5),
        _first_muscle(count=6),
        _first_muscle(fibres=()),
        _first_unit(muscles={"zygomaticus_major": 1.01}),
        _first_unit(jaw=JawMotion(1.0)),
        _first_unit(paired=False),
        lambda p: replace(p, muscles=p.muscles[:1]),
        lambda p: replace(p, units=p.units[::-1]),
        lambda p: replace(p, settings=Settings(element="hct9")),
        lambda p: replace(p, settings=Settings(density=2)),
    ],
)
def test_any_muscle_unit_or_setting_makes_another_key(change: Callable[[Project], Project]) -> None:
    assert solution_key(change(SMALL)) != solution_key(SMALL)


def test_the_expression_and_the_emotions_make_no_other_key() -> None:
    assert solution_key(SMALL.posed({"12L": 0.7})) == solution_key(SMALL)
    assert solution_key(replace(SMALL, emotions=())) == solution_key(SMALL)


def test_the_same_content_has_the_same_key_whoever_made_it() -> None:
    assert solution_key(small_project()) == solution_key(SMALL)


def test_what_the_key_cannot_read_is_not_passed_over() -> None:
    listed = replace(SMALL, muscles=list(SMALL.muscles))  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="holds a list"):
        solution_key(listed)


def _flip(path: Path) -> None:
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 0xFF
    path.write_bytes(data)


def _truncate(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-1000])


def _forget_a_member(path: Path) -> None:
    with np.load(path) as arrays:
        rest = {name: arrays[name] for name in arrays.files if name != "slopes"}
    np.savez(path, **rest)


@pytest.mark.parametrize(
    "damage",
    [_flip, _truncate, _forget_a_member, lambda path: path.write_bytes(b""), lambda path: path.write_text("PK no zip")],
)
def test_a_damaged_entry_is_none_and_goes(folder: Path, solved: Solution, damage: Callable[[Path], object]) -> None:
    keep_solution(SMALL, solved)
    (entry,) = entries(folder)
    damage(entry)
    assert cached_solution(SMALL) is None
    assert entries(folder) == []
    assert np.array_equal(solve_cached(SMALL).basis.fields, solved.basis.fields)
    assert len(entries(folder)) == 1


def test_a_cache_that_cannot_be_written_costs_only_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, solved: Solution
) -> None:
    in_the_way = tmp_path / "a file"
    in_the_way.write_text("not a folder")
    monkeypatch.setenv("RISORIUS_CACHE", str(in_the_way / "cache"))
    assert keep_solution(SMALL, solved) is False
    assert cached_solution(SMALL) is None
    found = solve_cached(SMALL)
    assert np.array_equal(found.basis.fields, solved.basis.fields)
    assert in_the_way.read_text() == "not a folder"


def test_the_entries_used_longest_ago_go_first(folder: Path, solved: Solution) -> None:
    folder.mkdir()
    for age in range(KEPT + 3):
        old = folder / f"{age:032x}.npz"
        old.write_bytes(b"")
        os.utime(old, (time.time() - 1000 - age,) * 2)
    assert keep_solution(SMALL, solved)
    names = {path.stem for path in entries(folder)}
    assert len(names) == KEPT
    assert solution_key(SMALL) in names
    assert f"{0:032x}" in names
    assert f"{KEPT + 2:032x}" not in names


def test_reading_an_entry_makes_it_young(folder: Path, solved: Solution) -> None:
    keep_solution(SMALL, solved)
    (entry,) = entries(folder)
    os.utime(entry, (1.0, 1.0))
    assert cached_solution(SMALL) is not None
    assert entry.stat().st_mtime > time.time() - 60


def test_what_an_ended_program_left_half_written_is_cleared_away(folder: Path, solved: Solution) -> None:
    folder.mkdir()
    left, growing = folder / "left.part", folder / "growing.part"
    for path in (left, growing):
        path.write_bytes(b"half")
    os.utime(left, (time.time() - ABANDONED - 60,) * 2)
    keep_solution(SMALL, solved)
    assert not left.exists()
    assert growing.exists(), "another program may still be writing it"


def test_the_folder_is_the_users_own_unless_one_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("RISORIUS_CACHE", str(tmp_path))
    assert cache_folder() == tmp_path
    monkeypatch.delenv("RISORIUS_CACHE")
    assert cache_folder().name == "risorius"
