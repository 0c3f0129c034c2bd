# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all parametric objects of the workbench have in common.

A kind of object is a class that says which links, choices and facts it has, and asks the engine.
Its module's and its own name are in documents: they stay.
"""

import collections

import FreeCAD
import Part

from . import door, links, work

# A link to other objects. `one`: a single face is wanted.
Link = collections.namedtuple("Link", "name label tip")
# A choice of the user's. kind: "length", "distance", "angle", "number", "count", "flag", "word",
# "lines", "vector", "points". of: its words, or its least and largest number.
Choice = collections.namedtuple("Choice", "name kind default label tip of", defaults=(None,))
# A fact of the answer. kind: "word", "words", "count", "counts", "edges" by their numbers, or a
# number: "length", "area", "volume", "angle".
Fact = collections.namedtuple("Fact", "name kind tip")

TOLERANCE = Choice(
    "Tolerance", "length", "1e-7 mm", "Tolerance", "What counts as one point"
)

_TYPES = {
    "length": "App::PropertyLength",
    "distance": "App::PropertyDistance",
    "angle": "App::PropertyAngle",
    "number": "App::PropertyFloat",
    "count": "App::PropertyInteger",
    "flag": "App::PropertyBool",
    "word": "App::PropertyEnumeration",
    "lines": "App::PropertyStringList",
    "vector": "App::PropertyVector",
    "points": "App::PropertyVectorList",
}
_FACT_TYPES = {
    "word": "App::PropertyString",
    "count": "App::PropertyInteger",
    "length": "App::PropertyFloat",
    "area": "App::PropertyFloat",
    "volume": "App::PropertyFloat",
    "angle": "App::PropertyFloat",
    "words": "App::PropertyStringList",
    "counts": "App::PropertyIntegerList",
    "edges": "App::PropertyIntegerList",
}
REASONS = Fact("Reasons", "words", "Why the status is not complete")
# What users can mend; a full disk is an OSError.
MENDABLE = (ValueError, RuntimeError, OSError)
_READ_ONLY, _HIDDEN = 1, 4  # as addProperty wants them


class Feature:
    """A parametric object whose shape is an answer of the engine."""

    NAME = ""  # of new objects, and of the command
    TITLE = ""  # in menus
    TIP = ""
    DOING = ""  # what is said while it works
    OBJECT = "Part::FeaturePython"  # FreeCAD's type of it
    LINKS = ()
    CHOICES = ()
    FACTS = ()
    _ready = None  # a question with its answer, for the next execute
    TABLED = ()  # facts that its panel shows otherwise
    HIDES = False  # whether what it is made of is hidden and becomes its children

    def __init__(self, obj):
        self.Type = f"Blossom::{self.NAME}"
        self._ready = None
        self._add_properties(obj)
        obj.Proxy = self

    def _add_properties(self, obj):
        """Those that it has not got; a document may be of a time when there were fewer."""
        for link in self.LINKS:
            _added(obj, "App::PropertyLinkSubListGlobal", link.name, "Blossom", link.tip)
        for choice in self.CHOICES:
            if _added(obj, _TYPES[choice.kind], choice.name, "Blossom", choice.tip):
                if choice.kind == "word":
                    setattr(obj, choice.name, list(choice.of))
                setattr(obj, choice.name, choice.default)
        for fact in self.FACTS:
            _added(obj, _FACT_TYPES[fact.kind], fact.name, "Result", fact.tip, _READ_ONLY)
        _added(
            obj, "App::PropertyStringList", "Linked", "Result", "What was linked when it was made",
            _READ_ONLY | _HIDDEN,
        )  # fmt: skip

    # What kinds say.

    def inputs(self, obj):
        """Shapes of Part that the question is about, by names. throws ValueError"""
        raise NotImplementedError

    def options(self, obj):
        """What else the question depends on, as plain values by names."""
        return {}

    def ask(self, entrance, inputs, options):
        """The answer. In a thread of its own: it must not touch the document."""
        raise NotImplementedError

    def begin(self, obj):
        """Choices of a new object that a user makes in the window, by what was selected for it."""

    def unused(self, obj):
        """Names of choices that do not count, as others are."""
        return set()

    def facts(self, report):
        """The values of FACTS: in millimetres, or radians."""
        return {}

    @classmethod
    def deal(cls, members):
        """What is selected, for each of LINKS."""
        return links.dealt(members, len(cls.LINKS))

    def shape(self, obj, answer, inputs):
        """The object's shape. throws RuntimeError if there is none"""
        if answer.shape is None or answer.shape.isNull():
            raise RuntimeError(self.nothing(obj))
        return answer.shape

    def nothing(self, obj):
        """Why there is no shape."""
        return "there is no result"

    def give(self, obj, answer, inputs):
        """Gives the object what was made. throws RuntimeError as `shape`"""
        shape = self.shape(obj, answer, inputs)
        if not shape.isNull() and shape.ShapeType == "Compound" and not shape.childShapes():
            obj.Shape = Part.Shape()  # windows cannot show a shape that has nothing in it
            return
        shape = _placed(shape, obj)
        if obj.Shape.isNull() or not _same(obj.Shape, shape):
            obj.Shape = shape
        elif FreeCAD.GuiUp:  # OK after the preview: to show all anew keeps the window waiting
            from .view import paint

            paint(obj)

    def colours(self, obj):
        """A colour for each face of the shape, or None."""
        return None

    # What FreeCAD calls.

    def execute(self, obj):
        try:
            self.compute(obj)
        except MENDABLE as error:  # a message, without the way that it came
            raise error.with_traceback(None) from None
        except KeyboardInterrupt:
            raise RuntimeError("interrupted by Ctrl-C") from None

    def compute(self, obj):
        """The object's answer, if its question has changed. throws ValueError, RuntimeError"""
        self.check_links(obj)
        question = self.question(obj)
        ready, self._ready = self._ready, None
        if ready is not None and ready[0].same_as(question):
            answer = ready[1]
        else:
            answer = work.answer_of(question.job(), self.DOING)
        self.take(obj, question, answer)

    def onDocumentRestored(self, obj):  # noqa: N802 - FreeCAD's name
        self._ready = None
        self._add_properties(obj)
        if FreeCAD.GuiUp and getattr(obj.ViewObject, "Proxy", None) is None:
            from .view import ViewProvider

            ViewProvider(obj.ViewObject)

    def dumps(self):
        return {"Type": self.Type}

    def loads(self, state):
        self.Type = (state or {}).get("Type", f"Blossom::{self.NAME}")
        self._ready = None

    # FreeCAD 0.20 calls them by other names than later ones.
    __getstate__ = dumps
    __setstate__ = loads

    # What panels and `execute` are made of.

    def question(self, obj):
        """What the object wants to know, taken out of the document. throws ValueError"""
        return Question(self, self.inputs(obj), self.options(obj))

    def take(self, obj, question, answer):
        """Gives the object what came out."""
        for name, value in self.facts(answer.report).items():
            setattr(obj, name, value)
        obj.Linked = self.linked(obj)
        self.give(obj, answer, question.inputs)

    def keep_ready(self, question, answer):
        """The next `execute` need not ask again, if nothing has changed by then."""
        self._ready = (question, answer)

    def linked(self, obj):
        return [
            f"{link.name}: {each}"
            for link in self.LINKS
            for each in links.told(getattr(obj, link.name))
        ]

    def forget_links(self, obj):
        """What is linked now is what is meant, whatever was deleted."""
        obj.Linked = []
        obj.touch()

    def check_links(self, obj):
        """FreeCAD takes deleted objects out of links without a word. If that is why there are
        fewer, the answer would be one to another question. throws ValueError"""
        gone = [each for each in obj.Linked if _object_of(obj.Document, each) is None]
        left = [each for each in obj.Linked if each not in gone]
        if gone and self.linked(obj) == left:
            prop, member = gone[0].split(": ", 1)
            raise ValueError(f"{prop}: {member.split('.')[0]} was deleted; choose others")


