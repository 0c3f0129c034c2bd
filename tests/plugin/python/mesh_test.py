# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models as triangles: arrays, groups, files, and what is proven of them."""

import json
import math
import pickle
import struct
import tempfile
import unittest
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import blossom
import numpy as np
import support

FILES = support.made_files()
DRILL = blossom.read(FILES / "drill.step")  # a cylinder of radius 8
ENDINGS = (".stl", ".ply", ".obj", ".off", ".glb")


def volume(mesh):
    a, b, c = (mesh.vertices[mesh.triangles[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


class Meshes(unittest.TestCase):
    def test_triangles_are_within_the_deviation_and_closed(self):
        exact = blossom.mesh(DRILL, 1e-4)
        made = DRILL.mesh(0.05)

        self.assertTrue(made.closed)
        self.assertLessEqual(made.deviation, 0.05)
        radii = np.hypot(*(made.vertices - made.vertices.mean(axis=0))[:, :2].T)
        self.assertLessEqual(abs(radii.max() - 8), made.deviation + 1e-9)
        self.assertLess(volume(made), volume(exact))
        self.assertGreater(volume(made), 0.98 * volume(exact))
        self.assertEqual((made.status, made.refused), ("complete", []))

    def test_groups_are_the_triangles_of_faces(self):
        made = DRILL.mesh(0.1)

        self.assertEqual(list(made), [1, 2, 3])
        self.assertEqual(made.names[2], "Drill/Face2")
        for number, rows in made.groups.items():
            self.assertTrue((made.faces[rows] == number).all())
        self.assertEqual(sum(len(made.triangles[rows]) for rows in made.groups.values()), len(made.faces))
        self.assertEqual(list(DRILL.face(2).mesh(0.1)), [2])
        self.assertFalse(DRILL.face(2).mesh(0.1).closed)

    def test_colours_are_kept_as_by_the_model_itself(self):
        made = DRILL.mesh(0.1)
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = Path(folder) / "ours.ply", Path(folder) / "theirs.ply"
            made.write(ours)
            blossom.write(DRILL, theirs, deviation=0.1)
            kept, told = (blossom.from_mesh(file).colours for file in (ours, theirs))

        self.assertEqual(len(told), 3)
        self.assertEqual(kept, told)
        self.assertEqual({made.names[face]: colour for face, colour in made.colours.items()}, told)

    def test_the_report_is_that_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "drill.obj"
            told = support.told_by_program("convert", FILES / "drill.step", "-o", target)
        mine = DRILL.mesh().to_dict()

        for name in ("deviation", "distance", "triangles", "points", "closed", "open_edges"):
            self.assertEqual(mine[name], told[name], name)

    def test_answers_pickle_and_write_again(self):
        made = pickle.loads(pickle.dumps(DRILL.mesh(0.1)))

        self.assertRegex(repr(made), "^<blossom.Mesh: [0-9]+ triangles of 3 faces, within 0")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "drill.obj"
            made.write(file)
            lines = file.read_text().splitlines()
        groups = [line for line in lines if line.startswith("g ")]
        self.assertEqual(groups, ["g Drill/Face1", "g Drill/Face2", "g Drill/Face3"])
        points = np.array([line.split()[1:] for line in lines if line.startswith("v ")], float)
        np.testing.assert_array_equal(points, made.vertices)

    def test_models_write_all_formats(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending in ENDINGS:
                file = Path(folder) / f"drill{ending}"
                blossom.write(DRILL, file, deviation=0.1)
                self.assertGreater(file.stat().st_size, 500, ending)
            DRILL.write(Path(folder) / "text.stl", text=True)
            self.assertTrue((Path(folder) / "text.stl").read_bytes().startswith(b"solid"))
            blossom.convert(FILES / "drill.step", Path(folder) / "converted.ply")

    def test_glb_keeps_names_and_leaves_the_model_without_triangles(self):
        drilled = blossom.read(FILES / "block.step").solid("cut", DRILL)
        before = drilled.to_brep()
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "drilled.glb"
            drilled.write(file, deviation=0.1)
            told = _json_of(file.read_bytes())

        self.assertIn("Block", [node.get("name") for node in told["nodes"]])
        self.assertEqual(drilled.to_brep(), before)

    def test_3mf_has_an_object_for_each_part(self):
        # Two tetrahedra on either side of a triangle whose corners both have; their faces take turns.
        rows = [f"v {x} {y} {z}" for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, -1))]
        rows += ["g rig:1/Rod/Face1", "f 1 3 2", "g Lid/Face1", "f 1 2 3", "f 2 1 5"]
        rows += ["g rig:1/Rod/Face2", "f 1 2 4", "g Lid/Face2", "f 3 2 5", "f 1 3 5"]
        rows += ["g rig:1/Rod/Face3", "f 2 3 4", "f 3 1 4"]
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "rig.obj").write_text("\n".join(rows) + "\n")
            blossom.from_mesh(Path(folder) / "rig.obj").write(Path(folder) / "rig.3mf")
            objects = _objects_of(Path(folder) / "rig.3mf")
        self.assertEqual([name for name, _, _ in objects], ["rig:1/Rod", "Lid"])
        for _, vertices, triangles in objects:
            self.assertEqual((len(vertices), len(triangles)), (4, 4))
            a, b, c = (vertices[triangles[:, k]] for k in range(3))
            self.assertAlmostEqual(np.einsum("ij,ij->", a, np.cross(b, c)) / 6, 1 / 6)

    def test_3mf_has_an_object_for_each_of_two_parts_of_one_name(self):
        with tempfile.TemporaryDirectory() as folder:
            file, out = Path(folder) / "rig.step", Path(folder) / "rig.3mf"
            blossom.solid("split", FILES / "block.step", DRILL).to_step(file)
            text = file.read_text()
            for name in set(blossom.read(file).part_paths):
                text = text.replace(f"'{name}'", "'Bolt'")
            file.write_text(text)
            rig = blossom.read(file)
            self.assertEqual(set(rig.part_paths), {"Bolt"})
            for write in (rig.mesh(0.5).write, pickle.loads(pickle.dumps(rig.mesh(0.5))).write):
                write(out)
                objects = _objects_of(out)
                self.assertEqual([name for name, _, _ in objects], ["Bolt"] * rig.counts["solids"])

    @unittest.skipIf(support.Part is None, support.NO_PART)
    def test_shapes_of_part_get_no_triangles(self):
        box = support.Part.makeCylinder(8, 40)
        with tempfile.TemporaryDirectory() as folder:
            blossom.write(box, Path(folder) / "box.glb", deviation=0.1)
        made = blossom.mesh(box, 0.1)

        self.assertFalse(any(face.getUVNodes() for face in _quietly_unmeshed(box)))
        self.assertAlmostEqual(volume(made), math.pi * 64 * 40, delta=150)

    def test_errors_are_words(self):
        made = DRILL.mesh(0.1)
        for error, message, call in (
            (ValueError, "^deviation: -1.0 is not positive", lambda: DRILL.mesh(-1)),
            (TypeError, "^angle: a number is wanted", lambda: DRILL.mesh(angle="x")),
            (ValueError, "does not end with .stl, .ply, .obj, .off or .3mf", lambda: made.write("a.glb")),
            (ValueError, "has no triangles", lambda: DRILL.write("a.step", deviation=1)),
            (TypeError, "^text: True or False", lambda: DRILL.write("a.stl", text=1)),
            (blossom.Error, "Mesh: there is no shape in this answer", made.to_brep),
        ):
            with self.subTest(message), self.assertRaisesRegex(error, message):
                call()


def _quietly_unmeshed(shape):
    """The faces that have triangles."""
    faces = []
    for face in shape.Faces:
        try:
            face.getUVNodes()
        except Exception:  # noqa: B902 - Part's own word for a face without triangles
            continue
        faces.append(face)
    return faces


def _objects_of(file):
    """Name, vertices and triangles of the objects of a 3MF file."""
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    with zipfile.ZipFile(file) as archive:
        model = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
    listed = [item.get("objectid") for item in model.iter(space + "item")]
    found = []
    for each in model.iter(space + "object"):
        assert each.get("id") in listed
        vertices = [[float(v.get(k)) for k in "xyz"] for v in each.iter(space + "vertex")]
        triangles = [[int(t.get(k)) for k in ("v1", "v2", "v3")] for t in each.iter(space + "triangle")]
        found.append((each.get("name"), np.array(vertices), np.array(triangles)))
    return found


def _json_of(glb):
    length = struct.unpack("<I", glb[12:16])[0]
    return json.loads(glb[20 : 20 + length])


if __name__ == "__main__":
    unittest.main(verbosity=2)
