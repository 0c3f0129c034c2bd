# SPDX-License-Identifier: LGPL-2.1-or-later
"""Answers that are shapes: trims, solids, watertight pieces, strips."""

from typing import Any, Dict, List, Optional, Union, cast

from ._results import Result, Selective, counted


class Trim(Result):
    """A part cut by tools; a list of pieces. Its shape is what is kept, with faces that were not to
    be cut."""

    @property
    def pieces(self) -> List[Dict[str, Any]]:
        """Each with `face`, `piece`, `side`, `kept` and `area`."""
        return list(self._told()["pieces"])

    @property
    def notes(self) -> List[str]:
        """What was left out, and why."""
        return list(self._told()["notes"])

    def _has_found_nothing(self) -> bool:
        decided = all(piece["side"] != "unknown" for piece in self.pieces)
        return self.status != "stopped" and decided

    def _items(self) -> List[Any]:
        return self.pieces

    def _summary(self) -> str:
        kept = sum(piece["kept"] for piece in self.pieces)
        return f"{self.status}, {counted(len(self.pieces), 'piece')}, {kept} kept"


class Solid(Result):
    """Combined solids, sheets or wires; a list of what came out, each with `faces` and, of solids,
    `voids`; all wires are one, with `edges` and `vertices` off them."""

    @property
    def operation(self) -> str:
        return str(self._told()["operation"])

    @property
    def volume(self) -> float:
        """Of all that came out."""
        return float(self._told()["total"]["result"])

    @property
    def volumes(self) -> Dict[str, float]:
        """Of the inputs and what came out: `part`, `tools`, `result`."""
        return dict(self._told()["total"])

    @property
    def area(self) -> float:
        """Of the sheets that came out; 0 of solids."""
        return float(self._told()["areas"]["result"])

    @property
    def areas(self) -> Dict[str, float]:
        """Of sheets among the inputs, and of those that came out: `part`, `tools`, `result`."""
        return dict(self._told()["areas"])

    @property
    def lengths(self) -> Dict[str, float]:
        """Of wires among the inputs, and of those that came out: `part`, `tools`, `result`."""
        return dict(self._told()["wires"]["lengths"])

    @property
    def obstacles(self) -> List[str]:
        """Why there is no result; none if it can be used."""
        return list(self._told()["obstacles"])

    def _has_found_nothing(self) -> bool:
        return self.status != "stopped" and not self.obstacles

    def _items(self) -> List[Any]:
        told = self._told()
        counts = {kind: told["wires"][kind] for kind in ("edges", "vertices")}
        wires = [counts] if any(counts.values()) else []
        return list(told["solids"]) + list(told["sheets"]) + wires

    def _shapes(self) -> str:
        told = self._told()
        edges, vertices = told["wires"]["edges"], told["wires"]["vertices"]
        lone = "1 vertex" if vertices == 1 else f"{vertices} vertices"
        if vertices:
            return f"{counted(edges, 'edge')} and {lone}" if edges else lone
        if edges or any(self.lengths.values()):
            return counted(edges, "edge")
        return counted(len(self), "sheet" if told["sheets"] else "solid")

    def _summary(self) -> str:
        told = f"{self.operation}, {self.status}, {self._shapes()}"
        return f"{told}, {self.obstacles[0]}" if self.obstacles else told


