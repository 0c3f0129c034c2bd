# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same questions to the program `blossom`, over files in a folder of their own."""

import json
import math
import os
import re
import shutil
import subprocess
import tempfile

import Mesh
import Part

from .answers import Answer, niceness, with_segments

# Exit codes of the program that come with an answer: complete, within tolerance, stopped, findings.
ANSWERED = (0, 3, 4, 5)
PAUSE = 0.02  # seconds between looks whether the work was cancelled


class Cancelled(RuntimeError):
    """The work was ended by `cancel`."""


class ProgramDoor:
    """Questions that `cancel` ends with `Cancelled`. What is held may be asked about in any
    thread."""

    Cancelled = Cancelled

    def __init__(self, program):
        self._program = program
        self._folder = tempfile.TemporaryDirectory(prefix="blossom-")
        self._files = 0
        self._cancelled = False

    def cancel(self):
        self._cancelled = True

    def hold(self, shape, name):
        """A shape of Part as a file; messages call it by the name."""
        file = self._new_file("brep", name)
        try:  # exportBrep does not tell of a full disk
            with open(file, "w", encoding="ascii") as stream:
                stream.write(shape.exportBrepToString())
        except OSError as error:
            raise OSError(f"{name}: {file} cannot be written: {error.strerror}") from None
        return file

    def sewn(self, shape, name):
        """The shape with its loose faces as the solids that they close."""
        return self._ask(["convert", self.hold(shape, name)], {}).shape

    def intersect(self, a, b, **options):
        return self._ask(["intersect", a, b], options)

    def sections(self, part, planes, **options):
        return self._ask(["query", "plane", part, "--planes", self._listed(planes)], options)

    def draw_sections(self, part, planes, file, **options):
        """Writes a drawing, .dxf or .svg."""
        command = ["query", "plane", part, "--planes", self._listed(planes)]
        answer = self._ask(command, options, ending=file.rsplit(".", 1)[-1].lower())
        if not any(plane["parts"] for plane in answer.report["planes"]):
            raise ValueError(f"{file}: there is nothing to draw, since no plane meets the model")
        shutil.move(answer.shape, file)

    def _listed(self, planes):
        """A file of planes."""
        listed = self._new_file("txt")
        with open(listed, "w", encoding="utf-8") as stream:
            stream.writelines(f"{_numbers(point)},{_numbers(n)}\n" for point, n in planes)
        return listed

    def trim(self, part, tools, keep, **options):
        return self._ask(["trim", part, *tools, "--keep", str(keep)], options)

    def solid(self, operation, part, tools, **options):
        return self._ask(["trim", "--solid", operation, part, *tools], options)

    def check(self, part):
        return self._ask(["check", part], {}, makes_shape=False)

    def strip(self, a, b, edge_a, edge_b, continuity, weight_a, weight_b):
        command = ["blend", "strip", a, b, "--continuity", continuity]
        for name, value in (("--edge-a", edge_a), ("--edge-b", edge_b)):
            command += [] if value is None else [name, str(value)]
        return self._ask(command + ["--weight-a", repr(weight_a), "--weight-b", repr(weight_b)], {})

    def fillet(self, part, edges, section, partial, radius=None, full_round=False, **options):
        size = ["--section", section]
        if full_round:
            return self._blend("fillet", part, edges, [*size, "--full-round"], partial, options)
        own = dict(radius) if isinstance(radius, dict) else {None: radius}
        size += ["--radius", _size(own.pop(None))]
        for edge, each in own.items():
            size += ["--edge", f"{edge}:{_size(each)}"]
        return self._blend("fillet", part, edges, size, partial, options)

    def chamfer(self, part, edges, distance, partial, angle=None, **options):
        both = distance if isinstance(distance, tuple) else (distance,)
        size = ",".join(map(repr, both)) + ("" if angle is None else f":{math.degrees(angle)!r}")
        return self._blend("chamfer", part, edges, ["--distance", size], partial, options)

    def _blend(self, kind, part, edges, size, partial, options):
        chosen = ["--edges", edges] if edges == "all" else ["--edge", ",".join(map(str, edges))]
        more = [*chosen, *size] + (["--partial"] if partial else [])
        return self._ask(["blend", kind, part, *more], options)

    def clash(self, a, b, clearance, **options):
        files = [a] if b is None else [a, b]
        wanted = [] if clearance is None else ["--clearance", repr(clearance)]
        return self._ask(["clash", *files, *wanted], options)

    def mesh(self, part, **options):
        answer = self._ask(["convert", part], options, ending="obj")
        file = answer.shape
        groups = list(_groups_of(file))
        report = {**answer.report, "groups": groups}
        return Answer(with_segments(Mesh.Mesh(file), groups), report)

    def subdivide(self, part, rectangle, levels):
        place = ["--rectangle", *map(repr, rectangle), "--levels", str(levels)]
        return self._ask(["subdivide", part, *place], {})

    def fill(self, part, edges, continuity, sew, **options):
        command = ["blend", "fill", part, "--continuity", continuity] + (["--sew"] if sew else [])
        command += ["--edges", ",".join(map(str, edges))] if edges else []
        return self._ask(command, options)

    def _new_file(self, ending, name=""):
        self._files += 1
        return os.path.join(self._folder.name, f"{name or self._files}.{ending}")

    def _ask(self, command, options, makes_shape=True, ending="brep"):
        """The answer; its shape is the name of the file unless that is a BREP."""
        made, report, errors = (self._new_file(end) for end in (ending, "json", "txt"))
        for name, value in options.items():
            if name == "angle":  # the program takes degrees
                value = math.degrees(value)
            command = [*command, f"--{name.replace('_', '-')}", repr(value)]
        output = ["-o", made] if makes_shape else []
        with open(errors, "w", encoding="utf-8") as stream:
            code = self._run([self._program, *command, *output, "--json", report, "-q"], stream)
        if not os.path.exists(report) or (code not in ANSWERED and os.path.getsize(report) == 0):
            with open(errors, encoding="utf-8", errors="replace") as stream:
                raise ValueError(self._message(stream.read()) or f"{command[0]} failed: {code}")
        with open(report, encoding="utf-8") as stream:
            told = json.load(stream)
        shape = None
        if ending != "brep":
            shape = made
        elif os.path.exists(made):
            shape = Part.Shape()
            shape.importBrep(made)
        elif makes_shape and command[0] == "intersect":
            shape = Part.makeCompound([])  # the program writes no empty model
        return Answer(shape, told)

    def _message(self, said):
        """What the program says, as if it were about shapes."""
        lines = [line for line in said.splitlines() if not line.startswith("see 'blossom ")]
        text = "\n".join(lines).replace(self._folder.name + os.sep, "")
        return re.sub(r"(\w)\.brep\b", r"\1", text).replace("blossom: ", "", 1)

    def _run(self, command, errors):
        with subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors
        ) as process:
            _give_way(process)
            while True:
                try:
                    return process.wait(PAUSE)
                except subprocess.TimeoutExpired:
                    if self._cancelled:
                        process.terminate()
                        process.wait()
                        raise Cancelled("the work was cancelled") from None


def _give_way(process):
    """(Where a system has priorities; it is no harm if that is not to be had.)"""
    try:
        os.setpriority(os.PRIO_PROCESS, process.pid, os.getpriority(os.PRIO_PROCESS, 0) + niceness())
    except (AttributeError, OSError):
        pass


def _groups_of(file):
    """Pairs of a face's number and the place of its first triangle, of an .obj file."""
    triangles = 0
    with open(file, encoding="utf-8") as stream:
        for line in stream:
            if line.startswith("g "):
                yield int(line.rsplit("Face", 1)[1]), triangles
            triangles += line.startswith("f ")


def _size(radius):
    """A radius, or a pair of them."""
    both = radius if isinstance(radius, tuple) else (radius,)
    return "..".join(map(repr, both))


def _numbers(vector):
    return ",".join(repr(float(x)) for x in vector)
