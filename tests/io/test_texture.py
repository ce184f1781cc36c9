"""Layers as pictures and as plain numbers: out, in again, and every way in which a file can be wrong."""

import csv
import json
import struct
import zlib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from facemodel.errors import PaintError, ProjectError, RisoriusError
from facemodel.face import Face, Layers
from facemodel.faces import load_face
from facemodel.io.png import HEADER, SIGNATURE
from facemodel.io.texture import Loss, Span, export_layer, export_tensor, import_layer, import_tensor
from facemodel.io.uv_map import textured_skin
from facemodel.io.vertex_values import export_values, import_values
from facemodel.painting.layers import LAYER, PAINT_LAYERS, PaintLayer
from fem import Support
from fem.types import FloatArray
from tests.io.small_project import small_face

AMOUNTS = [layer for layer in PAINT_LAYERS if layer.kind == "amount"]
GREY = [layer for layer in PAINT_LAYERS if layer.kind != "angle"]


def by_key(layer: PaintLayer) -> str:
    return layer.key


@pytest.fixture(scope="module")
def face() -> Face:
    """Return the default face with lively layers."""
    plain = load_face("ada")
    x, y, _ = plain.skin.positions.T
    waves = np.column_stack([np.sin(x / 15), np.cos(y / 17), np.sin((x + y) / 20)])
    layers = Layers(
        direction=plain.layers.direction,
        stretching=0.4 + 0.2 * waves[:, :2],
        bending=1.0 + 0.5 * waves,
        stiffness=0.01 + 0.005 * waves[:, 0],
        thickness=10.0 + 4.0 * waves[:, 1],
        sliding=20.0 + 10.0 * waves[:, 2],
        volume=0.05 + 0.04 * waves[:, 0],
        supports=((y // 20).astype(np.int64) % len(Support)).astype(plain.layers.supports.dtype),
    )
    angles = 60 * np.sin(y / 30)
    lively = replace(plain, layers=layers)
    return replace(lively, layers=LAYER["grain"].delta(lively, np.arange(len(x)), angles).done(layers))


@pytest.fixture(scope="module")
def bare(face: Face) -> Face:
    """Return the same face with layers of other values everywhere."""
    count = len(face.skin.positions)
    empty = Layers(
        direction=np.tile([0.0, 0.0, 1.0], (count, 1)),
        stretching=np.full((count, 2), 1.9),
        bending=np.full((count, 3), 9.0),
        stiffness=np.full(count, 0.09),
        thickness=np.full(count, 39.0),
        sliding=np.full(count, 150.0),
        volume=np.full(count, 0.4),
        supports=face.layers.supports * 0,
    )
    return replace(face, layers=empty)


def read_back(bare: Face, layer: PaintLayer, path: Path, span: Span | None = None) -> FloatArray:
    return layer.values(replace(bare, layers=import_layer(bare, layer, path, span).done(bare.layers)))


@pytest.mark.parametrize("bits", [8, 16])
@pytest.mark.parametrize("layer", AMOUNTS, ids=by_key)
def test_what_goes_out_comes_in_within_a_step(
    tmp_path: Path, face: Face, bare: Face, layer: PaintLayer, bits: int
) -> None:
    """But for the few vertices that the export itself names, in lids and nostrils, where many share a texel."""
    path = tmp_path / "layer.png"
    loss = export_layer(face, layer, path, 2048, bits)  # type: ignore[arg-type]
    found, expected = read_back(bare, layer, path), layer.values(face)
    drawn = textured_skin(face).vertices
    step = (layer.high - layer.low) / (2**bits - 1)
    off = drawn[np.abs(found - expected)[drawn] > step]
    assert np.array_equal(off, loss.vertices)
    assert len(off) < (0.005 if bits == 8 else 0.03) * len(drawn)
    assert np.abs(found - expected)[drawn].max() == pytest.approx(loss.worst * (layer.high - layer.low))


@pytest.mark.parametrize("bits", [8, 16])
@pytest.mark.parametrize("layer", PAINT_LAYERS, ids=by_key)
def test_on_a_coarse_sheet_everything_comes_back(tmp_path: Path, layer: PaintLayer, bits: int) -> None:
    """The small face covers the whole picture, and no two of its vertices share a texel."""
    sheet = small_face()
    rng = np.random.default_rng(2)
    values = rng.uniform(layer.low, layer.high, len(sheet.skin.positions))
    painted = replace(
        sheet,
        layers=layer.delta(sheet, np.arange(len(values)), values).done(sheet.layers),
    )
    loss = export_layer(painted, layer, tmp_path / "layer.png", 64, bits)  # type: ignore[arg-type]
    assert len(loss.vertices) == 0
    found, expected = read_back(sheet, layer, tmp_path / "layer.png"), layer.values(painted)
    away = np.abs(found - expected)
    if layer.kind == "choice":
        assert np.array_equal(found, expected)
    elif layer.kind == "angle":
        assert np.minimum(away, 180 - away).max() < 0.5, "eight bits of a vector"
    else:
        assert away.max() <= 0.501 * (layer.high - layer.low) / (2**bits - 1)


def test_the_picture_is_the_layer_between_the_vertices(tmp_path: Path) -> None:
    """Linear in the triangles: a plane stays a plane; v points up, row 0 is the top."""
    sheet = small_face()
    x, y, _ = sheet.skin.positions.T
    values = 0.05 + 0.0005 * x + 0.0003 * y
    sheet = replace(sheet, layers=replace(sheet.layers, stiffness=values))
    export_layer(sheet, LAYER["stiffness"], tmp_path / "plane.png", 64, 16)
    with Image.open(tmp_path / "plane.png") as image:
        assert image.mode == "I;16"
        found = np.asarray(image) / 65535 * 0.1
    column, row = np.meshgrid(np.arange(64), np.arange(64))
    expected = 0.05 + 0.0005 * 80 * ((column + 0.5) / 64 - 0.5) + 0.0003 * 80 * (0.5 - (row + 0.5) / 64)
    inner = slice(1, -1)  # vertices on the very rim of the picture are read from its outermost texels
    assert found[inner, inner] == pytest.approx(expected[inner, inner], abs=2e-5)


def test_colour_goes_on_over_the_seams_and_no_farther(tmp_path: Path, face: Face) -> None:
    even = replace(face, layers=replace(face.layers, stiffness=np.full(len(face.uv), 0.1)))
    export_layer(even, LAYER["stiffness"], tmp_path / "even.png", 512, 8)
    with Image.open(tmp_path / "even.png") as image:
        picture = np.asarray(image)
    skin = textured_skin(face)
    at = np.column_stack([(1 - skin.uv[skin.vertices, 1]) * 512, skin.uv[skin.vertices, 0] * 512]).astype(int)
    for step in ([0, 6], [6, 0], [0, -6], [-6, 0]):
        row, column = (at + step).clip(0, 511).T
        assert np.all(picture[row, column] == 255)
    assert picture[256, 20] == 0
    assert set(np.unique(picture)) == {0, 255}


def test_vertices_without_a_place_of_their_own_keep_their_values(tmp_path: Path, face: Face, bare: Face) -> None:
    """The neck was added to the head and borrows its texture coordinates."""
    drawn = textured_skin(face).vertices
    others = np.setdiff1d(np.arange(len(face.uv)), drawn)
    assert 100 < len(others) < 300
    assert face.skin.positions[others, 1].max() < 0
    for layer in PAINT_LAYERS:
        export_layer(face, layer, tmp_path / "layer.png", 256)
        delta = import_layer(bare, layer, tmp_path / "layer.png")
        assert not np.isin(delta.vertices, others).any()


def test_no_place_in_the_picture_belongs_to_two_triangles(face: Face) -> None:
    skin = textured_skin(face)
    low, high = face.uv[skin.vertices].min(axis=0), face.uv[skin.vertices].max(axis=0)
    points = np.random.default_rng(0).uniform(low, high, size=(1000, 1, 2))
    corners = face.uv[skin.triangles].transpose(1, 0, 2)
    inside = np.ones((len(points), len(skin.triangles)), dtype=bool)
    for start, end in ((0, 1), (1, 2), (2, 0)):
        along, to = corners[end] - corners[start], points - corners[start]
        inside &= along[:, 0] * to[..., 1] - along[:, 1] * to[..., 0] > 0
    count = inside.sum(axis=1)
    assert count.max() == 1
    assert 0.6 < count.mean() < 0.95, "the face fills most of its box"


def test_a_span_tells_what_black_and_white_mean(tmp_path: Path, face: Face, bare: Face) -> None:
    layer, span = LAYER["stiffness"], Span(0.004, 0.02)
    export_layer(face, layer, tmp_path / "narrow.png", 2048, 8, span)
    drawn = textured_skin(face).vertices
    noted = read_back(bare, layer, tmp_path / "narrow.png")[drawn]
    assert np.percentile(np.abs(noted - face.layers.stiffness[drawn]), 99) < (span.high - span.low) / 255
    with Image.open(tmp_path / "narrow.png") as image:
        assert json.loads(image.text["risorius"]) == {
            "layer": "stiffness",
            "unit": "N/mm³",
            "low": 0.004,
            "high": 0.02,
        }
        image.save(tmp_path / "stripped.png", pnginfo=None)
    whole = read_back(bare, layer, tmp_path / "stripped.png")[drawn]
    asked = read_back(bare, layer, tmp_path / "stripped.png", span)[drawn]
    assert np.array_equal(asked, noted)
    assert whole == pytest.approx((noted - 0.004) / 0.016 * 0.1)


def test_a_span_that_does_not_hold_all_values_is_refused(tmp_path: Path, face: Face) -> None:
    with pytest.raises(PaintError, match=r"“Tissue stiffness” holds .* outside 0 to 0.01; choose a span"):
        export_layer(face, LAYER["stiffness"], tmp_path / "x.png", 64, 8, Span(0.0, 0.01))
    with pytest.raises(PaintError, match="is no span"):
        Span(1.0, 1.0)
    assert not (tmp_path / "x.png").exists()


def tensors(layers: Layers, face: Face) -> FloatArray:
    """Return level, upright and mixed entries (N, 3) of the stretching tensors."""
    angle = np.radians(LAYER["grain"].values(replace(face, layers=layers)))
    (along, across), c, s = layers.stretching.T, np.cos(angle), np.sin(angle)
    return np.column_stack([along * c**2 + across * s**2, along * s**2 + across * c**2, (along - across) * c * s])


def test_a_tensor_comes_back_with_its_axes(tmp_path: Path, face: Face) -> None:
    loss = export_tensor(face, tmp_path / "tensor.png", 2048)
    blurred = replace(face.layers, stretching=np.full_like(face.layers.stretching, 1.0))
    stretching, direction = import_tensor(replace(face, layers=blurred), tmp_path / "tensor.png")
    found = direction.done(stretching.done(blurred))
    good = np.setdiff1d(textured_skin(face).vertices, loss.vertices)
    step = LAYER["stretching-along"].high / 255
    assert np.abs(tensors(found, face) - tensors(face.layers, face))[good].max() < 2.5 * step, "flat ones included"
    marked = good[np.abs(np.diff(face.layers.stretching[good], axis=1))[:, 0] > 10 * step]
    assert len(marked) > 500
    assert np.abs(found.stretching - face.layers.stretching)[marked].max() < 3 * step, "along stays along"
    assert len(loss.vertices) < 0.02 * len(good)
    assert found.bending is face.layers.bending


def test_where_a_tensor_has_no_direction_the_grain_stays(tmp_path: Path, face: Face) -> None:
    even = replace(face, layers=replace(face.layers, stretching=np.full((len(face.uv), 2), 0.4)))
    export_tensor(even, tmp_path / "even.png", 256)
    stretching, direction = import_tensor(face, tmp_path / "even.png")
    assert len(direction) == 0
    assert stretching.after == pytest.approx(0.4, abs=2 / 255)


def test_what_is_transparent_is_not_read(tmp_path: Path, face: Face) -> None:
    export_tensor(face, tmp_path / "tensor.png", 256)
    with Image.open(tmp_path / "tensor.png") as image:
        texels = np.array(image)
    texels[:128, :, 3] = 0
    Image.fromarray(texels).save(tmp_path / "half.png")
    stretching, _ = import_tensor(face, tmp_path / "half.png")
    assert np.all(face.uv[stretching.vertices, 1] < 0.51)


def test_grey_says_nothing_about_the_grain(tmp_path: Path, face: Face) -> None:
    Image.new("RGB", (64, 64), (128, 127, 128)).save(tmp_path / "grey.png")
    assert len(import_layer(face, LAYER["grain"], tmp_path / "grey.png")) == 0


def test_pictures_of_other_programs_are_read(tmp_path: Path, face: Face) -> None:
    """Without a note, not square, not a power of two."""
    Image.new("L", (100, 60), 51).save(tmp_path / "plain.png")
    delta = import_layer(face, LAYER["bending-twist"], tmp_path / "plain.png")
    assert delta.after[:, 2] == pytest.approx(0.2 * LAYER["bending-twist"].high)
    assert np.array_equal(delta.after[:, :2], delta.before[:, :2])
    Image.new("RGB", (100, 60), (0, 127, 0)).save(tmp_path / "upright.png")
    upright = import_layer(face, LAYER["grain"], tmp_path / "upright.png").done(face.layers)
    found = LAYER["grain"].values(replace(face, layers=upright))[textured_skin(face).vertices]
    assert np.abs(np.abs(found) - 90).max() < 0.5


PICTURES = {
    "rgb": Image.new("RGB", (64, 64)),
    "rgba": Image.new("RGBA", (64, 64)),
    "palette": Image.new("P", (64, 64)),
    "bits": Image.new("1", (64, 64)),
    "grey-alpha": Image.new("LA", (64, 64)),
    "small": Image.new("L", (8, 64)),
    "large": Image.new("L", (9000, 16)),
}


@pytest.mark.parametrize(
    ("kind", "says"),
    [
        ("rgb", "it is RGB with 8 bits, and grey with 8 or 16 bits per channel is needed"),
        ("rgba", "it is RGBA with 8 bits"),
        ("palette", "it is palette with "),
        ("bits", "it is grey with 1 bits"),
        ("grey-alpha", "it is grey with alpha with 8 bits"),
        ("small", "it has 8 x 64 texels; resize it to between 16 and 8192"),
        ("large", "it has 9000 x 16 texels"),
    ],
)
def test_a_picture_of_the_wrong_kind_is_refused_in_one_sentence(
    tmp_path: Path, face: Face, kind: str, says: str
) -> None:
    PICTURES[kind].save(tmp_path / "picture.png")
    with pytest.raises(ProjectError) as caught:
        import_layer(face, LAYER["stiffness"], tmp_path / "picture.png")
    sentence = str(caught.value)
    assert sentence.startswith(f"“{tmp_path / 'picture.png'}” cannot be used for the layer “Tissue stiffness”: ")
    assert says in sentence
    assert sentence.count("\n") == 0


def test_a_grey_picture_is_no_grain(tmp_path: Path, face: Face) -> None:
    Image.new("L", (64, 64)).save(tmp_path / "grey.png")
    for read in (lambda p: import_layer(face, LAYER["grain"], p), lambda p: import_tensor(face, p)):
        with pytest.raises(ProjectError, match="RGB or RGBA with 8 bits per channel is needed"):
            read(tmp_path / "grey.png")


def test_a_picture_of_another_unit_is_refused(tmp_path: Path, face: Face) -> None:
    export_layer(face, LAYER["stiffness"], tmp_path / "stiffness.png", 64)
    with pytest.raises(ProjectError, match="was exported from “stiffness”, whose unit is “N/mm³” and not “N mm”"):
        import_layer(face, LAYER["bending-along"], tmp_path / "stiffness.png")
    export_layer(face, LAYER["bending-along"], tmp_path / "along.png", 64)
    assert len(import_layer(face, LAYER["bending-across"], tmp_path / "along.png")), "the same unit may be taken over"


def test_values_beyond_the_range_are_refused(tmp_path: Path, face: Face) -> None:
    Image.new("L", (64, 64), 200).save(tmp_path / "light.png")
    with pytest.raises(PaintError, match=r"outside 0 to 0.1; paint it within this range"):
        import_layer(face, LAYER["stiffness"], tmp_path / "light.png", Span(0.0, 1.0))


def test_what_is_no_picture_is_refused(tmp_path: Path, face: Face) -> None:
    for name, data in (("empty.png", b""), ("text.png", b"hello" * 20), ("gif.png", b"GIF89a" + bytes(100))):
        (tmp_path / name).write_bytes(data)
        with pytest.raises(ProjectError, match="is not a PNG picture"):
            import_layer(face, LAYER["stiffness"], tmp_path / name)
    with pytest.raises(ProjectError, match="no such file"):
        import_layer(face, LAYER["stiffness"], tmp_path / "nothing.png")
    with pytest.raises(ProjectError, match="a folder"):
        import_layer(face, LAYER["stiffness"], tmp_path)


def test_a_picture_that_promises_more_than_it_holds_is_refused(tmp_path: Path, face: Face) -> None:
    header = struct.pack(">IIBBBBB", 4096, 4096, 8, 0, 0, 0, 0)
    chunk = b"IHDR" + header
    data = SIGNATURE + struct.pack(">I", 13) + chunk + struct.pack(">I", zlib.crc32(chunk))
    assert len(data) > HEADER.size
    (tmp_path / "bomb.png").write_bytes(data)
    with pytest.raises(ProjectError, match="the picture is damaged"):
        import_layer(face, LAYER["stiffness"], tmp_path / "bomb.png")


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.tuples(st.integers(0, 10_000), st.integers(0, 255)), min_size=1, max_size=4), st.integers(0, 2000))
def test_damage_is_told_or_harmless(tmp_path: Path, flips: list[tuple[int, int]], cut: int) -> None:
    sheet = small_face()
    path = tmp_path / "layer.png"
    export_layer(sheet, LAYER["stiffness"], path, 32, 16)
    data = bytearray(path.read_bytes())
    for place, byte in flips:
        data[place % len(data)] = byte
    path.write_bytes(data[: len(data) - cut] if cut < len(data) else data)
    try:
        delta = import_layer(sheet, LAYER["stiffness"], path)
    except RisoriusError:
        return
    assert np.isfinite(delta.after).all()


