#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pages and comments name is there: files, headings and links.

    page_names_test.py ROOT              checks the tree, exit code 1 if something is not there
    page_names_test.py ROOT --self-test  checks that broken pages are found

A file is named by its path from the root, from the folder of the page or comment, or by its last
name alone if some file has it. A heading is named as in: `core/curves/README.md`, "Two curves".
And what users call has a line in a table: each header at the top of `core` and of `adapters/occt`.
"""
import re
import sys
from pathlib import Path, PurePosixPath

SOURCES = (".h", ".cpp", ".inc", ".py", ".sh", ".cmake", "CMakeLists.txt")
NAME = re.compile(r"(?<![\w/.$}{*<>#-])((?:[\w.-]+/)*[\w-]+\.(?:h|cpp|inc|py|sh|cmake|md|svg))\b")
FOLDER = re.compile(r"`((?:core|adapters|plugin|tests|samples)/[\w/-]*)`")
HEADING = re.compile(r'`([\w/.-]+\.md)`, "([^"]+)"')
LINK = re.compile(r"\]\(([^)\s]+)\)")
MADE = ("build/",)  # by building
FOR_USERS = ("core", "adapters/occt")


def comments(path, text):
    """The comments of a source, line by line; other lines are empty."""
    mark = "//" if path.endswith((".h", ".cpp", ".inc")) else "#"
    for line in text.splitlines():
        before, found, comment = line.partition(mark)
        yield comment if found and '"' not in before else ""


def lines_of(path, text):
    return text.splitlines() if path.endswith(".md") else comments(path, text)


def without_fences(text):
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def normal(path):
    """The path without steps up."""
    parts = []
    for part in PurePosixPath(path).parts:
        if part == ".." and parts:
            parts.pop()
        elif part != ".":
            parts.append(part)
    return "/".join(parts)


def anchor(heading):
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def headings(text):
    return [line.lstrip("#").strip() for line in without_fences(text).splitlines() if re.match(r"#+ ", line)]


def missing_names(files, path, text, known, last_names, folders):
    folder = path.rpartition("/")[0]
    for number, line in enumerate(lines_of(path, text), 1):
        for name in NAME.findall(line):
            here = normal(f"{folder}/{name}".lstrip("/"))
            there = name in known or here in known or ("/" not in name and name in last_names)
            if not there and not name.startswith(MADE):
                yield f"{path}:{number} names {name}, which is not there"
        for name in FOLDER.findall(line):
            stem = name.rstrip("/")
            if stem not in folders and f"{stem}.h" not in known and f"{stem}.cpp" not in known:
                yield f"{path}:{number} names {name}, which is not there"
        for page, heading in HEADING.findall(line):
            if page in files and heading not in headings(files[page]):
                yield f"{path}:{number} names {heading!r} in {page}, which has no such heading"


def missing_links(files, path, text, known, folders):
    folder = path.rpartition("/")[0]
    for link in LINK.findall(without_fences(text)):
        if "://" in link:
            continue
        page, _, place = link.partition("#")
        target = normal(f"{folder}/{page}".lstrip("/")) if page else path
        if target not in known and target.rstrip("/") not in folders:
            yield f"{path} links to {link}, which is not there"
        elif place and target in files and place not in map(anchor, headings(files[target])):
            yield f"{path} links to {link}, which has no such heading"


def missing_lines(files, known):
    """Headers for users without a line in a table of their folder's page."""
    for folder in FOR_USERS:
        rows = [line for line in files[f"{folder}/README.md"].splitlines() if line.startswith("|")]
        for path in sorted(known):
            above, _, name = path.rpartition("/")
            if above == folder and name.endswith(".h") and not any(f"`{name}`" in row for row in rows):
                yield f"{folder}/README.md has no line for {name}, which users call"


def faults(files, known):
    """files: texts by path; known: all paths, those without text, too."""
    last_names = {name.rpartition("/")[2] for name in known}
    folders = {str(folder) for name in known for folder in PurePosixPath(name).parents}
    for path, text in sorted(files.items()):
        if path.endswith(".md") or path.endswith(SOURCES):
            yield from missing_names(files, path, text, known, last_names, folders)
        if path.endswith(".md"):
            yield from missing_links(files, path, text, known, folders)
    yield from missing_lines(files, known)


def tree(root):
    folders = ("core", "adapters", "plugin", "tests", "samples", ".ci", "LICENSES")
    paths = [path for folder in folders for path in (root / folder).rglob("*") if path.is_file()]
    paths += [path for path in root.iterdir() if path.is_file()]
    known = {path.relative_to(root).as_posix() for path in paths}
    files = {
        name: (root / name).read_text(encoding="utf-8", errors="replace")
        for name in known
        if name.endswith((".md",) + SOURCES) and "__pycache__" not in name
    }
    return files, known


def self_test(files, known):
    """Each kind of fault, put into the tree, is found."""
    broken = {
        "a path in a page": {"core/added.md": "See `core/math/not_there.h`.\n"},
        "a name in a comment": {"core/added.cpp": "// as in not_there.h\n"},
        "a folder in a page": {"core/added.md": "See `core/not_there`.\n"},
        "a link": {"core/added.md": "[here](math/not_there)\n"},
        "an anchor": {"core/added.md": "[here](README.md#not-there)\n"},
        "a heading": {"core/math/added.h": '/// Source: `core/README.md`, "Not there".\n'},
        "a header for users": {"adapters/occt/added.h": ""},
    }
    before = set(faults(files, known))
    return [what for what, added in broken.items()
            if not set(faults({**files, **added}, known | set(added))) - before]


def main():
    files, known = tree(Path(sys.argv[1]))
    if len(files) < 100:
        print(f"only {len(files)} files found below {sys.argv[1]}")
        return 1
    found = ([f"not found: {what}" for what in self_test(files, known)] if "--self-test" in sys.argv
             else list(faults(files, known)))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
