# SPDX-License-Identifier: LGPL-2.1-or-later
"""What happens to objects with their documents: undo, save and open again, deleted parents, closed
documents, work that is cancelled. Without a window."""

import contextlib
import ctypes
import os
import signal
import sys
import tempfile
import threading

import FreeCAD
import Part

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from claims import claim, near, run, says, valid  # noqa: E402
from freecad.blossom import (  # noqa: E402
    door, drawing, feature, kinds, make, work,
)  # fmt: skip

V = FreeCAD.Vector


def box_and_rod(document):
    """In containers; the rod goes through the box."""
    block = document.addObject("Part::Box", "Block")
    rod = document.addObject("Part::Cylinder", "Rod")
    rod.Height = 20
    holder = document.addObject("App::Part", "Holder")
    holder.addObject(rod)
    holder.Placement.Base = V(5, 5, -5)
    return (block, ""), (holder, "Rod.")


def one_of_each(document):
    """By names."""
    block, rod = box_and_rod(document)
    sheet = document.addObject("Part::Plane", "Sheet")
    sheet.Placement.Base = V(20, 0, 0)
    return {
        "curves": make.intersection(document, block, rod),
        "cut": make.section(document, block, Point=V(0, 0, 5), Count=2),
        "trimmed": make.trim(
            document, (block[0], "Face6"), rod, Keep="picked", Picked=[V(5, 5, 10)]
        ),
        "made": make.solid(document, "fuse", block, rod),
        "strip": make.blend_strip(document, (block[0], "Face6"), (sheet, "Face1")),
        "patch": make.sub_patch(document, (sheet, "Face1"), UTo=0.5, Levels=1),
        "filled": make.fill(
            document, [(sheet, ("Edge1", "Edge2", "Edge3", "Edge4"))], Continuity="G0"
        ),
        "rounded": make.fillet(document, (block[0], "Edge1"), Radius="2 mm"),
        "cut off": make.chamfer(document, (block[0], "Edge2"), Distance="2 mm"),
        "checked": make.check(document, rod),
        "clashing": make.clash(document, [block, rod]),
        "meshed": make.mesh(document, rod, Deviation="0.1 mm"),
    }


def told(obj):
    """All that an object has found."""
    facts = [getattr(obj, fact.name) for fact in obj.Proxy.FACTS]
    if not hasattr(obj, "Shape"):
        mesh, box = obj.Mesh, obj.Mesh.BoundBox
        return facts, mesh.Area, mesh.Volume, box.ZMin, box.ZMax, mesh.CountFacets
    return facts, obj.Shape.Length, obj.Shape.Area, len(obj.Shape.Faces), len(obj.Shape.Edges)


def saved_documents_open_with_the_same_results(document):
    made = one_of_each(document)
    document.recompute()
    claim("there is one of each kind", len(made) == len(kinds.KINDS))
    claim("all can be computed", all(valid(obj) for obj in made.values()))
    before = {obj.Name: told(obj) for obj in made.values()}
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "objects.FCStd")
        document.saveAs(file)
        FreeCAD.closeDocument(document.Name)
        again = FreeCAD.openDocument(file)
    try:
        claim("they are there when it is opened", _all_alike(again, before))
        for name in before:
            again.getObject(name).touch()
        again.recompute()
        claim("and the same when computed again", _all_alike(again, before))
        volume = again.Solid.Volume
        again.Block.Length = 12
        again.recompute()
        claim("they still follow their parents", near(again.Solid.Volume - volume, 200))
    finally:
        FreeCAD.closeDocument(again.Name)


def _all_alike(document, before):
    return all(_alike(told(document.getObject(name)), before[name]) for name in before)


def one_undo_takes_an_object_away(document):
    block, rod = box_and_rod(document)
    document.recompute()
    document.openTransaction("Blossom")
    make.intersection(document, block, rod)
    document.recompute()
    document.commitTransaction()
    claim("it is there", document.getObject("Intersection") is not None)
    document.undo()
    claim("it is gone", document.getObject("Intersection") is None)
    document.redo()
    document.recompute()
    claim("it is back", valid(document.Intersection) and document.Intersection.Curves == 2)