@pytest.mark.parametrize("text", ["{", "[]", '{"layer": "stiffness"}', '{"low": 1, "high": 0, "layer": 1, "unit": ""}'])
def test_a_damaged_note_is_told(tmp_path: Path, face: Face, text: str) -> None:
    image = Image.new("L", (64, 64))
    info = PngInfo()
    info.add_text("risorius", text)
    image.save(tmp_path / "noted.png", pnginfo=info)
    with pytest.raises(ProjectError, match="its note “risorius” is damaged"):
        import_layer(face, LAYER["stiffness"], tmp_path / "noted.png")


@pytest.mark.parametrize("size", [0, 15, 8193])
def test_an_impossible_size_is_refused(tmp_path: Path, size: int) -> None:
    with pytest.raises(PaintError, match=f"A picture of {size} texels is not possible"):
        export_layer(small_face(), LAYER["stiffness"], tmp_path / "x.png", size)


def test_a_face_without_texture_coordinates_is_told(tmp_path: Path) -> None:
    sheet = small_face()
    nowhere = replace(sheet, uv=np.zeros_like(sheet.uv))
    with pytest.raises(PaintError, match="has no texture coordinates of its own"):
        export_layer(nowhere, LAYER["stiffness"], tmp_path / "x.png", 64)


def test_the_picture_of_a_few_texels_names_what_it_loses(tmp_path: Path, face: Face) -> None:
    loss: Loss = export_layer(face, LAYER["stretching-along"], tmp_path / "tiny.png", 128, 8)
    assert len(loss.vertices) > 100
    assert 2 / 255 < loss.worst <= 1.0


