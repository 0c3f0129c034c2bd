#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sources of a folder have different names in their unnamed namespaces, so that they can be compiled together.

    room_names_test.py ROOT              checks the tree, exit code 1 if a name has two definitions
    room_names_test.py ROOT --self-test  checks that a second definition is found

Functions may have one name and different parameters. Names are looked for at the beginning of lines, as
the layout has them; what is missed here a whole build finds.
"""
import collections
import re
import sys
from pathlib import Path

FOLDERS = ("core", "adapters", "plugin", "tests/core", "tests/adapters/occt", "tests/plugin/cli")
# Compiled alone: each switches instructions of its own on; tests above the rooms.
ALONE = re.compile(r"core/subdivision/bulk/simd_\w+\.cpp|tests/adapters/occt/\w+\.cpp")

CONSTANT = re.compile(r"(?:inline |static )*constexpr .*?\b(k[A-Z]\w*)\b\s*(?:=|\{|;|\[)")
MORE_CONSTANTS = re.compile(r",\s*(k[A-Z]\w*) = ")
TYPE = re.compile(r"(?:template <.*>\s*)?(?:class|struct|enum class|enum) (\w+)(?!.*;$)")
ALIAS = re.compile(r"using (\w+) = (.*)")
TAKEN = re.compile(r"using ([\w:]+::(\w+));")  # from another namespace
VARIABLE = re.compile(r"(?:const |static )+[\w:<>]+ (\w+)(?:\{| =)")
FUNCTION = re.compile(r"(?!namespace|using|TEST|INSTANTIATE|return|template|\}|#|/)"
                      r"(?:\[\[\w+\]\] )?[A-Za-z_][\w:<>,&* ]*?[\s&*](\w+)\((.*)")


def parameter_types(text):
    """Types of a list of parameters, from behind its opening bracket."""
    parts, part, depth = [], "", 0
    for letter in text:
        depth += (letter in "<({[") - (letter in ">)}]")
        if depth < 0:
            break
        if letter == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += letter
    parts.append(part)
    return tuple(re.sub(r"\s*=.*", "", p).strip().rpartition(" ")[0] for p in parts if p.strip())


def names(text):
    """Each name that a file's unnamed namespaces define, with what else has to differ."""
    lines, inside = re.sub(r"Handle\((\w+)\)", r"Handle_\1", text).split("\n"), False
    for i, line in enumerate(lines):
        if line == "namespace {":
            inside = True
        elif line == "}  // namespace":
            inside = False
        elif not inside:
            continue
        elif found := CONSTANT.match(line):
            for name in (found[1], *MORE_CONSTANTS.findall(line)):
                yield name, "value"
        elif found := TYPE.match(line):
            yield found[1], "value"
        elif found := ALIAS.match(line):
            yield found[1], found[2]
        elif found := TAKEN.match(line):
            yield found[2], found[1]
        elif found := VARIABLE.match(line):
            yield found[1], "value"
        elif found := FUNCTION.match(line):
            yield found[1], parameter_types(" ".join([found[2], *map(str.strip, lines[i + 1:i + 8])]))


def clashes(kinds):
    """Whether sources with these kinds of one name cannot be compiled together."""
    if all(isinstance(kind, tuple) for kind in kinds):
        return len(set(kinds)) < len(kinds)
    return len(set(kinds)) > 1 or "value" in kinds


def faults(files):
    places = collections.defaultdict(dict)
    for path, text in sorted(files.items()):
        folder, _, file = path.rpartition("/")
        for name, kind in names(text):
            places[folder, name].setdefault(file, []).append(kind)
    for (folder, name), in_files in sorted(places.items()):
        # Within a file the compiler looks.
        kinds = [kind for file in in_files.values() for kind in set(file)]
        if len(in_files) > 1 and clashes(kinds):
            yield f"{folder}: {name} is in the unnamed namespaces of " + " and of ".join(in_files)


def sources(root):
    paths = (path for folder in FOLDERS for path in (root / folder).rglob("*.cpp"))
    relative = {path.relative_to(root).as_posix(): path for path in paths}
    return {name: path.read_text(encoding="utf-8") for name, path in relative.items() if not ALONE.fullmatch(name)}


def main():
    files = sources(Path(sys.argv[1]))
    count = sum(1 for text in files.values() for _ in names(text))
    if count < 1000:
        print(f"only {count} names found below {sys.argv[1]}")
        return 1
    if "--self-test" in sys.argv:
        path = next(path for path, text in sorted(files.items()) if list(names(text)))
        again = {path.replace(".cpp", "_again.cpp"): files[path]}
        found = [] if list(faults({**files, **again})) else [f"a second {path} is not found"]
    else:
        found = list(faults(files))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
