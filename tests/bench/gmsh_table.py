#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models as triangles by gmsh, and by Blossom within the distance that gmsh's have.

    gmsh_table.py [--program BLOSSOM] [--per-turn N] FILE...

gmsh takes no deviation; it gets N sides for a full turn (Mesh.MeshSizeFromCurvature). The distance
of its mesh from the model is measured by `blossom query distance`, between bounds; ours is asked for
at the lower one. Each runs in a process of its own, which gives seconds of the processor and the
peak of memory. It takes Debian's python3-gmsh.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

MESH = """
import sys, gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("General.NumThreads", 1)
gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", float(sys.argv[3]))
gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
gmsh.model.occ.importShapes(sys.argv[1])
gmsh.model.occ.synchronize()
gmsh.model.mesh.generate(2)
gmsh.option.setNumber("Mesh.Binary", 1)
gmsh.write(sys.argv[2])
"""
LIMIT = 600  # seconds of a run


def run(command):
    """Exit code, seconds, megabytes, text."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(read)
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT)
            code, text = done.returncode, done.stdout
        except subprocess.TimeoutExpired:
            code, text = 124, ""
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        told = [code, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, text]
        with os.fdopen(write, "w") as stream:
            json.dump(told, stream)
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as stream:
        told = json.load(stream)
    os.waitpid(child, 0)
    return told


def triangles_in(stl):
    with open(stl, "rb") as stream:
        stream.seek(80)
        return int.from_bytes(stream.read(4), "little")


def row(file, program, per_turn, folder):
    theirs, ours = folder / "gmsh.stl", folder / "ours.stl"
    code, seconds, memory, _ = run([sys.executable, "-c", MESH, str(file), str(theirs), str(per_turn)])
    if code != 0 or not theirs.exists():
        return f"| {file.stem} | none: exit code {code} after {seconds:.0f} s |"
    code, _, _, text = run([program, "query", "distance", str(theirs), str(file), "--json", "-"])
    if code not in (0, 3, 4):
        return f"| {file.stem} | {triangles_in(theirs)}, {seconds:.1f} s | not measured |"
    found = json.loads(text)
    deviation = found["lower"]
    code, own_seconds, own_memory, text = run(
        [program, "convert", str(file), "-o", str(ours), "--deviation", repr(deviation), "--json", "-"]
    )
    if code not in (0, 4):
        return f"| {file.stem} | {triangles_in(theirs)}, {seconds:.1f} s | ours: exit code {code} |"
    made = json.loads(text)
    return (
        f"| {file.stem} | {triangles_in(theirs)} | {found['lower']:.2g} to {found['upper']:.2g} "
        f"| {seconds:.2f} | {memory:.0f} | {made['triangles']} | {made['distance']:.2g} "
        f"| {own_seconds:.2f} | {own_memory:.0f} | {made['triangles'] / triangles_in(theirs):.2f} |"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/release/plugin/cli/blossom")
    parser.add_argument("--per-turn", type=float, default=24)
    parser.add_argument("files", nargs="+", type=Path)
    options = parser.parse_args()
    print("| model | gmsh: triangles | measured | s | MB | ours: triangles | proven | s | MB | of theirs |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    for file in options.files:
        with tempfile.TemporaryDirectory() as folder:
            print(row(file, options.program, options.per_turn, Path(folder)), flush=True)


if __name__ == "__main__":
    main()
