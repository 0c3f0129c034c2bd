#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of simple solids beside those of Open CASCADE, on the same shapes in one run.

    PYTHONPATH=build/release/plugin/python /usr/bin/python3 tests/bench/simple_solids.py

Each row has a pair, then for cut, common and fuse the milliseconds of Open CASCADE (through FreeCAD's Part), of Blossom
(through the package, with its checks of inputs and result, on one thread) and the ratio of both; the last column is what
Blossom says of the cut. Times are the least of five, of processor time. The last line has the median of all ratios.
"""

import statistics
import sys
import time

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    sys.path.append(folder)
import FreeCAD
import Part

import blossom

V = FreeCAD.Vector
RUNS = 5
BOX = Part.makeBox(10, 10, 10)


def pairs():
    yield "boxes that overlap", BOX, Part.makeBox(10, 10, 10, V(5, 5, 5))
    yield "boxes side by side", BOX, Part.makeBox(10, 10, 10, V(10, 0, 0))
    yield "a box in a box", BOX, Part.makeBox(2, 2, 2, V(4, 4, 4))
    yield "a corner of a box", BOX, Part.makeBox(4, 4, 10, V(6, 6, 0))
    yield "a bore through", BOX, Part.makeCylinder(3, 12, V(5, 5, -1))
    yield "a flush bore", BOX, Part.makeCylinder(3, 10, V(5, 5, 0))
    yield "a countersink", BOX, Part.makeCone(4, 1, 12, V(5, 5, -1))
    yield "a ball on a corner", BOX, Part.makeSphere(4, V(10, 10, 10))
    yield "a ring on a corner", BOX, Part.makeTorus(6, 2)
    yield "pipes of one radius", Part.makeCylinder(3, 10), Part.makeCylinder(3, 10, V(-5, 0, 5), V(1, 0, 0))
    yield "pipes of two radii", Part.makeCylinder(3, 10), Part.makeCylinder(2, 10, V(-5, 0, 5), V(1, 0, 0))
    yield "two balls", Part.makeSphere(5), Part.makeSphere(5, V(4, 1, 0))
    yield "a ball in a ring", Part.makeSphere(5), Part.makeTorus(6, 2)
    yield "a pipe in a cone", Part.makeCone(5, 1, 10), Part.makeCylinder(2, 12, V(-6, 1, 4), V(1, 0, 0))
    yield "two rings", Part.makeTorus(6, 2), Part.makeTorus(6, 2, V(3, 0, 0), V(0, 1, 0))


def least(work):
    """In milliseconds; the first run does not count."""
    times = []
    for _ in range(RUNS + 1):
        start = time.process_time()
        work()
        times.append(1000 * (time.process_time() - start))
    return min(times[1:])


def main():
    ratios = []
    print("| pair | cut | common | fuse | status |")
    print("|---|---|---|---|---|")
    for name, a, b in pairs():
        cells = []
        for operation in ("cut", "common", "fuse"):
            theirs = least(lambda: getattr(a, operation)(b))
            ours = least(lambda: blossom.solid(operation, a.copy(), b.copy(), threads=1))
            ratios.append(theirs / ours)
            cells.append(f"{theirs:.2f} / {ours:.2f} = {theirs / ours:.2f}")
        print(f"| {name} | {' | '.join(cells)} | {blossom.solid('cut', a, b).status} |")
    print(f"\nmedian {statistics.median(ratios):.2f}")


if __name__ == "__main__":
    main()