def deleted_parents_are_errors_of_the_object(document):
    block, rod = box_and_rod(document)
    other = document.addObject("Part::Box", "Other")
    other.Length = other.Width = other.Height = 2
    curves = make.intersection(document, block, rod)
    made = make.solid(document, "cut", block, [rod, (other, "")])
    document.recompute()
    claim("both are computed", valid(curves) and valid(made))
    volume = made.Volume
    document.openTransaction("Delete")
    document.removeObject("Other")
    document.commitTransaction()
    document.recompute()
    claim(
        "a tool that was deleted is an error, not another result",
        says(made, "Tools: Other was deleted"),
    )
    claim("the others go on", valid(curves))
    document.undo()
    document.recompute()
    claim("undo brings it back", valid(made) and made.Volume == volume)
    document.removeObject("Other")
    document.recompute()
    made.Tools = [(rod[0], "Rod."), (document.Block, "Face1")][:1]
    document.recompute()
    claim("the same tools again are not chosen anew", not valid(made))
    made.Proxy.forget_links(made)
    document.recompute()
    claim("until they are said to be meant", valid(made) and made.Volume > 0)
    document.removeObject("Rod")
    document.recompute()
    claim("one inside of a container, too", says(curves, "B: Rod. of Holder is gone"))
    document.removeObject("Block")
    document.recompute()
    claim("and the only one", says(curves, "A: Block was deleted"))
    claim("the document can be saved", _can_be_saved(document))


def _can_be_saved(document):
    with tempfile.TemporaryDirectory() as folder:
        document.saveCopy(os.path.join(folder, "copy.FCStd"))
        return os.listdir(folder) == ["copy.FCStd"]


def wrong_inputs_are_errors_of_the_object(document):
    point = document.addObject("Part::Vertex", "Point")
    block, rod = box_and_rod(document)
    curves = make.intersection(document, (point, ""), rod)
    document.recompute()
    claim("a point has no edge", says(curves, "A: faces or edges are wanted, Point has none"))
    curves.A = []
    document.recompute()
    claim("nothing is too little", says(curves, "A: a face or an edge is wanted, and there is none"))
    group = document.addObject("App::DocumentObjectGroup", "Group")
    curves.A = [(group, "")]
    document.recompute()
    claim("a group has no shape", says(curves, "A: Group has no shape"))
    curves.A, curves.Tolerance = [block], 0
    document.recompute()
    claim("a tolerance of 0 is none", says(curves, "tolerance: 0.0 is not positive"))
    curves.Tolerance = "1e-7 mm"
    document.recompute()
    claim("all can be mended", valid(curves))
    try:
        curves.A = 3
        claim("a number is no link", False)
    except TypeError:
        pass


def answers_of_closed_documents_do_no_harm(document):
    block, rod = box_and_rod(document)
    curves = make.intersection(document, block, rod)
    document.recompute()
    job = curves.Proxy.question(curves).job()
    FreeCAD.closeDocument(document.Name)
    job.start()
    job.join()
    claim("work goes on without its document", job.answer().report["status"] == "complete")
    try:
        curves.Shape
        claim("its object is gone", False)
    except ReferenceError:
        pass


class Endless(feature.Feature):
    started = threading.Event()

    def ask(self, entrance, inputs, options):
        self.started.set()
        while True:  # until the door is closed
            entrance.intersect(*inputs["Both"])

    def inputs(self, obj):
        return {"Both": [Part.makeBox(10, 10, 10), Part.makeCylinder(2, 20, V(5, 5, -5))]}


def endless(document):
    obj = document.addObject("Part::FeaturePython", "Endless")
    Endless(obj)
    Endless.started.clear()
    return obj


