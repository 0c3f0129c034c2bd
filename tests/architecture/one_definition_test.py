#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every type of a namespace is defined in one place, and every function of a header is in one header.

    one_definition_test.py ROOT              checks the tree, exit code 1 if a name has two definitions
    one_definition_test.py ROOT --self-test  checks that a second definition is found

Two different types of one name in one program are undefined behaviour that no compiler has to
report, and so are two functions of one name and the same parameters, if one of them is inline. Those in
unnamed namespaces belong to their source alone and are left out.
"""
import re
import sys
from pathlib import Path

from room_names_test import parameter_types

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'',
                             re.DOTALL)
TOKEN = re.compile(r"namespace(?:\s+[\w:]+)?\s*\{"
                   r"|(?:template\s*<>\s*)?(?:struct|class|enum\s+class|enum|union)\s+(?:alignas\([^)]*\)\s*)?"
                   r"[A-Za-z_]\w*(?:<[^;{}()]*>)?(?:\s+final)?\s*(?::[^;{}()]*)?\{"
                   r"|\{|\}")

FUNCTION = re.compile(r"(?:\[\[\w+\]\] )?(?!namespace|using|return|template|struct|class|enum|extern|typedef|static)"
                      r"[A-Za-z_][\w:<>,&* ]*?[\s&*](\w+)\((.*)")


def definitions(text):
    """Qualified names of the types that a file defines at the level of a namespace."""
    scopes = []
    for token in TOKEN.finditer(COMMENT_OR_TEXT.sub(" ", text)):
        word = token.group()
        if word == "}":
            if scopes:
                scopes.pop()
        elif word.startswith("namespace"):
            name = word[len("namespace"):-1].strip()
            scopes.append(("namespace", name))
        elif word == "{":
            scopes.append(("block", ""))
        else:
            if all(kind == "namespace" and name for kind, name in scopes):
                name = re.sub(r"^(template\s*<>\s*)?(struct|class|enum\s+class|enum|union)\s+(alignas\([^)]*\)\s*)?",
                              "", word)
                name = re.split(r"\s*(?:\bfinal\b|:(?!:)|\{)", name)[0].strip()
                yield "::".join([part for _, part in scopes] + [name])
            scopes.append(("block", ""))


def functions(text):
    """Namespace, name and types of parameters of the functions that begin a line of a header. Templates are
    left out: what is declared in one is often defined in another."""
    lines, scope = text.split("\n"), ""
    for i, line in enumerate(lines):
        if found := re.match(r"namespace ([\w:]+) \{", line):
            scope = found[1]
        elif scope and not lines[i - 1].startswith("template") and (found := FUNCTION.match(line)):
            types = parameter_types(" ".join([found[2], *map(str.strip, lines[i + 1:i + 8])]))
            yield f"{scope}::{found[1]}({', '.join(types)})"


def faults(files):
    places = {}
    for path, text in sorted(files.items()):
        for name in definitions(text):
            places.setdefault(name, []).append(path)
        if path.endswith(".h"):
            for name in set(functions(text)):
                places.setdefault(name, []).append(path)
    for name, paths in sorted(places.items()):
        if len(paths) > 1:
            yield f"{name} is defined in " + " and in ".join(paths)


def sources(root):
    """Libraries and doors; a test has its own program, and names there may return."""
    return {
        str(path.relative_to(root)): path.read_text(encoding="utf-8")
        for folder in ("core", "adapters", "plugin")
        for path in (root / folder).rglob("*")
        if path.suffix in (".h", ".cpp")
    }


def main():
    files = sources(Path(sys.argv[1]))
    names = [name for text in files.values() for name in definitions(text)]
    if len(names) < 300:
        print(f"only {len(names)} types found below {sys.argv[1]}")
        return 1
    if "--self-test" in sys.argv:
        again = {
            "a second Tolerances": "namespace blossom {\n/// Twice.\nstruct Tolerances {\n};\n}\n",
            "a second overlap":
                "namespace blossom {\ninline bool overlap(const Interval& x,\n        const Interval& y) {\n}\n}\n",
        }
        found = [f"{what} is not found" for what, text in again.items()
                 if not list(faults({**files, "core/base/added.h": text}))]
    else:
        found = list(faults(files))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
