#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models as triangles by gmsh, and by Blossom within the distance that gmsh's have.

    gmsh_table.py [--program BLOSSOM] [--per-turn N] [--parts N] FILE...

gmsh takes no deviation. Its adaptive meshes get N sides for a full turn (-clcurv), its uniform ones
sides of an N-th of the model's diagonal (-clmin, -clmax). The distance of its mesh from the model is
measured by `blossom query distance`, between bounds; ours is asked for at the lower one, and for the
same length of sides where they are uniform. Each runs in a process of its own, which gives seconds
of the processor, reading and writing included, and the peak of memory. It takes Debian's gmsh.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

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


def diagonal(file, program):
    """Of the model's box, model units."""
    code, _, _, text = run([program, "info", str(file), "--json", "-"])
    if code not in (0, 4):
        raise SystemExit(f"{file}: not read")
    box = json.loads(text)["box"]
    return sum((high - low) ** 2 for low, high in zip(*box)) ** 0.5


def row(file, program, name, sizes, own_sizes, folder):
    theirs, ours = folder / "gmsh.stl", folder / "ours.stl"
    command = ["gmsh", "-2", "-nt", "1", "-v", "1", "-bin", "-setstring", "Geometry.OCCTargetUnit", "MM"]
    code, seconds, memory, _ = run(command + sizes + ["-o", str(theirs), str(file)])
    start = f"| {file.stem}, {name} |"
    if code != 0 or not theirs.exists():
        return f"{start} none: exit code {code} after {seconds:.0f} s |"
    start += f" {triangles_in(theirs)} |"
    code, _, _, text = run([program, "query", "distance", str(theirs), str(file), "--json", "-"])
    if code not in (0, 3, 4):
        return f"{start} not measured: exit code {code} | {seconds:.2f} | {memory:.0f} |"
    found = json.loads(text)
    lower, upper = found["lower"], found["upper"]
    start += f" {lower:.2g} to {upper:.2g} | {seconds:.2f} | {memory:.0f} |"
    command = [program, "convert", str(file), "-o", str(ours), "--deviation", repr(lower), "--json", "-"]
    code, seconds, memory, text = run(command + own_sizes)
    if code not in (0, 4):
        return f"{start} none: exit code {code} |"
    made = json.loads(text)
    share = made["triangles"] / triangles_in(theirs)
    return f"{start} {made['triangles']} | {made['distance']:.2g} | {seconds:.2f} | {memory:.0f} | {share:.2f} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/release/plugin/cli/blossom")
    parser.add_argument("--per-turn", type=float, default=24)
    parser.add_argument("--parts", type=float, default=60)
    parser.add_argument("files", nargs="+", type=Path)
    options = parser.parse_args()
    print("| model | gmsh: triangles | measured | s | MB | ours: triangles | proven | s | MB | of theirs |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    for file in options.files:
        length = repr(diagonal(file, options.program) / options.parts)
        kinds = {
            "adaptive": (["-clcurv", str(options.per_turn)], []),
            "uniform": (["-clmin", length, "-clmax", length], ["--edge-length", length]),
        }
        for name, (sizes, own_sizes) in kinds.items():
            with tempfile.TemporaryDirectory() as folder:
                print(row(file, options.program, name, sizes, own_sizes, Path(folder)), flush=True)


if __name__ == "__main__":
    main()
