"""Damaged, hostile and foreign files: one sentence that names the file, the place and the remedy, nothing else."""

import io
import json
import os
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.errors import ProjectError
from facemodel.io import archive
from facemodel.io.archive import unpack
from facemodel.io.damage import DamageError
from facemodel.io.face_file import read_face
from facemodel.io.npy import npy_array, npy_bytes
from facemodel.io.project_file import load_project, project_bytes, project_of
from tests.io.small_project import identical, small_project

WHOLE = project_bytes(small_project())


def members() -> dict[str, bytes]:
    zipped = zipfile.ZipFile(io.BytesIO(WHOLE))
    return {name: zipped.read(name) for name in zipped.namelist()}


def packed(contents: dict[str, bytes]) -> bytes:
    """A zip whose checksums are right, whatever its members say."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as out:
        for name, data in contents.items():
            out.writestr(name, data)
    return stream.getvalue()


def with_document(change: Callable[[dict[str, Any]], object]) -> bytes:
    contents = members()
    document = json.loads(contents["project.json"])
    change(document)
    return packed(contents | {"project.json": json.dumps(document).encode()})


def with_array(name: str, change: Callable[[np.ndarray], np.ndarray]) -> bytes:
    contents = members()
    array = np.load(io.BytesIO(contents[f"{name}.npy"]))
    return packed(contents | {f"{name}.npy": npy_bytes(change(array))})


def complaint(path: Path, data: bytes) -> str:
    path.write_bytes(data)
    with pytest.raises(ProjectError) as caught:
        load_project(path)
    sentence = str(caught.value)
    assert f"“{path}”" in sentence
    assert sentence.endswith(".")
    assert "\n" not in sentence
    assert "; " in sentence
    return sentence


@given(st.data())
def test_flipped_bits_are_noticed_or_harmless(data: st.DataObject) -> None:
    flipped = bytearray(WHOLE)
    for _ in range(data.draw(st.integers(1, 4))):
        flipped[data.draw(st.integers(0, len(WHOLE) - 1))] ^= data.draw(st.integers(1, 255))
    try:
        project = project_of(bytes(flipped))
    except DamageError:
        return
    assert identical(project, small_project())


@given(st.data())
def test_flipped_bits_under_right_checksums_are_noticed_or_make_a_project(data: st.DataObject) -> None:
    contents = members()
    name = data.draw(st.sampled_from(sorted(contents)))
    flipped = bytearray(contents[name])
    flipped[data.draw(st.integers(0, len(flipped) - 1))] ^= data.draw(st.integers(1, 255))
    try:
        project = project_of(packed(contents | {name: bytes(flipped)}))
    except DamageError:
        return
    assert identical(project_of(project_bytes(project)), project)


@given(st.integers(0, len(WHOLE) - 1))
def test_a_truncated_file_is_noticed(length: int) -> None:
    with pytest.raises(DamageError):
        project_of(WHOLE[:length])


@given(st.binary(max_size=300))
def test_what_is_no_zip_is_noticed(data: bytes) -> None:
    with pytest.raises(DamageError):
        project_of(data)


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=6,
)


def places(value: Any, so_far: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    steps = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [so_far, *(place for key, inner in steps for place in places(inner, (*so_far, key)))]


PLACES = places(json.loads(members()["project.json"]))[1:]


@given(st.sampled_from(PLACES), json_values)
def test_any_value_anywhere_in_the_document_is_refused_or_makes_a_project(place: tuple[Any, ...], value: Any) -> None:
    def put(document: dict[str, Any]) -> None:
        inner: Any = document
        for step in place[:-1]:
            inner = inner[step]
        inner[place[-1]] = value

    try:
        project = project_of(with_document(put))
    except DamageError:
        return
    assert identical(project_of(project_bytes(project)), project)


def test_a_newer_file_asks_for_an_update(tmp_path: Path) -> None:
    data = with_document(lambda d: d.update(schema=3, invention={"a": 1}))
    sentence = complaint(tmp_path / "new.risorius", data)
    assert "newer version" in sentence
    assert "update Risorius" in sentence


@pytest.mark.parametrize(
    ("change", "place", "says"),
    [
        (lambda d: d.update(extra=1), "project.json, extra", "not known"),
        (lambda d: d.pop("units"), "project.json, units", "is missing"),
        (lambda d: d.update(format="zip"), "project.json, format", "another kind of file"),
        (lambda d: d.update(schema="1"), "project.json, schema", "version"),
        (lambda d: d.update(schema=True), "project.json, schema", "version"),
        (lambda d: d.update(schema=0), "project.json, schema", "version"),
        (lambda d: d["muscles"][0].update(kappa=float("nan")), "muscles[0].kappa", "not a finite number"),
        (lambda d: d["muscles"][1]["fibres"][0]["origin"].pop(), "muscles[1].fibres[0].origin[2]", "missing"),
        (lambda d: d["muscles"][0].update(fibres=[]), "muscles[0].fibres", "empty"),
        (lambda d: d["muscles"][2].update(ring=None), "muscles[2].ring", "missing"),
        (lambda d: d["muscles"][2]["ring"].update(long_axis=[0.0, 0.0, 0.0]), "muscles[2].ring", "no ellipse"),
        (lambda d: d["muscles"].__delitem__(slice(2)), "units[0].muscles", "no muscle"),
        (lambda d: d["face"]["eyes"][1].update(radius=3.0), "face.eyes[1].radius", "greater than or equal to 8"),
        (lambda d: d["muscles"].append(d["muscles"][0]), "muscles", "2 times"),
        (lambda d: d["units"].append(d["units"][0]), "units", "2 times"),
        (lambda d: d["units"][0]["muscles"].update(risorius=1.0), "units[0].muscles", "no muscle"),
        (lambda d: d["emotions"][0]["weights"].update({"13": 1.0}), "emotions[0].weights", "no action unit"),
        (lambda d: d["expression"].update({"12": 1.0}), "expression", "no field"),
        (lambda d: d["expression"].update({"12L": "a lot"}), "expression.12L", "valid number"),
        (lambda d: d["settings"].update(density=1000), "settings.density", "less than or equal to 16"),
        (lambda d: d["face"]["landmarks"].update(pronasale=25), "face.landmarks.pronasale", "25 vertices"),
        (lambda d: d["face"]["eyes"].reverse(), "face.eyes", "left"),
        (lambda d: d["face"]["parts"][1].update(name="lashes"), "face.parts", "same name"),
        (lambda d: d["face"]["parts"].pop(), "face/parts/2/anchors.npy", "not part"),
        (lambda d: d["face"]["jaw"].update(axis=[[0.0] * 3] * 2), "face.jaw.axis", "same point"),
    ],
)
def test_a_tampered_document_is_refused_with_its_place(
    tmp_path: Path, change: Callable[[dict[str, Any]], object], place: str, says: str
) -> None:
    sentence = complaint(tmp_path / "face.risorius", with_document(change))
    assert place in sentence
    assert says in sentence


def put(*index: int, value: float) -> Callable[[np.ndarray], np.ndarray]:
    def change(array: np.ndarray) -> np.ndarray:
        array[index] = value
        return array

    return change


@pytest.mark.parametrize(
    ("name", "change", "says"),
    [
        ("face/skin/triangles", put(0, 0, value=25), "25, which is outside 0 to 24"),
        ("face/skin/triangles", put(0, 0, value=-1), "-1, which is outside"),
        ("face/skin/triangles", lambda a: a[:, [0, 1, 1]], "twice in triangle 0"),
        ("face/skin/triangles", lambda a: a.astype(np.float32), "whole numbers"),
        ("face/skin/positions", put(7, 2, value=np.nan), "at [7, 2] is not finite"),
        ("face/skin/positions", put(7, 2, value=1e30), "1e+30"),
        ("face/skin/positions", lambda a: a[:, :2], "shape (25, 2)"),
        ("face/skin/solved", np.zeros_like, "marks nothing"),
        ("face/skin/chart", lambda a: a[1:], "shape (24, 2)"),
        ("face/skull/jawbone", put(3, value=1.5), "1.5 and not in 0 to 1"),
        ("face/layers/stiffness", put(0, value=-1), "-1 and not in 0"),
        ("face/layers/supports", put(0, value=4), "4, which is outside 0"),
        ("face/parts/2/shares", put(0, 0, value=0.5), "sum to one"),
        ("face/parts/2/anchors", lambda a: a[:2], "shape"),
        ("face/parts/0/anchors", lambda a: np.zeros((4, 1), np.int32), "shape"),
    ],
)
def test_a_tampered_array_is_refused_with_its_place(
    tmp_path: Path, name: str, change: Callable[[np.ndarray], np.ndarray], says: str
) -> None:
    sentence = complaint(tmp_path / "face.risorius", with_array(name, change))
    assert says in sentence
    assert "face/" in sentence


def test_a_missing_array_is_named(tmp_path: Path) -> None:
    contents = members()
    del contents["face/skin/uv.npy"]
    assert "face/skin/uv.npy is missing" in complaint(tmp_path / "a.risorius", packed(contents))


def test_a_face_file_is_no_project(tmp_path: Path) -> None:
    contents = members()
    contents["face.json"] = contents.pop("project.json")
    assert "without project.json" in complaint(tmp_path / "a.risorius", packed(contents))


@pytest.mark.parametrize("name", ["../evil.npy", "/etc/passwd", "a\\b.npy", "face/", "C:x.npy", "a.pickle"])
def test_names_that_lead_elsewhere_are_refused(tmp_path: Path, name: str) -> None:
    data = packed(members() | {name: b""})
    assert "name that no Risorius file contains" in complaint(tmp_path / "a.risorius", data)


def test_a_member_that_is_there_twice_is_refused(tmp_path: Path) -> None:
    stream = io.BytesIO(WHOLE)
    with zipfile.ZipFile(stream, "a") as out, pytest.warns(UserWarning, match="Duplicate"):
        out.writestr("project.json", b"{}")
    assert "is there twice" in complaint(tmp_path / "a.risorius", stream.getvalue())


def test_an_encrypted_member_is_refused(tmp_path: Path) -> None:
    data = bytearray(WHOLE)
    directory = data.rindex(b"PK\x01\x02")
    data[directory + 8] |= 1
    assert "is encrypted" in complaint(tmp_path / "a.risorius", bytes(data))


def test_deep_nesting_is_refused(tmp_path: Path) -> None:
    contents = members() | {"project.json": b"[" * 1_000_000 + b"]" * 1_000_000}
    assert "project.json" in complaint(tmp_path / "a.risorius", packed(contents))


def test_keys_that_are_there_twice_are_refused(tmp_path: Path) -> None:
    contents = members()
    contents["project.json"] = contents["project.json"].replace(b"{", b'{"schema": 1, ', 1)
    assert "twice" in complaint(tmp_path / "a.risorius", packed(contents))


def test_a_zip_bomb_is_refused_before_it_is_unpacked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """300 MB of zeros in 300 kB: nothing of it may be unpacked."""
    bomb = packed(members() | {"face/skin/bomb.npy": bytes(250 << 20), "face/skin/bomc.npy": bytes(50 << 20)})
    assert len(bomb) < 1 << 20
    monkeypatch.setattr(archive, "_member", lambda *_: pytest.fail("a member was unpacked"))
    assert "which no face does" in complaint(tmp_path / "a.risorius", bomb)


def test_a_bomb_that_lies_about_its_size_unpacks_no_more_than_it_declares() -> None:
    """The directory says 1000 bytes; the stream behind it would give 100 MB."""
    name = b"face/skin/bomb.npy"
    bomb = packed({"project.json": b"{}", name.decode(): bytes(100 << 20)})
    entry = bomb.rindex(name) - 46
    lied = bomb[: entry + 24] + struct.pack("<I", 1000) + bomb[entry + 28 :]
    with pytest.raises(DamageError, match="bomb"):
        unpack(lied, "project.json")


def test_more_members_than_any_face_has_are_refused(tmp_path: Path) -> None:
    data = packed(members() | {f"face/{k}.npy": b"" for k in range(2001)})
    assert "members" in complaint(tmp_path / "a.risorius", data)


@pytest.mark.parametrize(
    "header",
    [
        "{'descr': '|O', 'fortran_order': False, 'shape': (3, 3), }\n",
        "{'descr': '<f8', 'fortran_order': True, 'shape': (3, 3), }\n",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (99999, 99999), }\n",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (-3, -3), }\n",
        "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }\n",
        "{'descr': [('a', '<f8')], 'fortran_order': False, 'shape': (3, 3), }\n",
        "__import__('os')\n",
        "\n",
    ],
)
def test_array_headers_are_compared_not_evaluated(header: str) -> None:
    data = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + bytes(72)
    with pytest.raises(DamageError, match="trick"):
        npy_array(data, "trick")


def test_pickles_and_other_versions_of_arrays_are_refused() -> None:
    stream = io.BytesIO()
    np.lib.format.write_array(stream, np.array([{"a": 1}], dtype=object), allow_pickle=True)
    with pytest.raises(DamageError):
        npy_array(stream.getvalue(), "pickle")
    stream = io.BytesIO()
    np.lib.format.write_array(stream, np.zeros(3), version=(2, 0))
    with pytest.raises(DamageError):
        npy_array(stream.getvalue(), "version 2")
    with pytest.raises(ValueError, match="not stored"):
        npy_bytes(np.array(["text"]))


@pytest.mark.parametrize("shape", [(0, 0), (0, 3), (3,), (2, 3), (2, 3, 4)])
@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int64, np.int32, np.int8, np.bool_])
def test_arrays_come_back(shape: tuple[int, ...], dtype: type) -> None:
    array = np.arange(np.prod(shape, dtype=int)).reshape(shape).astype(dtype)
    assert identical(npy_array(npy_bytes(array), "array"), array)


def test_arrays_in_another_order_and_byte_order_are_written_plainly() -> None:
    array = np.arange(6.0).reshape(2, 3)
    assert npy_bytes(array.T) == npy_bytes(np.ascontiguousarray(array.T))
    assert npy_bytes(array.astype(">f8")) == npy_bytes(array)


def test_a_missing_file(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="no such file"):
        load_project(tmp_path / "none.risorius")
    with pytest.raises(ProjectError, match="no such file"):
        read_face(tmp_path / "none.face")


def test_a_folder_a_pipe_and_a_name_that_cannot_be(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="is a folder"):
        load_project(tmp_path)
    with pytest.raises(ProjectError, match="cannot be opened"):
        load_project(tmp_path / "nul\0.risorius")
    with pytest.raises(ProjectError, match="name is too long"):
        load_project(tmp_path / ("n" * 300))
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe")
        with pytest.raises(ProjectError, match="a device or a pipe"):
            load_project(tmp_path / "pipe")


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.risorius"
    with open(path, "wb") as stream:
        stream.truncate(archive.LARGEST_ARCHIVE + 1)
    with pytest.raises(ProjectError, match="at most 1024 MiB"):
        load_project(path)