class EdgeBlend(Result):
    """A model with blends in place of edges; a list of the numbers of those."""

    _done = ""

    @property
    def status(self) -> str:
        """ "complete", "tolerance" if some edges are left out, "refused" if nothing is made, or
        "stopped"."""
        return str(self._told()["status"])

    def __bool__(self) -> bool:
        """Whether there is a model."""
        return self.status in ("complete", "tolerance")

    @property
    def edges(self) -> List[int]:
        """Those that were asked for and made, and those that they go on in."""
        return list(self._told()["edges"])

    @property
    def refused(self) -> List[Dict[str, Any]]:
        """What cannot be made: `edge`, `fault`, `cause`, `parameter`, `point`,
        `largest_radius`."""
        return list(self._told()["refused"])

    @property
    def notes(self) -> List[str]:
        """How strips end, where that is not what one would think."""
        return list(self._told()["notes"])

    @property
    def volume(self) -> Optional[float]:
        """Of all solids; None if nothing was made."""
        after = self._told()["volume"]["after"]
        return None if after is None else float(after)

    @property
    def volume_before(self) -> float:
        return float(self._told()["volume"]["before"])

    def _items(self) -> List[Any]:
        return self.edges

    def _summary(self) -> str:
        told = f"{self.status}, {counted(len(self.edges), 'edge')} {self._done}"
        if self.volume is None:
            told = f"nothing {self._done}"  # the status is that of the answer, not of a shape
        if not self.refused:
            return told
        first = self.refused[0]
        size = first["largest_radius"]
        largest = f"; the largest that works is {size:.6g}" if size else ""
        edge = f"edge {first['edge']}: " if first["edge"] else ""
        return f"{told}, {len(self.refused)} refused: {edge}{first['cause']}{largest}"


class Fillet(EdgeBlend):
    """A model with rounded edges; a list of the numbers of those that have fillets."""

    _done = "rounded"


class Chamfer(EdgeBlend):
    """A model with edges cut off; a list of the numbers of those that have chamfers."""

    _done = "cut off"


class Fill(Selective):
    """Patches in holes; a list of what was filled, each with `edges`, `layout`, `patches`,
    `reached` and figures of how it meets its neighbours; `refused` has holes that stay: `edges`,
    `reason` and `message`. Its shape is the patches, or the model
    with them."""

    @property
    def holes(self) -> List[Dict[str, Any]]:
        return list(self._told()["holes"])

    def _items(self) -> List[Any]:
        return self.holes

    def _summary(self) -> str:
        patches = sum(hole["patches"] for hole in self.holes)
        told = f"{counted(len(self), 'hole')} filled with {patches} patches"
        return f"{told}, {len(self.refused)} refused" if self.refused else told


class Watertight(Result):
    """Untrimmed pieces with common sides; a list of them, each with `face`, `kind` ("patch" or
    "triangle"), `degree` and `points`, (n + 1, m + 1, 3) or the rows of a triangle, (k, 3)."""

    @property
    def pieces(self) -> List[Dict[str, Any]]:
        return list(self._made()["pieces"])

    @property
    def deviation(self) -> float:
        """How far pieces are from the faces, at most."""
        return float(self._told()["deviation"])

    @property
    def seconds(self) -> float:
        raise AttributeError("watertight pieces tell no time")

    def _items(self) -> List[Any]:
        return self.pieces

    def _summary(self) -> str:
        told = self._told()
        return (
            f"{self.status}, {counted(told['patches'], 'patch').replace('patchs', 'patches')}, "
            f"{counted(told['triangles'], 'triangle')}"
        )


class Strip(Result):
    """A strip between two faces, and how well it continues them."""

    @property
    def status(self) -> str:
        return "complete"

    @property
    def edge_a(self) -> Union[str, int]:
        """The border that was joined: "umin", "umax", "vmin", "vmax", or the number of an edge."""
        return cast(Union[str, int], self._told()["a"]["edge"])

    @property
    def edge_b(self) -> Union[str, int]:
        return cast(Union[str, int], self._told()["b"]["edge"])

    @property
    def backward(self) -> bool:
        """The border of b runs backwards along the strip."""
        return bool(self._told()["backward"])

    @property
    def continuity_a(self) -> Dict[str, float]:
        """`gap` in model units, `normal_angle` in radians, `curvature_difference` relative, `scale`:
        how many times the surface's own cross derivative the strip's is."""
        return dict(self._told()["continuity"]["a"])

    @property
    def continuity_b(self) -> Dict[str, float]:
        return dict(self._told()["continuity"]["b"])

    def _items(self) -> List[Any]:
        return [self.continuity_a, self.continuity_b]

    def _summary(self) -> str:
        from_a, to_b = (
            f"edge {edge}" if isinstance(edge, int) else edge
            for edge in (self.edge_a, self.edge_b)
        )
        return f"from {from_a} of a to {to_b} of b"
