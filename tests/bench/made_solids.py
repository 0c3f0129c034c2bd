#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids that our own booleans and fillets make, drawn at random, for bench_meshes.

    PYTHONPATH=build/release/plugin/python /usr/bin/python3 tests/bench/made_solids.py SEED COUNT FOLDER

Boxes, plates, cylinders, cones, balls, tori, prisms, lofts, pipes and scaled balls of FreeCAD's Part are
cut, united and rounded by Blossom. What it makes is written as SEED_NUMBER_JOB_A_B.brep; what it refuses is
told, and drawn anew. The same seed makes the same solids.
"""

import math
import random
import sys
from pathlib import Path

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    sys.path.append(folder)
import FreeCAD
import Part

import blossom

V = FreeCAD.Vector
LIMIT = 20  # seconds of a step
JOBS = ("cut", "common", "fuse", "fillet", "cut and fillet", "cut and fuse")


class Parts:
    """Parts of about 20 mm, by the name of their kind."""

    def __init__(self, draw):
        self.draw = draw
        self.kinds = {
            "box": lambda u: Part.makeBox(u(8, 30), u(8, 30), u(4, 20), V(-10, -10, -5)),
            "plate": lambda u: Part.makeBox(u(20, 40), u(20, 40), u(0.5, 3), V(-15, -15, -1)),
            "cylinder": lambda u: Part.makeCylinder(u(3, 12), u(6, 30), V(0, 0, -10)),
            "cone": lambda u: Part.makeCone(u(3, 12), max(0, u(-3, 5)), u(6, 25), V(0, 0, -8)),
            "ball": lambda u: Part.makeSphere(u(5, 14)),
            "torus": lambda u: Part.makeTorus(u(8, 15), u(1.5, 5)),
            "prism": self.prism,
            "loft": self.loft,
            "pipe": self.pipe,
            "scaled": self.scaled,
        }

    def drawn(self):
        kind = self.draw.choice(list(self.kinds))
        return kind, self.kinds[kind](self.draw.uniform)

    def moved(self, part):
        u = self.draw.uniform
        turn = FreeCAD.Rotation(V(u(-1, 1), u(-1, 1), u(-1, 1)), u(0, 360))
        made = part.copy()
        made.Placement = FreeCAD.Placement(V(u(-6, 6), u(-6, 6), u(-6, 6)), turn).multiply(part.Placement)
        return made

    def ring(self, corners, radius, spread, height):
        u = self.draw.uniform
        turns = [2 * math.pi * (k + 0.5) / corners for k in range(corners)]
        return [V(radius * math.cos(t) * u(*spread), radius * math.sin(t) * u(*spread), height) for t in turns]

    def prism(self, u):
        corners = self.ring(self.draw.randint(3, 7), u(8, 20), (0.8, 1.2), 0)
        face = Part.Face(Part.makePolygon([*corners, corners[0]]))
        return face.extrude(V(u(-3, 3), u(-3, 3), u(5, 25)))

    def loft(self, u):
        wires = []
        for k in range(self.draw.randint(2, 4)):
            curve = Part.BSplineCurve()
            curve.interpolate(self.ring(4, u(5, 12), (0.9, 1.3), 10 * k), PeriodicFlag=True)
            wires.append(Part.Wire(curve.toShape()))
        return Part.makeLoft(wires, True, u(0, 1) < 0.3)

    def pipe(self, u):
        curve = Part.BSplineCurve()
        curve.interpolate([V(0, 0, 0), *(V(10 * k + u(-2, 2), u(-6, 6), u(-6, 6)) for k in (1, 2, 3))])
        profile = Part.Wire(Part.makeCircle(u(1.5, 3), V(0, 0, 0), curve.tangent(0)[0]))
        return Part.Wire(curve.toShape()).makePipeShell([profile], True, True)

    def scaled(self, u):
        matrix = FreeCAD.Matrix()
        matrix.scale(u(0.6, 1.5), u(0.6, 1.5), u(0.6, 1.5))
        return Part.makeSphere(u(6, 12)).transformGeometry(matrix)


def made(job, part, tool, other, radius):
    first = blossom.shape(part)
    if job == "fillet":
        return first.fillet("all", radius=radius, time_limit=LIMIT)
    if job in ("cut", "common", "fuse"):
        return first.solid(job, tool, time_limit=LIMIT)
    cut = first.solid("cut", tool, time_limit=LIMIT).model
    if job == "cut and fuse":
        return cut.solid("fuse", other, time_limit=LIMIT)
    return cut.fillet("convex", radius=radius, time_limit=LIMIT)


def main():
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    seed, count, folder = int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    draw = random.Random(seed)
    parts = Parts(draw)
    done = tried = 0
    while done < count and tried < 4 * count:
        tried += 1
        (a, part), (b, tool), (_, other) = parts.drawn(), parts.drawn(), parts.drawn()
        tool, other = parts.moved(tool), parts.moved(other)
        job, radius = draw.choice(JOBS), draw.uniform(0.2, 1.5)
        try:
            answer = made(job, part, tool, other, radius)
            if not answer or answer.model.counts["solids"] < 1:
                continue
            text = answer.model.to_brep()
        except (ValueError, blossom.Error) as refusal:
            print(f"{job} of {a} and {b}: {refusal}", file=sys.stderr)
            continue
        name = f"{seed}_{done:03d}_{job.replace(' ', '_')}_{a}_{b}.brep"
        (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        done += 1
    print(f"seed {seed}: {done} solids of {tried} jobs")


if __name__ == "__main__":
    main()
