# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of task panels."""

import html
import math

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from . import check, clash, links, selection, trim

_ROW = 18  # pixels of a line in lists
_TABLE = 150  # pixels, at most
_PICK = "Click pieces to keep"
_WIDEST = 0.4  # of a table's width, its first column
_POWERS = {"length": 1, "area": 2, "volume": 3}  # of facts


class LinkBox(QtGui.QGroupBox):
    """A link's members, and a button that takes what is selected."""

    def __init__(self, obj, link, changed):
        super().__init__(link.label)
        self.link = link
        self.members = links.members(getattr(obj, link.name))
        self._changed = changed
        self.setObjectName(f"Blossom{link.name}")
        self.setToolTip(link.tip)
        self._list = QtGui.QListWidget()
        self._list.itemSelectionChanged.connect(self._show_member)
        take = QtGui.QPushButton("Take selection")
        take.setToolTip(f"{link.tip}: what is selected in the 3D view or the tree")
        take.clicked.connect(lambda *_: self.take())
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self._list)
        layout.addWidget(take)
        self._fill()

    def take(self):
        """The link is what is selected now."""
        chosen = selection.selected()
        if chosen:
            self.members = chosen
            self._fill()
            FreeCADGui.Selection.clearSelection()
            self._changed()

    def _fill(self):
        self._list.clear()
        for target, sub in self.members:
            self._list.addItem(links.shown(target, sub))
        self._list.setFixedHeight(_ROW * min(max(len(self.members), 1), 5) + 8)

    def _show_member(self):
        FreeCADGui.Selection.clearSelection()
        for index in self._list.selectedIndexes():
            target, sub = self.members[index.row()]
            FreeCADGui.Selection.addSelection(target.Document.Name, target.Name, sub)


class StateBox(QtGui.QFrame):
    """What the preview does, what it found, or what is wrong."""

    def __init__(self, stop):
        super().__init__()
        self.setObjectName("BlossomState")
        self._bar = QtGui.QProgressBar()
        self._bar.setRange(0, 0)
        self._bar.setTextVisible(False)
        self._stop = QtGui.QPushButton("Stop")
        self._stop.setObjectName("BlossomStop")
        self._stop.setToolTip("Ends the work for the preview")
        self._stop.clicked.connect(lambda *_: stop())
        self.text = QtGui.QLabel()
        self.text.setObjectName("BlossomText")
        self.text.setWordWrap(True)
        self.text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout = QtGui.QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._bar, 0, 0)
        layout.addWidget(self._stop, 0, 1)
        layout.addWidget(self.text, 1, 0, 1, 2)
        self._say("", busy=False)

    def say_busy(self, doing, seconds):
        self._say(f"{doing}: {seconds:.1f} s", busy=True)

    def say_wrong(self, message):
        self._say(f"<span style='color:#b00020'>{_escaped(message)}</span>", busy=False)

    def say_found(self, obj, seconds):
        """The facts of the object in a table."""
        rows = []
        for fact in obj.Proxy.FACTS:
            value = getattr(obj, fact.name)
            if fact.kind in ("area", "volume") and value == 0:  # of solids no area, of sheets no volume
                continue
            if fact.kind == "edges":
                value = [f"Edge{number}" for number in value]
            value = shown_fact(value, fact.kind)
            if value and fact.name not in obj.Proxy.TABLED:
                rows.append((f"{spaced(fact.name)}&nbsp;&nbsp;", _escaped(value)))
        rows.append(("Time", f"{seconds:.2f} s"))
        rows = [f"<tr><td>{name}</td><td>{value}</td></tr>" for name, value in rows]
        self._say(f"<table>{''.join(rows)}</table>", busy=False)

    def _say(self, text, busy):
        self._bar.setVisible(busy)
        self._stop.setVisible(busy)
        self.text.setText(text)


def shown_fact(value, kind, most=3):
    """A fact in a few words; nothing of an empty list."""
    if kind in _POWERS:
        return in_users_units(value, _POWERS[kind])
    if kind == "angle":
        return f"{math.degrees(value):.6g}°"
    if isinstance(value, (list, tuple)):
        more = f", ... {len(value)} in all" if len(value) > most else ""
        return ", ".join(str(each) for each in value[:most]) + more
    return str(value)


def in_users_units(millimetres, power):
    """A length, an area or a volume. The latter in powers of the unit that a millimetre has: not in
    millilitres beside lengths in millimetres."""
    sample = millimetres if power == 1 else 1.0
    _, factor, unit = FreeCAD.Units.Quantity(sample, FreeCAD.Units.Length).getUserPreferred()
    return f"{millimetres / factor**power:.6g} {unit}{('', '²', '³')[power - 1]}"


