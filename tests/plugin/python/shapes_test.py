# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is taken for a shape: bytes, FreeCAD's shapes themselves, other objects, nets."""

import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

import numpy as np
from support import FLOOR, HARD, HARD_OPTIONS, FreeCAD, NO_PART, Part, WALL, plane

import blossom
from blossom import _core, _shapes


def written(shape):
    """BRep text without the flags of its parts, which say in what else they are used."""
    return re.sub(r"^[01]{7}$", "", shape.exportBrepToString(), flags=re.MULTILINE)


class Exporter:
    """As CadQuery's shapes: they write BRep into a stream or a file."""

    def __init__(self, brep, takes_streams):
        self.brep = brep
        self.takes_streams = takes_streams
        self.wrapped = object()

    def exportBrep(self, target):
        if isinstance(target, str):
            with open(target, "wb") as file:
                file.write(self.brep)
        elif self.takes_streams:
            target.write(self.brep)
        else:
            raise TypeError("a file's name is wanted")
        return True


class Workplane:
    """As CadQuery's stack of objects."""

    def __init__(self, shape):
        self.objects = [shape]

    def val(self):
        return self.objects[0]


class Deleted:
    """As FreeCAD's objects after their document was closed."""

    def __getattr__(self, name):
        raise ReferenceError(f"Cannot access attribute '{name}' of deleted object")


class Objects(unittest.TestCase):
    def test_those_that_export_brep_are_taken(self):
        brep = blossom.surface(FLOOR).to_brep()
        for shape in (Exporter(brep, True), Exporter(brep, False), Workplane(Exporter(brep, True))):
            found = blossom.intersect(shape, WALL)
            self.assertEqual(len(found), 1)
            self.assertAlmostEqual(found[0].length, 2, places=9)

    def test_those_of_other_bindings_are_written_by_their_own_tools(self):
        """As shapes of build123d and pythonOCC, which export nothing themselves."""
        brep = blossom.surface(FLOOR).to_brep()
        for module, tools, member, write in (
            ("OCP.TopoDS", "OCP.BRepTools", "BRepTools", "Write_s"),
            ("OCC.Core.TopoDS", "OCC.Core.BRepTools", "breptools", "Write"),
        ):
            writer = types.SimpleNamespace(**{write: lambda _, file: pathlib.Path(file).write_bytes(brep)})
            shape = type("TopoDS_Face", (), {"__module__": module})()
            parts = tools.split(".")
            packages = {".".join(parts[:k]): types.ModuleType(parts[k - 1]) for k in range(1, len(parts))}
            stand_in = {tools: types.SimpleNamespace(**{member: writer})}
            with unittest.mock.patch.dict(sys.modules, {**packages, **stand_in}):
                for given in (shape, types.SimpleNamespace(wrapped=shape)):
                    self.assertEqual(blossom.shape(given).face_count, 1)

    def test_deleted_objects_are_told(self):
        with self.assertRaisesRegex(ValueError, "^a: the object is deleted, or its document closed$"):
            blossom.intersect(Deleted(), WALL)

    def test_results_and_models_are_shapes(self):
        model = blossom.shape(FLOOR)
        self.assertIs(blossom.shape(model), model)
        edges = blossom.intersect(model, WALL)
        self.assertAlmostEqual(blossom.distance(edges, FLOOR).distance, 0)


