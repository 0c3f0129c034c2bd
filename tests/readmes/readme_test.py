# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs every block of code of a README as it stands there, in a folder with the sample's files and
an environment that is empty but for what installing gives; and follows its links.

A block runs in the way of its language: sh, python, tcl (in DRAW), and cmake with the cpp after it.
cpp alone is a source of the program and is compiled; text is what users write elsewhere.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

parser = argparse.ArgumentParser()
parser.add_argument("readme")
for option in ("source", "version", "folder", "program", "parts", "draw", "installed", "occt"):
    parser.add_argument("--" + option, required=True)
given = parser.parse_args()
folder = Path(given.folder)

# Lines that build, install or pack: what runs them instead.
ELSEWHERE = {
    "samples/run.sh": "people and continuous integration",
    "tests/run.sh": "this test is a part of it",
    "export PATH=$PWD/build/release/plugin/cli:$PATH && cd build/samples": "this test's own PATH and folder",
    "cmake --build build/release --target installable": "tests/package.sh",
    "sudo cmake --install build/release": "install.staged",
    "cpack --config build/release/CPackConfig.cmake": "tests/package.sh",
    f"sudo apt install ./build/release/blossom_{given.version}_amd64.deb": "tests/package.sh",
    "cmake --build build/release --target blossom test_plugin_cli": "who adds a command",
    "build/release/plugin/cli/blossom area build/samples/block.step": "who adds a command",
    "build/release/tests/plugin/cli/test_plugin_cli --gtest_filter='Area*'": "who adds a command",
    "python3 -m blossom.distributed jobs.jsonl -o results.jsonl --scheduler tcp://10.0.0.1:8786":
        "who has a cluster; with one of its own python.distributed",
}
# Exit code 3 is an answer that is right within tolerances.
SHELL = "trap 'code=$?; [ $code -eq 3 ] || exit $code' ERR\n"


def claim(what, holds):
    if not holds:
        sys.exit(f"does not hold: {given.readme}: {what}")
    print("holds:", what)


def run(command, what, **environment):
    environment = {
        "PATH": f"{Path(given.program).parent}:/usr/bin:/bin",
        "HOME": str(folder),
        **environment,
    }
    done = subprocess.run(
        command, cwd=folder, env=environment, text=True, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    print(done.stdout)
    claim(f"{what} succeeds", done.returncode == 0)
    return done.stdout


def run_shell(block):
    lines = []
    for line in block.splitlines():
        command = line.partition(" #")[0].strip()
        if command in ELSEWHERE:
            print(f"left to {ELSEWHERE[command]}: {command}")
        else:
            lines.append(line)
    run(["bash", "-c", SHELL + "\n".join(lines)], "\n".join(lines), PYTHONPATH=packages())
    for file in re.findall(r"(?:-o|--json|--picture|--html|--glb) ([^ \n'-]\S*)", "\n".join(lines)):
        claim(f"{file} was written", (folder / file).stat().st_size > 0)


def packages():
    return str(next(Path(given.installed).glob("lib/python3*/*-packages")))


def run_python(block):
    if given.readme == "plugin/freecad/README.md":  # wants the window and a selection
        print("left to freecad.window")
        return
    run([sys.executable, "-B", "-c", block], block, PYTHONPATH=packages())


# DRAW always exits with 0, so the last word tells.
CAUGHT = """
if {{[catch {{
{block}
}} problem]}} {{ puts $problem }} else {{ puts ALL-RAN }}
"""


def run_in_draw(block):
    if not Path(given.draw).exists():
        print("left out: DRAW is not installed")
        return
    (folder / "block.tcl").write_text(CAUGHT.format(block=block))
    out = run(
        [given.draw, "-b", "-f", "block.tcl"],
        block,
        CSF_BlossomPluginDefaults=f"{given.installed}/share/opencascade/resources/DrawResources",
        LD_LIBRARY_PATH=f"{given.installed}/lib",
    )
    claim("no line of it failed", "ALL-RAN" in out)


# The lines of C++ with what they speak of around them.
PROGRAM = """
#include <TopoDS_Face.hxx>
{includes}
template <class... Values>
void use(const Values&...) {{}}
void lines(const TopoDS_Face& face_a, const TopoDS_Face& face_b) {{
{body}
}}
int main() {{}}
"""
PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(Readme LANGUAGES CXX)
add_executable(my_program my_program.cpp)
"""


def build_program(cmake, cpp):
    includes = "\n".join(re.findall(r"^#include.*$", cpp, re.MULTILINE))
    body = re.sub(r"^#include.*$", "", cpp, flags=re.MULTILINE)
    (folder / "my_program.cpp").write_text(PROGRAM.format(includes=includes, body=body))
    (folder / "CMakeLists.txt").write_text(PROJECT + cmake)
    run(["cmake", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={given.installed}"], cmake)
    run(["cmake", "--build", "build"], cpp)


def compile_source(block):
    (folder / "source.cpp").write_text(block)
    command = f"c++ -std=c++20 -fsyntax-only -I {given.source} -isystem {given.occt} source.cpp"
    run(command.split(), "compiling it")


# Job lists and a folder of parts, as one has who reads of them.
def lay_out_jobs():
    (folder / "parts").mkdir()
    (folder / "brep").mkdir()
    for part in ("block", "drill"):
        (folder / "parts" / f"{part}.step").write_bytes((folder / f"{part}.step").read_bytes())
    (folder / "jobs.jsonl").write_text(
        json.dumps({"id": "hull", "arguments": ["info", "hull.step", "--json", "-"]}) + "\n"
    )


RUNNERS = {"sh": run_shell, "python": run_python, "tcl": run_in_draw}


def main():
    subprocess.run(["rm", "-rf", folder], check=True)
    folder.mkdir(parents=True)
    subprocess.run([given.parts, folder], check=True)
    lay_out_jobs()

    text = (Path(given.source) / given.readme).read_text()
    blocks = re.findall(r"^```(\w*)\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    cmake = ""
    for language, block in blocks:
        if language == "cmake":
            cmake = block
        elif language == "cpp":
            build_program(cmake, block) if cmake else compile_source(block)
        elif language == "text":
            print("left to who writes it")
        else:
            claim(f"'{language}' is a language this test can run", language in RUNNERS)
            RUNNERS[language](block)

    beside = (Path(given.source) / given.readme).parent
    for link in re.findall(r"\]\(([^)#]+)", text):
        claim(f"{link} is there", "://" in link or os.path.exists(beside / link))


main()
