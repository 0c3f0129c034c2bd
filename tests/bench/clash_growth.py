#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the time and memory of `blossom clash` grow with the parts of an assembly.

    clash_growth.py BLOSSOM FOLDER PART.brep --parts 10,100,1000,10000

PART is one solid in text BREP without places. An assembly has copies of it that share one shape, in a
cubic grid. Every second one penetrates the one before it by a tenth of its length; other neighbours
are half a length apart. So pairs that meet are half as many as parts. Prints processor seconds and the
peak of memory for each number of parts, and the power of it that fits the seconds.
"""

import argparse
import json
import math
import os
import re
import resource
import subprocess
import sys
from pathlib import Path

REFERENCES = re.compile(r"^([+-]\d+ \d+ )+\*$|^\*$")
OVERLAP, GAP = 0.1, 0.5  # of a part's length


def grid(count, size):
    """Where the copies are."""
    side = math.ceil(count ** (1 / 3) / 2) * 2
    for number in range(count):
        x, y, z = number % side, number // side % side, number // side // side
        along = x // 2 * (2 - OVERLAP + GAP) + x % 2 * (1 - OVERLAP)
        yield along * size[0], y * (1 + GAP) * size[1], z * (1 + GAP) * size[2]


def shifted(line):
    """References count shapes from the last one, and there is one more behind them."""
    return re.sub(r"([+-])(\d+) (\d+)", lambda m: f"{m[1]}{int(m[2]) + 1} {m[3]}", line)


def assembly(part, count, size):
    """Text BREP of a compound of copies."""
    head, shapes = part.split("TShapes ", 1)
    places = "".join(f"1\n1 0 0 {x!r}\n0 1 0 {y!r}\n0 0 1 {z!r}\n" for x, y, z in grid(count, size))
    number, shapes = shapes.split("\n", 1)
    lines = [shifted(line) if REFERENCES.match(line) else line for line in shapes.rstrip().split("\n")]
    whole = lines.pop()
    children = " ".join(shifted(whole).split()[0] + f" {i + 1}" for i in range(count))
    compound = ["Co", "", "0100000", children + " *", "", "+1 0"]
    return (
        head.replace("Locations 0\n", f"Locations {count}\n{places}", 1)
        + f"TShapes {int(number) + 1}\n"
        + "\n".join(lines + compound)
        + "\n"
    )


def run(*command):
    """The report, and processor seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([*map(str, command), "--json", "-", "-q"], capture_output=True, check=False)
    if not done.stdout:
        sys.exit(done.stderr.decode())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads(done.stdout), seconds


def exponent(points):
    logs = [(math.log(x), math.log(y)) for x, y in points]
    x0, y0 = (sum(p[k] for p in logs) / len(logs) for k in (0, 1))
    return sum((x - x0) * (y - y0) for x, y in logs) / sum((x - x0) ** 2 for x, _ in logs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("part", type=Path)
    parser.add_argument("--parts", default="10,100,1000,10000")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    program = os.path.abspath(given.program)
    box = run(program, "info", given.part)[0]["box"]
    size = [high - low for low, high in zip(*box, strict=True)]
    points = []
    for count in map(int, given.parts.split(",")):
        file = given.folder / f"{count}.brep"
        file.write_text(assembly(given.part.read_text(), count, size))
        report, seconds = run(program, "clash", file)
        memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        points.append((count, seconds))
        print(f"{count} parts: {len(report['pairs'])} pairs listed, {seconds:.2f} s, at most {memory:.0f} MB", flush=True)  # fmt: skip
    print(f"exponent of all {exponent(points):.2f}, of the last two {exponent(points[-2:]):.2f}")


if __name__ == "__main__":
    main()
