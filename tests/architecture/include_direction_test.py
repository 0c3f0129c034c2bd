#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrows of the architecture: which files may include which.

    include_direction_test.py ROOT              checks the tree, exit code 1 if an arrow is wrong
    include_direction_test.py ROOT --self-test  checks that broken trees are found

A room is a folder, its `detail` folder is part of it. A module is a header with its source. Each
room uses those before it in its list; inside a room the modules use each other without cycles.
Headers at the top of `core` and of `adapters/occt` are what users call: every room may name their
types, and they are implemented beside the header, out of all rooms.
"""
import re
import sys
from pathlib import Path

CORE_ROOMS = """base math math/functions math/series forms forms/algebra forms/spans forms/meetings blossom subdivision
    subdivision/bulk papers bounds results cells surfaces/gap surfaces/gap/cells surfaces/pairs surfaces/adjacency
    surfaces/contacts surfaces/coincidence surfaces/branches surfaces/search tracing surfaces/assembly
    surfaces/retry curves curves/with_surfaces plane distance rays regions/delaunay regions
    regions/cleaning topology topology/clipping neighbours tessellation/charts tessellation meshes watertight blending
    blending/fills blending/continuity blending/strips blending/balls""".split()
OCCT_ROOMS = """base convert faces faces/pairs tessellation queries splitting/edges splitting coincidence
    pair_search solids/tolerances solids/validity solids repair wires exact exchange exchange/step documents blending
    blending/strips blending/sheet""".split()
REPORT_ROOMS = "text models cuts queries blends".split()
PICTURE_ROOMS = "image/raster scene image page results".split()

STANDARD = r"<[a-z_0-9]+>"
CORE_LIBRARIES = r"<(Eigen|tbb|oneapi/tbb|boost/multiprecision)/.*>|<immintrin\.h>|<pthread\.h>"
MOST_HEADERS = 15

INCLUDE = re.compile(r'^\s*#\s*include\s*("[^"]+"|<[^>]+>)', re.MULTILINE)


def includes(files):
    return {name: INCLUDE.findall(text) for name, text in files.items()}


def room_of(path, library):
    """The folder below the library, without `detail`; "" for its top."""
    inner = path[len(library) + 1:].split("/")[:-1]
    return "/".join(part for part in inner if part != "detail")


def module_of(path):
    return path.rsplit(".", 1)[0]


def wrong_arrows(files, library, rooms):
    """Includes inside a library that lead to a room which does not lie below."""
    rank = {room: place for place, room in enumerate(rooms)}
    for name, lines in includes(files).items():
        if not name.startswith(library + "/"):
            continue
        own = room_of(name, library)
        if own and own not in rank:
            yield f"{library}/{own} is no room: name it in this test"
            continue
        for line in lines:
            target = line.strip('"')
            if not target.startswith(library + "/"):
                continue
            other = room_of(target, library)
            if own and other and rank.get(other, len(rank)) > rank[own]:
                yield f"{name} may not include {target}"
            if not own and name.endswith(".h") and other and rank.get(other, len(rank)) > rank_of_top(rank):
                yield f"{name} is for users and may not include {target}"


def rank_of_top(rank):
    """What headers at the top may use: everything up to results in core, conversion in Open CASCADE."""
    return rank.get("results", rank.get("convert", 0))


def cycles(files, library):
    """Modules of one room that include each other in a circle."""
    graph = {}
    for name, lines in includes(files).items():
        if name.startswith(library + "/") and room_of(name, library):
            for line in lines:
                target = line.strip('"')
                if name.endswith(".cpp") and re.search(r"/detail/|_detail\.h$", target):
                    continue  # the inside of the source
                if target.startswith(library + "/") and room_of(target, library) == room_of(name, library):
                    graph.setdefault(module_of(name), set()).add(module_of(target))
    done, path = set(), []

    def visit(module):
        if module in path:
            yield " -> ".join(path[path.index(module):] + [module])
        elif module not in done:
            path.append(module)
            for other in sorted(graph.get(module, ())):
                if other != module:
                    yield from visit(other)
            path.pop()
            done.add(module)

    for module in sorted(graph):
        yield from (f"a cycle: {circle}" for circle in visit(module))


def foreign(files, folder, endings, allowed):
    """Includes of a folder that match none of the allowed patterns."""
    pattern = re.compile("|".join(f"(?:{part})" for part in allowed))
    for name, lines in includes(files).items():
        if name.startswith(folder + "/") and name.endswith(endings):
            for line in lines:
                if not pattern.match(line):
                    yield f"{name} may not include {line}"


def crowded(files, library):
    """Rooms with more headers than a reader takes in, their limits aside."""
    count = {}
    for name in files:
        if (name.startswith(library + "/") and name.endswith(".h") and "/detail/" not in name
                and not name.endswith("/limits.h")):
            room = room_of(name, library)
            count[room] = count.get(room, 0) + 1
    for room, headers in sorted(count.items()):
        if room and headers > MOST_HEADERS:
            yield f"{library}/{room} has {headers} headers: divide it"


def faults(files):
    yield from wrong_arrows(files, "core", CORE_ROOMS)
    yield from wrong_arrows(files, "adapters/occt", OCCT_ROOMS)
    yield from wrong_arrows(files, "plugin/reports", REPORT_ROOMS)
    yield from wrong_arrows(files, "plugin/pictures", PICTURE_ROOMS)
    for library in ("core", "adapters/occt", "plugin/reports", "plugin/pictures", "plugin/cli"):
        yield from cycles(files, library)
        yield from crowded(files, library)
    yield from foreign(files, "core", ".h", ['"core/', STANDARD])
    yield from foreign(files, "core", ".cpp", ['"core/', STANDARD, CORE_LIBRARIES])
    for library in ("occt", "cgal", "openmesh"):
        yield from foreign(files, f"adapters/{library}", (".h", ".cpp"),
                           ['"core/', f'"adapters/{library}/', "<"])
    for door in ("cli", "draw", "python", "freecad"):
        yield from foreign(files, f"plugin/{door}", (".h", ".cpp"),
                           ['"core/', '"adapters/', '"plugin/reports/', '"plugin/nets/',
                            '"plugin/meshes/', '"plugin/drawings/', '"plugin/pictures/',
                            f'"plugin/{door}/', "<"])
    yield from foreign(files, "plugin/pictures", (".h", ".cpp"),
                       ['"core/', '"adapters/', '"plugin/reports/', '"plugin/nets/',
                        '"plugin/meshes/', '"plugin/pictures/', "<"])
    for shared in ("nets", "meshes", "drawings"):
        yield from foreign(files, f"plugin/{shared}", (".h", ".cpp"),
                           ['"core/', '"adapters/', '"plugin/reports/', f'"plugin/{shared}/', "<"])
    yield from foreign(files, "plugin/reports", (".h", ".cpp"),
                       ['"core/', '"adapters/', '"plugin/reports/', "<"])


def sources(root):
    return {
        str(path.relative_to(root)): path.read_text(encoding="utf-8")
        for folder in ("core", "adapters", "plugin")
        for path in (root / folder).rglob("*")
        if path.suffix in (".h", ".cpp")
    }


def self_test(files):
    """Each kind of fault, put into a sound tree, is found."""
    broken = {
        "an arrow upwards": {"core/math/added.cpp": '#include "core/curves/curve_pair.h"\n'},
        "a new room": {"core/attic/added.h": ""},
        "a cycle in a room": {"core/cells/x.h": '#include "core/cells/y.h"\n',
                              "core/cells/y.cpp": '#include "core/cells/x.h"\n#include "core/cells/y.h"\n'},
        "Open CASCADE in core": {"core/forms/added.cpp": "#include <gp_Pnt.hxx>\n"},
        "a door in another": {"plugin/draw/added.cpp": '#include "plugin/cli/arguments/usage.h"\n'},
        "an answer's report below the model's": {
            "plugin/reports/models/added.cpp": '#include "plugin/reports/cuts/trim.h"\n'},
        "exchange below faces": {"adapters/occt/faces/added.cpp": '#include "adapters/occt/exchange/step/step.h"\n'},
        "a crowd": {f"core/plane/added{i}.h": "" for i in range(MOST_HEADERS)},
    }
    before = set(faults(files))
    return [what for what, added in broken.items() if not set(faults({**files, **added})) - before]


def main():
    files = sources(Path(sys.argv[1]))
    if len(files) < 100:
        print(f"only {len(files)} files found below {sys.argv[1]}")
        return 1
    found = ([f"not found: {what}" for what in self_test(files)] if "--self-test" in sys.argv
             else list(faults(files)))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