def control_c_is_an_error_of_the_object(document):
    # Shells let what they start in the background ignore it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    obj = endless(document)
    hit = threading.Thread(
        target=lambda: (Endless.started.wait(), os.kill(os.getpid(), signal.SIGINT))
    )
    hit.start()
    document.recompute()
    hit.join()
    claim("the work ends and FreeCAD goes on", says(obj, "interrupted by Ctrl-C"))


def work_can_be_cancelled(document):
    obj = endless(document)
    started = Endless.started
    job = obj.Proxy.question(obj).job()
    stopper = threading.Thread(target=lambda: (started.wait(), job.cancel()))
    stopper.start()
    try:
        work.answer_of(job, "Working")
        claim("it ended by itself", False)
    except job._door.Cancelled as error:
        claim("it says so", "cancelled" in str(error) and job.cancelled)
    stopper.join()


@contextlib.contextmanager
def another_open_cascade():
    """The package as it is where another Open CASCADE is loaded before it."""
    kept = {
        name: sys.modules.pop(name)
        for name in list(sys.modules)
        if name.partition(".")[0] == "blossom" or name == "freecad.blossom.door_package"
    }
    ctypes.CDLL(os.environ["BLOSSOM_OTHER_KERNEL"])
    door.choice.cache_clear()
    try:
        yield
    finally:
        sys.modules.update(kept)
        door.choice.cache_clear()


def with_another_open_cascade_the_program_answers(document):
    made = one_of_each(document)
    document.recompute()
    by_module = {name: told(obj) for name, obj in made.items()}
    with another_open_cascade():
        chosen = door.choice()
        claim("the program does", chosen[::2] == ("program", os.environ["BLOSSOM_PROGRAM"]))
        claim("and why", os.environ["BLOSSOM_OTHER_KERNEL"] in chosen.reason)
        for obj in made.values():
            obj.touch()
        document.recompute()
        for name, obj in made.items():
            claim(f"{name} by the program", valid(obj) and _alike(told(obj), by_module[name]))
        made["rounded"].Radius = 100
        document.recompute()
        claim("refusals come from there, too", says(made["rounded"], "the largest radius is"))
        made["rounded"].Radius = 1
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "cut.dxf")
            drawing.write(made["cut"], file)
            claim("and drawings", os.path.getsize(file) > 0)
        made["made"].Part = [(document.Sheet, "")]
        document.recompute()
        claim("and errors", says(made["made"], "Part is no closed solid"))
        import blossom

        claim("shapes come back", len(blossom.shape(document.Block.Shape).to_part().Solids) == 1)
        _full_disk(made["cut"])
        _neither(made["cut"])
    claim("the module is back", door.choice().kind == "module")


def _full_disk(obj):
    from blossom import _process

    room, _process.Folder.file = _process.Folder.file, lambda self, name: "/dev/full"
    try:
        obj.touch()
        obj.Document.recompute()
        for words in ("the folder of temporary files", "No space left"):
            claim("it says that there is no room", says(obj, words))
    finally:
        _process.Folder.file = room
    obj.touch()
    obj.Document.recompute()
    claim("with room it computes again", valid(obj))


def _neither(obj):
    kept, door.choice = door.choice, lambda: door.Choice("", "FreeCAD uses another Open CASCADE", "")
    try:
        obj.touch()
        obj.Document.recompute()
        claim("without both, that is said", says(obj, "engine is not here: FreeCAD uses another"))
    finally:
        door.choice = kept


def _alike(a, b):
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(_alike, a, b))
    return near(a, b, 1e-6 * max(1, abs(b))) if isinstance(a, float) else a == b


run(
    saved_documents_open_with_the_same_results,
    one_undo_takes_an_object_away,
    deleted_parents_are_errors_of_the_object,
    wrong_inputs_are_errors_of_the_object,
    answers_of_closed_documents_do_no_harm,
    work_can_be_cancelled,
    control_c_is_an_error_of_the_object,
    with_another_open_cascade_the_program_answers,
)
