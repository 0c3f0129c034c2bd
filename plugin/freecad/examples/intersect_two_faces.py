# SPDX-License-Identifier: LGPL-2.1-or-later
# Two B-spline faces and all their intersections. Run it as a macro, paste it into FreeCAD's
# Python console, or call `freecadcmd intersect_two_faces.py`.

import math

import FreeCAD
import Part

import blossom


def wavy_face(height):
    """A B-spline face through points of a wave, 0 <= x, y <= 10."""
    points = [
        [FreeCAD.Vector(x, y, height(x, y)) for y in range(11)] for x in range(11)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface.toShape()


face_a = wavy_face(lambda x, y: math.sin(0.6 * x) * math.cos(0.5 * y))
face_b = wavy_face(lambda x, y: 0.2 * (x - 5) + 0.3 * math.sin(y))

found = blossom.intersect(face_a, face_b)

print("status:", found.status, "in", round(found.seconds, 4), "s")
for number, curve in enumerate(found.curves, start=1):
    print(f"curve {number}: {'closed' if curve.closed else 'open'}, length {curve.length:.6f}")

document = FreeCAD.ActiveDocument or FreeCAD.newDocument("Intersection")
for name, shape in (("FaceA", face_a), ("FaceB", face_b), ("Curves", found.to_part())):
    document.addObject("Part::Feature", name).Shape = shape
document.recompute()
