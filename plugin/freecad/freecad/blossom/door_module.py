# SPDX-License-Identifier: LGPL-2.1-or-later
"""Questions to the engine in this process."""

import blossom

from .door import Answer


class ModuleDoor:
    """Questions that `cancel` ends with `blossom.Cancelled`. What is held may be asked about in any
    thread."""

    Cancelled = blossom.Cancelled

    def __init__(self):
        self._cancel = blossom.Cancel()

    def cancel(self):
        self._cancel.cancel()

    def hold(self, shape, name):
        """A shape of Part, ready to be asked about; messages call it by the name."""
        return blossom.shape(shape, name)

    def intersect(self, a, b, **options):
        return self._answer(a.intersect(b, **self._with_cancel(options)))

    def section(self, part, point, normal, **options):
        return self._answer(part.section(point, normal, **self._with_cancel(options)))

    def trim(self, part, tools, keep, **options):
        made = part.trim(*tools, keep=keep, **self._with_cancel(options))
        return self._answer(made, any(piece["kept"] for piece in made))

    def solid(self, operation, part, tools, **options):
        made = part.solid(operation, *tools, **self._with_cancel(options))
        return self._answer(made, len(made) > 0)

    def check(self, part):
        return Answer(None, part.check(cancel=self._cancel).to_dict())

    def strip(self, a, b, edge_a, edge_b, weight_a, weight_b):
        return self._answer(
            blossom.blend_strip(
                a, b, edge_a, edge_b, weight_a=weight_a, weight_b=weight_b, cancel=self._cancel
            )
        )

    def fillet(self, part, edges, radius, partial, **options):
        made = part.fillet(edges, radius=radius, partial=partial, **self._with_cancel(options))
        return self._answer(made, len(made) > 0)

    def subdivide(self, part, rectangle, levels):
        return self._answer(part.subdivide(rectangle, levels=levels, cancel=self._cancel))

    def fill(self, part, edges, continuity, sew, **options):
        options = self._with_cancel(options)
        return self._answer(part.fill(edges, continuity=continuity, sew=sew, **options))

    def _with_cancel(self, options):
        return {**options, "cancel": self._cancel}

    @staticmethod
    def _answer(result, has_shape=True):
        return Answer(result.to_part() if has_shape else None, result.to_dict())