def reasons_of(report):
    """Why a report's status is not "complete": of all its certificates, each once."""
    found = {}  # in order
    if report["status"] != "complete":
        _add_reasons(report, found)
    return [each.replace("in the listed contacts", "in places") for each in found]


def _add_reasons(told, found):
    if isinstance(told, dict):
        found.update(dict.fromkeys((told.get("certificate") or {}).get("reasons", [])))
        found.update(dict.fromkeys(told.get("left_out", [])))
        told = list(told.values())
    if isinstance(told, list):
        for each in told:
            if isinstance(each, (dict, list)):
                _add_reasons(each, found)


def _added(obj, kind, name, *more):
    """Whether the property is new."""
    if name in obj.PropertiesList:
        return False
    obj.addProperty(kind, name, *more)
    return True


class Question:
    """A feature's question with all that it needs."""

    def __init__(self, feature, inputs, options):
        self.feature = feature
        self.inputs = inputs
        self.options = options

    def job(self, ask=None):
        """The work, to be started.

        ask   what is asked instead of the feature's own question
        """
        entrance = door.opened()
        held = {name: _held(entrance, shape, name) for name, shape in self.inputs.items()}
        asked = ask or self.feature.ask
        return work.Job(entrance, lambda opened: asked(opened, held, self.options))

    def same_as(self, other):
        return (
            self.options == other.options
            and self.inputs.keys() == other.inputs.keys()
            and all(_same(shape, other.inputs[name]) for name, shape in self.inputs.items())
        )


def _held(entrance, shape, name):
    if isinstance(shape, list):
        return [entrance.hold(each, f"{name} {i}") for i, each in enumerate(shape, start=1)]
    return entrance.hold(shape, name)


def _same(a, b):
    if isinstance(a, list):
        return len(a) == len(b) and all(map(_same, a, b))
    if a.isPartner(b):
        return a.Orientation == b.Orientation and a.Matrix == b.Matrix
    both = a.ShapeType == b.ShapeType == "Compound"  # which are made for each question
    return both and _same(a.childShapes(), b.childShapes())


def _object_of(document, linked):
    return document.getObject(linked.split(": ", 1)[1].split(".", 1)[0])


def container_of(obj):
    """Where the containers that an object is in have put what is in them."""
    return obj.getGlobalPlacement().multiply(obj.Placement.inverse())


def _placed(shape, obj):
    """The shape, which is where it is in space, for an object that may be in a container and moved
    by hand itself."""
    container = container_of(obj)
    if not container.isIdentity():
        shape = shape.copy(False)
        shape.Placement = container.inverse().multiply(shape.Placement)
    if not shape.Placement.isIdentity() or shape.isNull():
        shape = Part.makeCompound([shape])
    shape.Placement = obj.Placement
    return shape
