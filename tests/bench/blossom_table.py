# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the table of subdivision times between the markers of a Markdown file.

usage: blossom_table.py MEASURED.json README.md   (the output of bench_subdivision)

Times are the best of all repetitions, for one piece; of rows in several vector widths the widest.
"""

import json
import pathlib
import sys

BEGIN, END = "<!-- begin: tests/bench/blossom_table.sh -->", "<!-- end -->"
DEGREES = (3, 5, 9)
WIDTHS = ("avx512", "avx2", "plain")
PATCHES = (
    ("printed_9", "formula (9) as printed"),
    ("closed_form", "formula (9) in two factors, `patch_blossom.h`"),
    ("segment", "Open CASCADE, `Geom_BezierSurface::Segment`, without the copy"),
    ("eigen", "matrices by blossom, products by Eigen"),
    ("de_casteljau_plain", "de Casteljau's algorithm, value by value"),
    ("de_casteljau_lanes", "de Casteljau's algorithm, a vector of pieces at a time"),
    ("single", "bulk form, one piece a call"),
    ("pieces_matrices", "bulk form, 64 pieces anywhere"),
    ("pieces_pyramid", "bulk form, the same by polar pyramids"),
    ("pieces_within", "bulk form, the same by whichever path keeps 1e-7"),
    ("grid8", "bulk form, a grid of 8 x 8 pieces"),
)
TRIANGLES = (
    ("triangle_printed_14", "formula (14) as printed, `triangle_blossom.h`"),
    ("triangles_t1", "bulk form, differences"),
    ("triangles_t4", "bulk form, one matrix for each direction"),
)


def best_times(measured):
    """Nanoseconds for a piece, by name."""
    best = {}
    for run in measured["benchmarks"]:
        if run["run_type"] != "iteration":
            continue
        nanoseconds = run["cpu_time"] * {"ns": 1, "us": 1e3, "ms": 1e6}[run["time_unit"]]
        time = nanoseconds / run["pieces"]
        name = run["run_name"]
        best[name] = min(best.get(name, time), time)
    return best


def time_of(best, row, degree):
    if row == "segment":
        whole, copy = (best.get(f"occt_{part}/{degree}") for part in ("copy_and_segment", "copy"))
        return whole - copy if whole and copy else None
    names = [f"{row}/{degree}"] + [f"{row}/{degree}/{width}" for width in WIDTHS]
    return next((best[name] for name in names if name in best), None)


def cells(time, reference):
    if time is None:
        return ["", ""]
    ratio = reference / time
    return [f"{time:.{0 if time >= 100 else 1}f}", f"{ratio:.{0 if ratio >= 10 else 1}f}"]


def table(best):
    heads = [f"({n},{n}) ns | x" for n in DEGREES]
    lines = ["| sub-patch | " + " | ".join(heads) + " |", "|---" + "|---:|---:" * len(DEGREES) + "|"]
    for row, words in PATCHES:
        line = [words]
        for degree in DEGREES:
            line += cells(time_of(best, row, degree), time_of(best, "printed_9", degree))
        lines.append("| " + " | ".join(line) + " |")
    lines += ["", "| triangle of degree 6 of a (3,3) patch | ns | x |", "|---|---:|---:|"]
    for row, words in TRIANGLES:
        found = cells(time_of(best, row, 6), time_of(best, "triangle_printed_14", 6))
        lines.append("| " + " | ".join([words] + found) + " |")
    return "\n".join(lines)


def widest(best):
    return next(width for width in WIDTHS if any(name.endswith("/" + width) for name in best))


def main():
    measured, page = json.loads(pathlib.Path(sys.argv[1]).read_text()), pathlib.Path(sys.argv[2])
    best = best_times(measured)
    text = page.read_text()
    before, rest = text.split(BEGIN)
    _, after = rest.split(END, 1)
    note = f"One core, vectors: {widest(best)}, {measured['context']['date'][:10]}."
    page.write_text(f"{before}{BEGIN}\n{note}\n\n{table(best)}\n{END}{after}")


if __name__ == "__main__":
    main()