@pytest.mark.parametrize("suffix", [".npy", ".csv"])
@pytest.mark.parametrize("layer", PAINT_LAYERS, ids=by_key)
def test_numbers_come_back_exactly(tmp_path: Path, face: Face, bare: Face, layer: PaintLayer, suffix: str) -> None:
    path = tmp_path / f"values{suffix}"
    export_values(face, layer, path)
    found = import_values(bare, layer, path).done(bare.layers)
    expected = layer.values(face)
    if layer.kind == "angle":
        assert layer.values(replace(bare, layers=found)) == pytest.approx(expected, abs=1e-9)
    else:
        assert np.array_equal(layer.values(replace(bare, layers=found)), expected)
    assert len(import_values(face, layer, path)) == 0


def test_a_table_can_be_read_by_anyone_and_may_name_a_few(tmp_path: Path, face: Face) -> None:
    path = tmp_path / "values.csv"
    export_values(face, LAYER["stiffness"], path)
    with path.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["stiffness [N/mm³]"]) for row in rows] == face.layers.stiffness.tolist()
    path.write_text("vertex,stiffness\n7,0.05\n\n3,0.06\n")
    delta = import_values(face, LAYER["stiffness"], path)
    assert dict(zip(delta.vertices.tolist(), delta.after.tolist(), strict=True)) == {3: 0.06, 7: 0.05}


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "the table names no vertex"),
        ("vertex,value\n", "the table names no vertex"),
        ("7,0.05\n", "line 1 is not a heading"),
        ("vertex,value\n7\n", "line 2 is not a vertex and a value"),
        ("vertex,value\nx,1\n", "line 2 is not a vertex and a value"),
        ("vertex,value\n1,x\n", "line 2 is not a vertex and a value"),
        ("vertex,value\n1,nan\n", "line 2 holds no finite number"),
        ("vertex,value\n1,0.01\n1,0.01\n", "line 3 names vertex 1 a second time"),
        ("vertex,value\n99999,0.01\n", "line 2 names vertex 99999, and the skin has 0 to"),
        ("vertex,value\n1,5\n", "outside 0 to 0.1; correct the file"),
        ("vertex,value\n1," + "9" * 200_000 + "\n", "is not a table"),
    ],
)
def test_a_wrong_table_is_told_with_its_place(tmp_path: Path, face: Face, text: str, says: str) -> None:
    path = tmp_path / "values.csv"
    path.write_text(text)
    with pytest.raises(RisoriusError, match=says):
        import_values(face, LAYER["stiffness"], path)


def test_a_wrong_array_is_told(tmp_path: Path, face: Face) -> None:
    path = tmp_path / "values.npy"
    count = len(face.uv)
    for array, says in (
        (np.zeros(3), r"has the shape \(3,\) and not"),
        (np.full(count, np.nan), "at 0 is not a finite number"),
        (np.full(count, 7.0), "outside 0 to 0.1"),
    ):
        np.save(path, array)
        with pytest.raises(RisoriusError, match=says):
            import_values(face, LAYER["stiffness"], path)
    path.write_bytes(b"no array")
    with pytest.raises(ProjectError, match="is not an array file"):
        import_values(face, LAYER["stiffness"], path)
    with pytest.raises(ProjectError, match=r"values per vertex are in .npy or .csv files"):
        export_values(face, LAYER["stiffness"], tmp_path / "values.txt")
