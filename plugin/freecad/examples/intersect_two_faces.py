# SPDX-License-Identifier: LGPL-2.1-or-later
# Two B-spline faces, one of them in a part that is placed elsewhere, and all their intersections.
# Run it as a macro, paste it into FreeCAD's Python console, or call
# `freecadcmd intersect_two_faces.py`.

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


document = FreeCAD.newDocument("Intersection")
sea = document.addObject("Part::Feature", "Sea")
sea.Shape = wavy_face(lambda x, y: math.sin(0.6 * x) * math.cos(0.5 * y))
sail = document.addObject("Part::Feature", "Sail")
sail.Shape = wavy_face(lambda x, y: 0.2 * (x - 5) + 0.3 * math.sin(y))
boat = document.addObject("App::Part", "Boat")
boat.addObject(sail)
boat.Placement.Base = FreeCAD.Vector(0.5, 2, 0.25)
document.recompute()

# sail.Shape does not know where the boat is; the path from the boat down to the face does.
face_a = Part.getShape(sea, "Face1", needSubElement=True)
face_b = Part.getShape(boat, "Sail.Face1", needSubElement=True)

found = blossom.intersect(face_a, face_b)

print("status:", found.status, "in", round(found.seconds, 4), "s")
for number, curve in enumerate(found.curves, start=1):
    print(f"curve {number}: {'closed' if curve.closed else 'open'}, length {curve.length:.6f}")

document.addObject("Part::Feature", "Curves").Shape = found.to_part()
document.recompute()
