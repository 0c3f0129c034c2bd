# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers, models and meshes as files to look at, as the command line makes them. No window and no
display is needed."""

import os
from typing import Any, Dict, Sequence, Tuple, Union

from . import _checks, _core, _shapes

FileName = Union[str, "os.PathLike[str]"]
View = Union[str, Sequence[float], None]
SIZE = (1200, 900)


class Shown:
    """Something that there is to see."""

    def _seen(self, control: _core.Control) -> _core.Answer:
        """What has a picture."""
        raise NotImplementedError

    def to_html(self, path: FileName, *, view: View = None, **options: Any) -> None:
        """Writes a page to turn, to zoom and to click into: one file, which needs no other and no
        network. A click tells of faces, curves and places what is known of them.

        view   where it is seen from first: "iso", "front", "back", "left", "right", "top", "bottom",
               or the direction to the eye; None: iso, unless that sees all faces edge-on
        """
        self._show(path, (".html", ".htm"), view, SIZE, False, options)

    def to_png(
        self,
        path: FileName,
        *,
        view: View = None,
        size: Tuple[int, int] = SIZE,
        **options: Any,
    ) -> None:
        """Writes a picture, with a title, a legend, axes and a scale bar.

        view   as of `to_html`
        size   width and height, pixels
        """
        self._show(path, (".png",), view, size, False, options)

    def to_glb(self, path: FileName, **options: Any) -> None:
        """Writes what there is to see as a model for other programs (glTF 2.0, metres, y upwards):
        triangles, and curves as lines. `write()` makes .glb of shapes alone, as fine as you want."""
        self._show(path, (".glb",), None, SIZE, False, options)

    def _show(
        self,
        path: FileName,
        endings: Tuple[str, ...],
        view: View,
        size: Tuple[int, int],
        zebra: bool,
        options: Dict[str, Any],
    ) -> None:
        file = _checks.path(path, "path")
        if not file.lower().endswith(endings):
            raise ValueError(f"path: {file} does not end with {' or '.join(endings)}")
        seen_from, pixels = _checks.view(view, "view"), _checks.size(size, "size")
        control = _checks.control(options, own=("view", "size"))
        form = endings[0][1:]
        for note in self._seen(control).show(file, form, seen_from, pixels, zebra, control):
            _shapes.warn(f"{file}: {note}")
