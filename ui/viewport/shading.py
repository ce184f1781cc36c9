"""Materials as short GLSL that replaces VTK's own lighting: light scattered in skin, two layers of shine.

One text serves all surfaces. It reads colour (sRGB) and openness from the vertex colours, works in linear light and
ends with a soft shoulder, so that highlights roll off instead of clipping. On software GL it is faster than VTK's own
lighting with as many lamps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from vtkmodules.vtkRenderingCore import vtkActor

from ui.viewport.lights import FILL, GROUND, KEY, RIM, SKY


class Ghost(Enum):
    """Whether one can look through a surface."""

    SOLID = "fragOutput0 = vec4(seen, opacityUniform);"
    VEIL = "fragOutput0 = vec4(seen, max(0.22 + 0.70 * graze2 * graze, 0.9 * COVER));"
    """Clear where it is seen straight on, dense towards its outline and where it is painted."""
    STRAND = "fragOutput0 = vec4(seen, strandCover());"
    """A hair, see `ui.viewport.strands`."""


@dataclass(frozen=True)
class Material:
    """How a surface takes light.

    Attributes
    ----------
    scatter : how far red, green and blue light creep round the terminator, 0..1
    shine, sharpness : weight and exponent of the broad highlight
    gleam, point : weight and exponent of the small, wet one
    sheen : light gathered at grazing angles
    """

    scatter: tuple[float, float, float] = (0.0, 0.0, 0.0)
    shine: float = 0.1
    sharpness: float = 20.0
    gleam: float = 0.0
    point: float = 200.0
    sheen: float = 0.0


SKIN = Material((0.42, 0.20, 0.13), shine=0.085, sharpness=14.0, gleam=0.05, point=70.0, sheen=0.10)
TOOTH = Material((0.30, 0.26, 0.20), shine=0.05, sharpness=30.0, gleam=0.30, point=260.0)
FLESH = Material((0.35, 0.15, 0.12), shine=0.05, sharpness=20.0, gleam=0.16, point=120.0)
EYE = Material((0.34, 0.26, 0.24), shine=0.03, sharpness=30.0, gleam=0.55, point=700.0)
HAIR = Material((0.2, 0.2, 0.2), shine=0.05, sharpness=30.0)
BONE = Material((0.25, 0.20, 0.15), shine=0.06, sharpness=20.0)
BAND = Material((0.30, 0.18, 0.15), shine=0.10, sharpness=24.0, gleam=0.10, point=90.0)
MATTE = Material(shine=0.02, sharpness=8.0)


def _vec(values: tuple[float, ...]) -> str:
    return f"vec3({', '.join(f'{v:.5f}' for v in values)})"


ATTRIBUTES = {"paint": "vec4", "fold": "float"}
"""What points can carry besides: paint, and how deep their furrows are."""


def _functions(material: Material, carried: Sequence[str]) -> str:
    m = material
    declared = "".join(f"in {ATTRIBUTES[name]} {name}VSOutput;\n" for name in carried)
    return f"""{declared}
const vec3 scatterOf = {_vec(m.scatter)};
vec3 lit(vec3 n, vec3 l, float open)
{{
  float c = dot(n, l);
  vec3 d = clamp((c + scatterOf) / (1.0 + scatterOf), 0.0, 1.0);
  float shade = clamp(c + 2.2 * open * open - 0.35, 0.0, 1.0) * min(3.0 * open, 1.0);
  vec3 bled = shade + scatterOf * (1.5 * shade * (1.0 - shade));
  return d * mix(d, vec3(1.0), 0.5) * bled;
}}
float shineOf(vec3 n, vec3 v, vec3 l)
{{
  float h = max(dot(n, normalize(l + v)), 0.0);
  float broad = {m.shine:.5f} * exp2({m.sharpness * 1.4427:.3f} * (h - 1.0));
  float small = {m.gleam:.5f} * exp2({m.point * 1.4427:.3f} * (h - 1.0));
  return (broad + small) * smoothstep(-0.05, 0.25, dot(n, l));
}}
"""


FRAME = """
  vec3 n = normalVCVSOutput;
  vec3 v = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  float graze = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  float graze2 = graze * graze;
"""

LIGHTING = f"""{FRAME}
  vec3 albedo = diffuseColor * diffuseColor;
  float open = OPENNESS;
  float gloss = 1.0;
  DETAIL
  vec3 shaded = mix(vec3(open), vec3(open * (1.6 - 0.6 * open), open, open * 0.97), scatterOf.r);
  vec3 around = mix({_vec(GROUND)}, {_vec(SKY)}, 0.5 + 0.5 * n.y);
  vec3 light = around * shaded
    + lit(n, {_vec(KEY.direction)}, open) * {_vec(KEY.colour)}
    + lit(n, {_vec(FILL.direction)}, open) * {_vec(FILL.colour)}
    + lit(n, {_vec(RIM.direction)}, open) * {_vec(RIM.colour)} * smoothstep(0.40, 0.85, graze);
  vec3 shine = (shineOf(n, v, {_vec(KEY.direction)}) * {_vec(KEY.colour)}
    + shineOf(n, v, {_vec(FILL.direction)}) * {_vec(FILL.colour)}) * gloss * (1.0 + 3.0 * graze2);
  vec3 seen = albedo * light + shine * open + SHEEN * graze2 * graze * around * open;
  seen = sqrt(seen * (1.0 + 0.12 * seen) / (1.0 + 0.42 * seen));
  OUTPUT
