#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots how the time of an intersection grows, with fitted exponents, as SVG.

    bench_models --growth --csv growth.csv
    growth_plot.py growth.csv growth.svg

Both axes are logarithmic. A line is the least squares fit of log time against the log of what the
curves meet (spans, pairs of faces) and the poles that come out.
"""

import csv
import math
import sys

WIDTH, HEIGHT, EDGE = 720, 480, 70
COLOURS = {"spans": "#0b62a4", "faces": "#c7511f", "branches": "#3c8031",
           "alike": "#7a4aa0"}


def fitted(x, y):
    """Slope and offset of the line through the points (log x, log y)."""
    lx, ly = [math.log10(v) for v in x], [math.log10(v) for v in y]
    mx, my = sum(lx) / len(lx), sum(ly) / len(ly)
    slope = sum((a - mx) * (b - my) for a, b in zip(lx, ly)) / sum((a - mx) ** 2 for a in lx)
    return slope, my - slope * mx


def scale(values, low, high):
    """Maps powers of ten round the values to [low, high]."""
    first, last = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))
    last = max(last, first + 1)
    place = lambda v: low + (math.log10(v) - first) / (last - first) * (high - low)
    return place, [10.0**k for k in range(first, last + 1)]


def plot(families):
    xs = [x for points in families.values() for x, _ in points]
    ys = [y for points in families.values() for _, y in points]
    across, x_ticks = scale(xs, EDGE, WIDTH - 20)
    up, y_ticks = scale(ys, HEIGHT - EDGE, 20)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
        'font-family="sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
    ]
    grid = '<line x1="{}" y1="{}" x2="{}" y2="{}" stroke="#ddd"/>'
    for v in x_ticks:
        parts.append(grid.format(across(v), 20, across(v), HEIGHT - EDGE))
        parts.append(f'<text x="{across(v)}" y="{HEIGHT - EDGE + 18}" text-anchor="middle">{v:g}</text>')
    for v in y_ticks:
        parts.append(grid.format(EDGE, up(v), WIDTH - 20, up(v)))
        parts.append(f'<text x="{EDGE - 6}" y="{up(v) + 4}" text-anchor="end">{v:g}</text>')
    for row, (name, points) in enumerate(families.items()):
        colour = COLOURS.get(name, "#555")
        x, y = zip(*points)
        slope, offset = fitted(x, y)
        ends = [(v, 10 ** (offset + slope * math.log10(v))) for v in (min(x), max(x))]
        line = " ".join(f"{across(a)},{up(b)}" for a, b in ends)
        parts.append(f'<polyline points="{line}" stroke="{colour}" stroke-width="2" fill="none"/>')
        parts += [f'<circle cx="{across(a)}" cy="{up(b)}" r="4" fill="{colour}"/>' for a, b in points]
        parts.append(
            f'<text x="{EDGE + 12}" y="{40 + 18 * row}" fill="{colour}">{name}: exponent {slope:.2f}</text>'
        )
    parts.append(
        f'<text x="{WIDTH / 2}" y="{HEIGHT - 24}" text-anchor="middle">what is met, and poles</text>'
        f'<text x="18" y="{HEIGHT / 2}" text-anchor="middle" '
        f'transform="rotate(-90 18 {HEIGHT / 2})">seconds</text></svg>'
    )
    return "\n".join(parts) + "\n"


def main(table, picture):
    families = {}
    with open(table, newline="") as lines:
        for row in csv.DictReader(lines):
            point = (float(row["met"]) + float(row["poles"]), float(row["seconds"]))
            families.setdefault(row["family"], []).append(point)
    with open(picture, "w") as out:
        out.write(plot(families))
    for name, points in families.items():
        print(f"{name}: exponent {fitted(*zip(*points))[0]:.3f}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
