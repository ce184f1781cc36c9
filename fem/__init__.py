"""C1 finite elements on triangle meshes: arrays in, arrays out, no word of faces.

From a mesh to its displacement under M loads (fem works in millimetres and newtons)::

    surface = ChartedSurface(positions, triangles, chart)
    assembler = smooth_assembler(surface, HCT9)
    stiffness = assembler.assemble(element_tensors(surface, Material(direction, stretching, bending)))
    springs = Foundation(SpringSet(vertices, directions, stiffness_per_area).blocks(surface.n_vertices))
    system = SurfaceSystem(assembler.dofs, stiffness.matrix, Supports(kinds), springs.coupling(assembler))
    loads = (load_operator(assembler) @ forces.reshape(len(forces), -1)).reshape(-1, 3, M)
    fields = system.solve(loads)
    points = subdivide(triangles, 3)
    sample = sample_operators(assembler, points.elements, points.barycentric)
    moved = sample.value @ (assembler.smooth_positions + fields[..., 0])
"""

from fem.assembly import Assembler, Stiffness
from fem.dofs import DofMap
from fem.errors import FemError, SingularSystemError
from fem.hct import Element, ShapeFunctions, shape_functions
from fem.hct9 import HCT9
from fem.hct12 import HCT12
from fem.interpolate import SmoothInterpolation, interpolate_smoothly, smooth_assembler
from fem.loads import corner_load_operator, load_operator, load_points, point_loads
from fem.quadrature import TriangleRule, rule_of_degree
from fem.sample import SampleOperators, Subdivision, sample_operators, subdivide
from fem.springs import Foundation, PointSprings, SpringLayer, SpringSet
from fem.supports import Support, Supports
from fem.surface import ChartedSurface, edge_topology
from fem.system import Progress, SurfaceSystem
from fem.tensors import ElementTensors, Material, element_tensors, uniform_material
from fem.volume import VolumeLayer

__all__ = [
    "HCT9",
    "HCT12",
    "Assembler",
    "ChartedSurface",
    "DofMap",
    "Element",
    "ElementTensors",
    "FemError",
    "Foundation",
    "Material",
    "PointSprings",
    "Progress",
    "SampleOperators",
    "ShapeFunctions",
    "SingularSystemError",
    "SmoothInterpolation",
    "SpringLayer",
    "SpringSet",
    "Stiffness",
    "Subdivision",
    "Support",
    "Supports",
    "SurfaceSystem",
    "TriangleRule",
    "VolumeLayer",
    "corner_load_operator",
    "edge_topology",
    "element_tensors",
    "interpolate_smoothly",
    "load_operator",
    "load_points",
    "point_loads",
    "rule_of_degree",
    "sample_operators",
    "shape_functions",
    "smooth_assembler",
    "subdivide",
    "uniform_material",
]