"""


GLASS = f"""{FRAME}
  vec3 mirrored = reflect(-v, n);
  vec3 toKey = {_vec(KEY.direction)};
  vec3 across = normalize(cross(vec3(0.0, 1.0, 0.0), toKey));
  vec3 upward = cross(toKey, across);
  vec2 pane = vec2(dot(mirrored, across), dot(mirrored, upward)) / max(dot(mirrored, toKey), 0.05);
  vec2 edge = smoothstep(vec2(0.34, 0.42), vec2(0.24, 0.32), abs(pane));
  float bars = 1.0 - 0.55 * smoothstep(0.045, 0.02, abs(pane.y));
  float window = edge.x * edge.y * bars * step(0.0, dot(mirrored, toKey));
  float strip = smoothstep(0.93, 0.985, dot(mirrored, {_vec(FILL.direction)}));
  float sky = 0.05 * smoothstep(0.1, 0.9, mirrored.y);
  float alpha = clamp(0.92 * window + 0.20 * strip + sky + 0.30 * graze2 * graze2, 0.0, 0.95);
  fragOutput0 = vec4(mix(vec3(0.80, 0.86, 0.92), vec3(1.0, 0.99, 0.97), window), alpha);
"""
"""A clear shell that only mirrors: a window where the key light is, a strip of the fill, a breath of sky."""


PLACED = "\n  //VTK::SSAO::Impl\n"
"""Where VTK's occlusion pass, when it draws, has a fragment tell place and normal: it looks for this after the lighting
of its own, which is not there any more; for anybody else it is a comment."""


NOWHERE = "\n  vertexVC = vec4(0.0);\n"
"""Tells that pass another place than that which is seen, whereupon it leaves the fragment as it is."""


def apply(
    actor: vtkActor,
    material: Material,
    *,
    openness: bool = False,
    detail: str = "",
    carried: Sequence[str] = (),
    ghost: Ghost = Ghost.SOLID,
    shaded: bool = True,
) -> None:
    """Give an actor a material.

    Parameters
    ----------
    actor : what to dress
    material : how it takes light
    openness : whether the fourth component of its colours is openness
    detail : GLSL that may change ``albedo``, ``open`` and ``gloss`` before light falls
    carried : which of `ATTRIBUTES` its points carry, as the vertex attributes ``paintMC`` and ``foldMC``
    ghost : whether one can look through it
    shaded : whether the occlusion pass may darken it
    """
    text = (
        LIGHTING.replace("OPENNESS", "vertexColorVSOutput.a" if openness else "1.0")
        .replace("DETAIL", detail)
        .replace("SHEEN", f"{material.sheen:.4f}")
        .replace("OUTPUT", ghost.value)
        .replace("COVER", "paintVSOutput.a" if "paint" in carried else "0.0")
    )
    _replace(actor, _functions(material, carried), text if shaded else text + NOWHERE)
    if carried:
        kinds = [(ATTRIBUTES[name], name) for name in carried]
        declared = "".join(f"\nin {kind} {name}MC;\nout {kind} {name}VSOutput;" for kind, name in kinds)
        handed = "".join(f"\n  {name}VSOutput = {name}MC;" for _, name in kinds)
        shader = actor.GetShaderProperty()
        for place, text in (("//VTK::Normal::Dec", declared), ("//VTK::Normal::Impl", handed)):
            shader.AddVertexShaderReplacement(place, True, place + text, False)


def glaze(actor: vtkActor) -> None:
    """Make an actor a clear shell that mirrors the lamps: the film of tears on an eye."""
    actor.ForceTranslucentOn()
    _replace(actor, "", GLASS)


def _replace(actor: vtkActor, functions: str, lighting: str) -> None:
    """Put GLSL in the place of VTK's lighting."""
    shader = actor.GetShaderProperty()
    shader.ClearAllShaderReplacements()
    shader.AddFragmentShaderReplacement("//VTK::Light::Dec", True, "//VTK::Light::Dec\n" + functions, False)
    shader.AddFragmentShaderReplacement("//VTK::Light::Impl", True, lighting + PLACED, False)
    shader.AddFragmentShaderReplacement("//VTK::TCoord::Impl", True, "", False)