class Nets(unittest.TestCase):
    def test_a_spline_surface_has_knots(self):
        # x y over [0, 2]^2 in two by one spans of degrees 1 and 1.
        poles = np.array([[(i, j, i * j) for j in (0.0, 2.0)] for i in (0.0, 1.0, 2.0)])
        face = blossom.surface(
            poles, knots=([0, 1, 2], [0, 2]), multiplicities=([2, 1, 2], [2, 2]), degree=(1, 1)
        )
        cut = blossom.intersect(face, plane((0.5, 0, -1), (0, 2, 0), (0, 0, 4)))
        self.assertEqual(cut.status, "complete")
        self.assertAlmostEqual(sum(curve.length for curve in cut), np.hypot(2, 1), places=9)

    def test_weights_may_stand_apart(self):
        w = np.sqrt(0.5)
        arc = [(1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
        poles = np.array([[(x, y, z) for z in (-1.0, 1.0)] for x, y in arc])
        cylinder = blossom.surface(poles, weights=[[1, 1], [w, w], [1, 1]])
        found = blossom.intersect(cylinder, plane((-2, -2, 0), (4, 0, 0), (0, 4, 0)))
        np.testing.assert_allclose(np.hypot(*found[0].points[:, :2].T), 1, atol=1e-9)

    def test_curves_have_distances(self):
        line = blossom.curve([(0, 0, 3), (1, 0, 3)])
        self.assertAlmostEqual(line.distance(FLOOR).distance, 3)
        spline = blossom.curve(
            [(0, 0, 2), (1, 0, 4), (2, 0, 2), (3, 0, 4)],
            knots=[0, 1, 2], multiplicities=[3, 1, 3], degree=2,
        )  # fmt: skip
        self.assertAlmostEqual(spline.foot_points((0, 0, 0)).distance, 2)

    def test_bad_ones_are_told(self):
        poles = np.zeros((3, 2, 3))
        with self.assertRaisesRegex(ValueError, "along u: the multiplicities sum up to 4, 3 points"):
            blossom.surface(poles, knots=([0, 1], [0, 1]), multiplicities=([2, 2], [2, 2]), degree=(1, 1))
        with self.assertRaisesRegex(ValueError, "knots do not increase"):
            blossom.curve([(0, 0, 0), (1, 0, 0)], knots=[1, 0], multiplicities=[2, 2], degree=1)
        with self.assertRaisesRegex(ValueError, "knots, multiplicities and degree go together"):
            blossom.curve([(0, 0, 0), (1, 0, 0)], knots=[0, 1])
        with self.assertRaisesRegex(ValueError, "a weight is not positive"):
            blossom.curve([(0, 0, 0), (1, 0, 0)], weights=[1, 0])
        with self.assertRaisesRegex(ValueError, "^weights: one for each pole"):
            blossom.curve([(0, 0, 0), (1, 0, 0)], weights=[1])
        with self.assertRaisesRegex(ValueError, "not finite"):
            blossom.curve([(0, 0, 0), (1, 0, np.inf)])
        with self.assertRaisesRegex(ValueError, r"got \(3,\)"):
            blossom.intersect(np.zeros(3), WALL)

    def test_what_is_no_list_is_told(self):
        line = [(0, 0, 0), (1, 0, 0)]
        for words, wrong in (
            ("^knots: a list of numbers is wanted, got int$", {"knots": 3, "multiplicities": [2, 2]}),
            ("^multiplicities: a list of numbers is wanted, got int$", {"knots": [0, 1], "multiplicities": 3}),
        ):
            with self.assertRaisesRegex(TypeError, words):
                blossom.curve(line, degree=1, **wrong)
        with self.assertRaisesRegex(TypeError, "^knots, along u: a list of numbers is wanted, got int$"):
            blossom.surface([line, line], knots=(1, 2), multiplicities=([2, 2], [2, 2]), degree=(1, 1))
        with self.assertRaisesRegex(ValueError, "^poles: the rows are not all of one length$"):
            blossom.curve([(0, 0, 0), (1, 0)])


@unittest.skipIf(Part is None, NO_PART)
class FreeCADShapes(unittest.TestCase):
    def test_one_may_be_the_first_use_of_freecad(self):
        """Part ends the process if FreeCAD itself was not imported before it."""
        lines = f"""if True:
            import sys
            sys.path = {sys.path!r}
            import blossom
            print(blossom.surface([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 1)]]).to_part().Area)
        """
        said = subprocess.run([sys.executable, "-c", lines], capture_output=True, text=True)
        self.assertEqual((said.returncode, said.stdout[:4]), (0, "1.28"), said.stderr)

    def test_they_come_and_go_without_a_copy(self):
        if not _shapes._has_bridge(Part):
            self.skipTest("there is no bridge")
        box = Part.makeBox(1, 2, 3)
        again = blossom.shape(box).to_part()
        self.assertTrue(again.isSame(box))
        self.assertTrue(all(a.isSame(b) for a, b in zip(again.Faces, box.Faces)))

    def test_bytes_serve_without_a_bridge(self):
        box = Part.makeBox(1, 2, 3)
        model = _core.read_bytes(_shapes._part_brep(box), "box", True)
        self.assertEqual(model.face_count, 6)

    def test_answers_that_found_nothing_are_empty_compounds(self):
        box, far = Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, FreeCAD.Vector(5, 5, 5))
        around = Part.makeBox(3, 3, 3, FreeCAD.Vector(-1, -1, -1))
        model = blossom.shape(box)
        for answer in (
            model.intersect(far),
            model.solid("common", far),
            model.solid("cut", around),
            model.trim(around, keep="outside"),
            model.clash(far),
            pickle.loads(pickle.dumps(model.solid("common", far))),
        ):
            shape = answer.to_part()
            self.assertEqual((shape.ShapeType, shape.childShapes()), ("Compound", []), answer)

    def test_they_are_not_changed(self):
        box = Part.makeBox(1, 2, 3)
        before = written(box)
        model = blossom.shape(box)
        model.check()
        model.intersect(Part.makeSphere(1))
        model.solid("cut", Part.makeSphere(1)).to_part()
        self.assertEqual(written(box), before)

    def test_loose_faces_are_sewn_as_those_of_files(self):
        box = [face.copy() for face in Part.makeBox(1, 2, 3).Faces]
        for loose, volume in ((box, 6), (box[:5], None)):
            shape = Part.makeCompound(loose)
            before = written(shape)
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "loose.brep")
                shape.exportBrep(file)
                for ask in (blossom.Model.mass, blossom.Model.check):
                    ours, theirs = (ask(model).to_dict() for model in (blossom.shape(shape), blossom.read(file)))
                    self.assertEqual(ours["repairs"][0]["sewn"], theirs["repairs"][0]["sewn"])
                    self.assertEqual(ours["repairs"][0]["sewn"]["loose_faces"], len(loose))
                found = blossom.shape(shape).mass().to_dict()["total"]
                self.assertEqual(found and round(found["volume"], 9), volume)
            self.assertEqual(len(blossom.shape(shape).section((0, 0, 1), (0, 0, 1))), 1)
            self.assertEqual(len(blossom.shape(shape).sew().to_part().Solids), volume is not None)
            self.assertEqual(written(shape), before)

    def test_a_null_shape_is_told(self):
        with self.assertRaisesRegex(ValueError, "^a: the shape is null$"):
            blossom.intersect(Part.Shape(), WALL)

    def test_an_object_of_a_closed_document_is_told(self):
        document = FreeCAD.newDocument("closed")
        box = document.addObject("Part::Box", "Box")
        document.recompute()
        shape = box.Shape
        FreeCAD.closeDocument("closed")
        self.assertEqual(len(blossom.shape(shape)), 6)  # a shape lives by itself
        with self.assertRaises((ValueError, TypeError)):
            blossom.shape(box)

    def test_an_object_of_a_document_is_told_from_its_shape(self):
        document = FreeCAD.newDocument("open")
        box = document.addObject("Part::Box", "Box")
        with self.assertRaisesRegex(TypeError, "^a: .*; its Shape is one, without the places"):
            blossom.intersect(box, WALL)
        FreeCAD.closeDocument("open")

    def test_what_names_an_edge_is_told(self):
        box = Part.makeBox(1, 2, 3)
        with self.assertRaisesRegex(TypeError, "^edges: a number, or 'Edge3', is wanted, got Edge$"):
            blossom.fillet(box, [box.Edges[0]], radius=0.1)

    def test_shape_and_operation_in_the_wrong_order_are_told(self):
        box = Part.makeBox(1, 2, 3)
        with self.assertRaisesRegex(TypeError, "^operation: one of cut, common, fuse, split is wanted, got Solid$"):
            blossom.solid(box, "cut", box)

    def test_vectors_are_points(self):
        box = blossom.shape(Part.makeBox(1, 2, 3))
        found = box.section(FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(0, 0, 1))
        self.assertAlmostEqual(found[0].length, 6)


