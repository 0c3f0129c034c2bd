# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users write, for mypy: what it says of types is right, and nothing is Any by accident."""

from typing import Any, Dict, List, Optional, Union, assert_type

import numpy as np
from numpy.typing import NDArray

import blossom

Array = NDArray[np.float64]

model = blossom.read("block.step")
assert_type(model, blossom.Model)
assert_type(model.face(1), blossom.Model)
assert_type(model.counts, Dict[str, int])
assert_type(model.info(edges=True), Dict[str, Any])

found = model.intersect("drill.step", tolerance=1e-6, cancel=blossom.Cancel())
assert_type(found, blossom.Intersection)
assert_type(found.curves, List[blossom.Curve])
assert_type(found.curves[0].points, Array)
assert_type(found.curves[0].weights, Optional[Array])
assert_type(found.to_brep(), bytes)
assert_type(found.to_dict(), Dict[str, Any])
found.to_html("found.html", view="top")
model.to_png("model.png", view=(1, 2, 3), size=(800, 600), nice=5)
model.continuity().to_png("stripes.png", zebra=True)
model.mesh().to_glb("mesh.glb")
blossom.from_mesh("mesh.stl").to_html("mesh.html")
blossom.section(model, (0, 0, 1), (0, 0, 1)).to_svg("section.svg")

assert_type(blossom.section(model, (0, 0, 1), (0, 0, 1)).wires, List[blossom.Wire])
assert_type(model.sections(offsets=[1, 2]).planes, List[blossom.PlaneSection])
assert_type(model.sections(offsets=[1, 2]).planes[0].parts[0].curves, List[blossom.SectionCurve])
assert_type(blossom.clash(model, "drill.step", clearance=1).findings, List[blossom.ClashPair])
assert_type(model.clash().pairs[0].volume, Optional[float])
assert_type(model.mesh(0.1).vertices, Array)
assert_type(model.mesh().triangles, NDArray[np.int32])
assert_type(model.mesh().groups, Dict[int, slice])
assert_type(model.ray((0, 0, 9), (0, 0, -1)).hits, List[blossom.Hit])
assert_type(model.distance(b"").bounds[0], float)
assert_type(model.mass().parts[0].volume, float)
assert_type(model.solid("cut", b"").model.volume, float)
assert_type(model.foot_points((0, 0, 0)).inside, Optional[bool])
assert_type(model.check().problems, List[str])
assert_type(model.continuity(require="G1").failing, List[int])

assert_type(model.trim("drill.step", keep="outside"), blossom.Trim)
assert_type(model.solid("cut", "drill.step").volume, float)
assert_type(model.fillet([1], radius=2).edges, List[int])
assert_type(model.fillet([1], radius=(2, 5), section="conic:0.4"), blossom.Fillet)
assert_type(model.chamfer("all", distance=(2, 1)).volume, Optional[float])
assert_type(model.fill(continuity="G2"), blossom.Fill)
assert_type(model.subdivide((0, 1, 0, 1), levels=1).nets, List[blossom.Net])
assert_type(model.subdivide(whole=True), blossom.Whole)
assert_type(blossom.subdivide(model, whole=True).splines, List[blossom.Spline])
assert_type(blossom.subdivide(model), blossom.Subdivision)
assert_type(model.convert("bezier").error, float)
assert_type(blossom.convert("a.step", "a.brep"), Optional[blossom.Conversion])
assert_type(blossom.blend_strip(model, model).edge_a, Union[str, int])

model.chamfer([1])  # type: ignore[call-arg]
model.solid(3)  # type: ignore[arg-type]
blossom.read(3)  # type: ignore[arg-type]
