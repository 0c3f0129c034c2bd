# SPDX-License-Identifier: LGPL-2.1-or-later
"""Waiting for a question while the window goes on painting."""

import time

import FreeCADGui
from PySide import QtCore, QtGui

PATIENCE = 0.4  # seconds before the user is told that there is work
ROUND = 10  # milliseconds that events may take before the work is looked at again


def _input_kinds():
    names = (
        "KeyPress", "KeyRelease", "Shortcut", "ShortcutOverride", "MouseButtonPress",
        "MouseButtonRelease", "MouseButtonDblClick", "MouseMove", "Wheel", "ContextMenu", "Close",
        "DragEnter", "DragMove", "Drop", "TouchBegin", "TouchUpdate", "TouchEnd",
    )  # fmt: skip
    return {getattr(QtCore.QEvent, name) for name in names}


class _Doorkeeper(QtCore.QObject):
    """Lets no input through while a document is being computed, which input could change or close;
    but the button, and Escape.

    FreeCAD's progress bar has such a filter, too, which knows nothing of the button. The one that
    was installed last is asked first.
    """

    def __init__(self, button, cancel):
        super().__init__()
        self._button = button
        self._cancel = cancel
        self._input = _input_kinds()

    def eventFilter(self, target, event):  # noqa: N802 - Qt's name
        kind = event.type()
        if kind not in self._input:
            return False
        pressed = kind == QtCore.QEvent.MouseButtonPress and target is self._button
        escaped = kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape
        if pressed or escaped:
            self._cancel()
        return True


class WaitingBox(QtGui.QFrame):
    """Says what is being done and for how long, with a button; in the middle of the window."""

    def __init__(self, window, text):
        super().__init__(window)
        self.setObjectName("BlossomWaiting")
        self.setFrameShape(QtGui.QFrame.StyledPanel)
        self.setAutoFillBackground(True)
        self._text = text
        self._label = QtGui.QLabel(text, self)
        bar = QtGui.QProgressBar(self)
        bar.setRange(0, 0)
        self.button = QtGui.QPushButton("Cancel", self)
        layout = QtGui.QVBoxLayout(self)
        for widget in (self._label, bar, self.button):
            layout.addWidget(widget)
        self.setMinimumWidth(280)
        self.adjustSize()
        self.move((window.width() - self.width()) // 2, (window.height() - self.height()) // 2)

    def tell(self, seconds):
        """Shows itself, and for how long the work has been going on."""
        if not self.isVisible():
            self.show()
            self.raise_()
        text = f"{self._text}: {seconds:.1f} s"
        if text != self._label.text():
            self._label.setText(text)


def wait(job, text):
    """Returns when the job is done; the job is cancelled by the button or Escape."""
    box = WaitingBox(FreeCADGui.getMainWindow(), text)
    keeper = _Doorkeeper(box.button, job.cancel)
    application = QtGui.QApplication.instance()
    application.installEventFilter(keeper)
    start = time.monotonic()
    try:
        while not job.done:
            seconds = time.monotonic() - start
            if seconds > PATIENCE:
                box.tell(seconds)
            application.processEvents(QtCore.QEventLoop.AllEvents, ROUND)
            job.join(ROUND / 1000)
    finally:
        application.removeEventFilter(keeper)
        box.hide()
        box.deleteLater()