class Types(unittest.TestCase):
    def test_the_stub_names_what_the_module_has(self):
        import ast

        stub = ast.parse(pathlib.Path(_core.__file__).with_name("_core.pyi").read_text())
        told = {}
        for node in stub.body:
            if isinstance(node, ast.FunctionDef):
                told[node.name] = {arg.arg for arg in node.args.args}
            elif isinstance(node, ast.ClassDef):
                told[node.name] = {part.name for part in node.body if hasattr(part, "name")}
        for name in set(dir(_core)) - {"__version__", "occt_version", "has_swig_bridge"}:
            if name.startswith("__"):
                continue
            with self.subTest(name):
                self.assertIn(name, told)
                member = getattr(_core, name)
                if isinstance(member, type) and not issubclass(member, Exception):
                    public = {part for part in vars(member) if not part.startswith("_")}
                    self.assertEqual(public, told[name] - {"__init__"})
                elif not isinstance(member, type):
                    for argument in told[name]:
                        self.assertIn(argument, member.__doc__)


class Processes(unittest.TestCase):
    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork here")
    def test_a_forked_process_answers_too(self):
        square = FLOOR
        blossom.intersect(square, WALL)  # threads wait in this process, not in the child
        child = os.fork()
        if child == 0:
            found = blossom.intersect(square, WALL)
            os._exit(0 if len(found) == 1 else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)

    def test_a_question_may_be_asked_within_another(self):
        inner = []

        def ask(_):
            if not inner:
                inner.append(len(blossom.intersect(FLOOR, WALL)))

        with self.assertRaises(blossom.Cancelled):
            cancel = blossom.Cancel()
            blossom.intersect(
                *HARD, cancel=cancel,
                progress=lambda seconds: (ask(seconds), cancel.cancel()), **HARD_OPTIONS,
            )  # fmt: skip
        self.assertEqual(inner, [1])


if __name__ == "__main__":
    unittest.main(verbosity=2)
