# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models as triangles."""

import os
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

from ._results import Array, Indices, Selective, counted
from ._triangles import Colour, from_mesh


class Mesh(Selective):
    """Triangles of all faces, which share their points along edges; a list of the numbers of faces
    that have some; `refused` has those that are left out: `face` and `why`."""

    @property
    def vertices(self) -> Array:
        """(n, 3)"""
        vertices: Array = self._made()["vertices"]
        return vertices

    @property
    def triangles(self) -> Indices:
        """Rows of `vertices`, counter-clockwise from outside, (m, 3)."""
        triangles: Indices = self._made()["triangles"]
        return triangles

    @property
    def faces(self) -> Indices:
        """Of each triangle the number of its face, (m,)."""
        faces: Indices = self._made()["faces"]
        return faces

    @property
    def groups(self) -> Dict[int, slice]:
        """By the number of a face where its triangles are: `mesh.triangles[mesh.groups[3]]`."""
        firsts = [first for _, first, *_ in self._groups()]
        ends = firsts[1:] + [len(self.triangles)]
        return {int(self.faces[first]): slice(first, end) for first, end in zip(firsts, ends)}

    @property
    def names(self) -> Dict[int, str]:
        """What faces are called in .obj, .ply and .off files, and .stl as text: "Face3", or with its part "Shaft/Face3"."""
        return {int(self.faces[first]): name for name, first, *_ in self._groups()}

    @property
    def colours(self) -> Dict[int, Colour]:
        """By the number of a face that has one: red, green, blue, from 0 to 255."""
        return {
            int(self.faces[first]): (colour[0], colour[1], colour[2])
            for _, first, colour, _ in self._groups()
            if colour is not None
        }

    @property
    def deviation(self) -> float:
        """Proven: no point of a triangle is farther from its face, no point of a face farther from
        the triangles."""
        return float(self._told()["distance"])

    @property
    def closed(self) -> bool:
        """Whether each edge has two faces, and none is left out."""
        return bool(self._told()["closed"])

    def write(self, path: Union[str, "os.PathLike[str]"], text: bool = False, **options: Any) -> None:
        """Writes the triangles to a file: .stl, .ply, .obj, .off, .3mf; .glb is written by models.

        text   .stl and .ply are not binary
        """
        from_mesh(self).write(path, text, **options)

    def _groups(self) -> List[Tuple[str, int, Optional[Colour], int]]:
        return list(self._made()["groups"])

    def _items(self) -> List[Any]:
        return list(self.groups)

    def __iter__(self) -> Iterator[int]:
        return iter(self.groups)

    def _summary(self) -> str:
        told = self._told()
        counts = f"{counted(told['triangles'], 'triangle')} of {counted(len(self), 'face')}"
        return f"{counts}, within {self.deviation:.3g}{'' if self.closed else ', open'}"
