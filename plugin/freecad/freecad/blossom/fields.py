# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets for choices: each has `widget`, `read()` and tells `changed()`."""

import FreeCAD
import FreeCADGui
from PySide import QtGui

_NARROW = 60  # pixels; panels are as wide as users have made them
_DIGITS = 6  # of lengths and angles, as of facts
_UNITS = {"length": "mm", "distance": "mm", "angle": "deg"}
_LEAST = {"length": 0.0, "angle": 0.0}  # that may be typed


def field(obj, choice, changed):
    """The widget of a choice, set to what the object has; None of one that has no widget."""
    make = {
        "length": Quantity, "distance": Quantity, "angle": Quantity, "number": Number,
        "count": Count, "flag": Flag, "word": Word, "lines": Lines,
        "vector": Vector,
    }.get(choice.kind)  # fmt: skip
    if make is None:
        return None
    made = make(getattr(obj, choice.name), choice, changed)
    made.widget.setToolTip(choice.tip)
    made.widget.setObjectName(f"Blossom{choice.name}")
    made.widget.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
    made.widget.setMinimumWidth(_NARROW)
    return made


class Quantity:
    """A length or an angle, in the user's units."""

    def __init__(self, value, choice, changed):
        self.widget = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.widget.setProperty("unit", _UNITS[choice.kind])
        if choice.kind in _LEAST:
            self.widget.setProperty("minimum", _LEAST[choice.kind])
        value.Format = {"NumberFormat": "g", "Precision": _DIGITS}  # a tolerance is not 0.00 in
        self.widget.setProperty("value", value)
        self.widget.valueChanged.connect(lambda *_: changed())

    def read(self):
        return self.widget.property("value")


class Number:
    def __init__(self, value, choice, changed):
        self.widget = QtGui.QDoubleSpinBox()
        self.widget.setRange(*choice.of)
        self.widget.setDecimals(3)
        self.widget.setSingleStep(0.1)
        self.widget.setValue(value)
        self.widget.valueChanged.connect(lambda *_: changed())

    def read(self):
        return self.widget.value()


class Count:
    def __init__(self, value, choice, changed):
        self.widget = QtGui.QSpinBox()
        self.widget.setRange(*choice.of)
        self.widget.setValue(value)
        self.widget.valueChanged.connect(lambda *_: changed())

    def read(self):
        return self.widget.value()


class Flag:
    def __init__(self, value, choice, changed):
        self.widget = QtGui.QCheckBox(choice.label)
        self.widget.setChecked(value)
        self.widget.toggled.connect(lambda *_: changed())

    def read(self):
        return self.widget.isChecked()


class Word:
    def __init__(self, value, choice, changed):
        self.widget = QtGui.QComboBox()
        self.widget.addItems(list(choice.of))
        self.widget.setCurrentText(value)
        self.widget.currentIndexChanged.connect(lambda *_: changed())

    def read(self):
        return self.widget.currentText()


class Lines:
    """Texts in one line, with semicolons between them."""

    def __init__(self, value, choice, changed):
        self.widget = QtGui.QLineEdit("; ".join(value))
        self.widget.setPlaceholderText(choice.of)
        self.widget.editingFinished.connect(lambda *_: changed())

    def read(self):
        parts = (part.strip() for part in self.widget.text().split(";"))
        return [part for part in parts if part]


class _Coordinate(QtGui.QDoubleSpinBox):
    """A number without the zeros at its end, for which there is no room."""

    def textFromValue(self, value):  # noqa: N802 - Qt's name
        text = super().textFromValue(value)
        point = self.locale().decimalPoint()
        return text.rstrip("0").rstrip(point) if point in text else text


class Vector:
    """Three numbers in millimetres side by side."""

    def __init__(self, value, choice, changed):
        self.widget = QtGui.QWidget()
        layout = QtGui.QHBoxLayout(self.widget)
        layout.setContentsMargins(0, 0, 0, 0)
        self._parts = []
        for x in value:
            part = _Coordinate()
            part.setRange(-1e9, 1e9)
            part.setDecimals(4)
            part.setValue(x)
            part.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            part.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
            part.valueChanged.connect(lambda *_: changed())
            layout.addWidget(part)
            self._parts.append(part)

    def read(self):
        return FreeCAD.Vector(*(part.value() for part in self._parts))