def spaced(name):
    """ "Open edges" of "OpenEdges"."""
    words = "".join(f" {c.lower()}" if c.isupper() else c for c in name).strip()
    return words.capitalize()


def note(text):
    label = QtGui.QLabel(f"{text}; the program blossom works on files")
    label.setWordWrap(True)
    return label


def _escaped(text):
    return html.escape(text, quote=False).replace("\n", "<br>")


def extra_of(panel):
    """What only one kind has; None of the others."""
    if isinstance(panel.feature, trim.Trim):
        return PieceBox(panel)
    if isinstance(panel.feature, check.Check):
        return ProblemTable(panel)
    if isinstance(panel.feature, clash.Clash):
        return PairTable(panel)
    return None


class PieceBox(QtGui.QWidget):
    """Pieces that are kept, by clicks in the 3D view."""

    def __init__(self, panel):
        super().__init__()
        self._panel = panel
        self._picking = QtGui.QPushButton(_PICK)
        self._picking.setObjectName("BlossomPick")
        self._picking.setCheckable(True)
        self._picking.setToolTip("Shows all pieces; each click in the 3D view keeps one")
        self._picking.toggled.connect(self._pick)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._picking)
        self._points = []

    def _pick(self, on):
        keep = self._panel.fields["Keep"].widget
        self._picking.setText("Click pieces, then here" if on else _PICK)
        if on:
            self._points = []
            keep.setCurrentText("all")
            FreeCADGui.Selection.addObserver(self)
        else:
            FreeCADGui.Selection.removeObserver(self)
            if self._points:
                self._panel.obj.Picked = self._points
                keep.setCurrentText(trim.PICKED)
                self._panel.changed()

    def addSelection(self, document, name, sub, point):  # noqa: N802 - FreeCAD's name
        obj = self._panel.obj
        if name == obj.Name and sub.startswith("Face"):
            self._points.append(_inside_of(obj.Shape.getElement(sub), point))
            count = len(self._points)
            pieces = "1 piece" if count == 1 else f"{count} pieces"
            self._picking.setText(f"{pieces} clicked; click here when done")

    def update_found(self, answer):
        pass

    def leave(self):
        if self._picking.isChecked():
            FreeCADGui.Selection.removeObserver(self)


def _inside_of(face, point):
    """A point that is well inside of a face, and so stays nearest to its piece; that of the click
    if the face's middle is outside of it."""
    u0, u1, v0, v1 = face.ParameterRange
    middle = (u0 + u1) / 2, (v0 + v1) / 2
    if face.isPartOfDomain(*middle):
        return face.valueAt(*middle)
    return FreeCAD.Vector(*point)


class FoundTable(QtGui.QTableWidget):
    """What was found with what has it; a row selects that."""

    NAME = ""
    TITLES = ("", "")

    def __init__(self, panel):
        super().__init__(0, 2)
        self._panel = panel
        self._elements = []
        self.setObjectName(self.NAME)
        self.setHorizontalHeaderLabels(list(self.TITLES))
        self.horizontalHeader().setStretchLastSection(True)
        self.verticalHeader().hide()
        self.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.setWordWrap(True)
        self.setMaximumHeight(_TABLE)
        # What comes later would make the lines longer than the rows are high.
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOn)
        self.itemSelectionChanged.connect(self._show_elements)

    def rows_of(self, report):
        """For each row the names of elements, and two texts."""
        raise NotImplementedError

    def update_found(self, answer):
        found = self.rows_of(answer.report)
        self._elements = [elements for elements, _ in found]
        self.setRowCount(len(found))
        for row, (_, texts) in enumerate(found):
            for column, text in enumerate(texts):
                self.setItem(row, column, QtGui.QTableWidgetItem(text))
        self.resizeColumnToContents(0)
        self.setColumnWidth(0, min(self.columnWidth(0), int(_WIDEST * self.viewport().width())))
        self.resizeRowsToContents()

    def _show_elements(self):
        obj = self._panel.obj
        FreeCADGui.Selection.clearSelection()
        for index in self.selectionModel().selectedRows():
            for element in self._elements[index.row()]:
                FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, element)

    def leave(self):
        pass


class ProblemTable(FoundTable):
    """Problems with the faces and edges that have them."""

    NAME = "BlossomProblems"
    TITLES = ("Where", "Problem")

    def rows_of(self, report):
        return [
            ([element] if element else [], (element or "all", problem))
            for element, problem in check.problems(report)
        ]


class PairTable(FoundTable):
    """Pairs of solids, and how they lie; a row selects the faces of both."""

    NAME = "BlossomPairs"
    TITLES = ("Solids", "Relation")

    def rows_of(self, report):
        faces = clash.faces_of_solids(self._panel.obj)
        return [
            ([name for place in pair for name in faces.get(place, [])], texts)
            for pair, texts in clash.rows(report)
        ]
