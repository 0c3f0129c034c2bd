# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes for the tests: nets by formulas, the samples' files, FreeCAD's where it can be imported."""

import atexit
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
    sys.path.append(folder)
try:
    import FreeCAD
    import Part
except ImportError:
    FreeCAD = Part = None

NO_PART = "FreeCAD's Part cannot be imported"


def plane(origin, u, v):
    """The net of a parallelogram."""
    o, u, v = (np.array(x, float) for x in (origin, u, v))
    return np.array([[o, o + v], [o + u, o + u + v]])


FLOOR = plane((-1, -1, 0), (2, 0, 0), (0, 2, 0))
WALL = plane((0, -1, -1), (0, 2, 0), (0, 0, 2))
FAR = plane((-1, -1, 5), (2, 0, 0), (0, 2, 0))


def waves(degree, height, phase):
    """A patch of many bumps; two of them that are near each other are hard to tell apart."""
    n = degree + 1
    i, j = np.meshgrid(range(n), range(n), indexing="ij")
    z = height * (-1.0) ** (i + j) + phase
    return np.stack([i / degree, j / degree, z], axis=2)


# Come ever nearer to each other towards the middle.
HARD = (waves(24, 0.5, 0), waves(24, 0.25, 0))
HARD_OPTIONS = {"tolerance": 1e-10, "budget": 10**9}


def made_files():
    """The folder of the samples' files: block.step of 60 x 40 x 20, drill.step through it, hull.step
    and cutters.step."""
    folder = Path(tempfile.mkdtemp(prefix="blossom-python-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    subprocess.run([os.environ["BLOSSOM_MAKE_PARTS"], folder], check=True)
    return folder


def told_by_program(*arguments):
    """The report of the command line. It may exit with 3, which says `tolerance`."""
    done = subprocess.run(
        [os.environ["BLOSSOM_PROGRAM"], *map(str, arguments), "--json", "-", "-q"],
        stdout=subprocess.PIPE, check=False,
    )  # fmt: skip
    if done.returncode not in (0, 3):
        raise AssertionError(f"{arguments} exits with {done.returncode}")
    return json.loads(done.stdout)


def without_times(report):
    """A report without what differs from run to run."""
    return {key: value for key, value in report.items() if not key.startswith("seconds")}
