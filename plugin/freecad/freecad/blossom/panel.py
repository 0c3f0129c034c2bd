# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of all kinds: links, choices, a preview that is computed while the window goes on,
and what was found.

The preview is the object itself. All happens in one transaction, which Cancel takes back.
"""

import functools
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from . import door, fields, panel_parts
from .feature import MENDABLE
from .view import icon_of, paint, shown_parents

QUIET = 200  # milliseconds without a change before a preview begins
LOOK = 30  # milliseconds between looks whether it is done


def show_panel(obj):
    """Opens the panel of an object, in the transaction that is open or in one of its own."""
    if FreeCADGui.Control.activeDialog():
        return False
    if not obj.Document.HasPendingTransaction:
        obj.Document.openTransaction(f"Edit {obj.Label}")
    FreeCADGui.Control.showDialog(Panel(obj))
    return True


class Panel:
    """What FreeCAD shows as a task."""

    def __init__(self, obj):
        self.obj = obj
        self.feature = obj.Proxy
        self._document, self._name = obj.Document.Name, obj.Name
        self._job = self._question = None
        self._wrong = None  # a question that has no answer, and why
        self._typed = set()
        self._leaving = self._left = False  # it is about to close; its widgets may be gone
        self._began = 0.0
        self.form = self._form()
        self._delay = _timer(self.form, QUIET, self.preview, once=True)
        self._clock = _timer(self.form, LOOK, self._look)
        self._delay.start()

    def _form(self):
        form = QtGui.QWidget()
        form.setWindowTitle(self.feature.TITLE)
        form.setWindowIcon(QtGui.QIcon(icon_of(self.feature.NAME)))
        layout = QtGui.QVBoxLayout(form)
        self.links = [
            panel_parts.LinkBox(self.obj, link, self.changed) for link in self.feature.LINKS
        ]
        for box in self.links:
            layout.addWidget(box)
        rows = QtGui.QFormLayout()
        layout.addLayout(rows)
        self.fields = {}
        for choice in self.feature.CHOICES:
            made = fields.field(self.obj, choice, functools.partial(self.changed, choice.name))
            if made is not None:
                self.fields[choice.name] = made
                label = [] if choice.kind == "flag" else [choice.label]
                rows.addRow(*label, made.widget)
        self._enable_fields()
        self.extra = panel_parts.extra_of(self)
        if self.extra is not None:
            layout.addWidget(self.extra)
        self.state = panel_parts.StateBox(self.stop)
        layout.addWidget(self.state)
        if door.choice().kind == "program":  # of none each question tells
            layout.addWidget(panel_parts.note(door.choice().reason))
        return form

    # What users do.

    def changed(self, name=""):
        """A link or a choice, by its name, is another one; the preview follows when it is quiet."""
        if not self._is_there():
            self._leave()
            return
        self._typed.add(name)
        self._write()
        self._enable_fields()
        self.stop()
        self._delay.start()

    def stop(self):
        """Ends the preview's work."""
        self._delay.stop()
        if self._job is not None:
            self._job.cancel()

    def accept(self):
        """OK: the object with what is chosen, in one step to undo."""
        self._delay.stop()
        if not self._is_there():
            return self.reject()
        if self._job is not None:
            self._job.cancel()
            self._job.join()
            self._forget_job()
        self._write()
        document = self.obj.Document
        self.obj.Linked = []
        if self._is_known_to_fail():
            return False
        self.obj.touch()
        document.recompute()
        if "Invalid" in self.obj.State:
            self._say_wrong(self.obj.getStatusString())
            return False
        document.commitTransaction()
        self._leaving = self._left = True
        self._close()
        return True

    def reject(self):
        """Cancel: the document as it was."""
        if self._left:
            return True
        self._leaving = self._left = True
        self.stop()
        self._clock.stop()  # to compute what depends on it lets events through
        document = FreeCAD.listDocuments().get(self._document)
        if document is not None:
            document.abortTransaction()
            document.recompute()
        self._close()
        return True

    def _is_there(self):
        """Whether the object was deleted meanwhile, or its document closed."""
        document = FreeCAD.listDocuments().get(self._document)
        return document is not None and document.getObject(self._name) is not None

    def _leave(self):
        """Closes the panel, but not within a signal of what goes with it."""
        if self._leaving:
            return
        self._leaving = True
        self.stop()
        self._clock.stop()
        QtCore.QTimer.singleShot(0, self.reject)

    def _is_known_to_fail(self):
        try:
            question = self.feature.question(self.obj)
        except MENDABLE as error:
            self._say_wrong(str(error))
            return True
        known = self._wrong is not None and self._wrong[0].same_as(question)
        if known:
            self._say_wrong(self._wrong[1])
        return known

    # The preview.

    def preview(self):
        """Begins the work for what is chosen now."""
        if self._job is not None:  # it was cancelled, and ends soon
            self._delay.start()
            return
        if not self._is_there():
            self._leave()
            return
        try:
            if not self._typed:  # else what is linked now is what is meant
                self.feature.check_links(self.obj)
            self._question = self.feature.question(self.obj)
            self._job = self._question.job()
        except MENDABLE as error:
            self._say_wrong(str(error))
            return
        self._began = time.monotonic()
        self._job.start()
        self._clock.start()
        self.state.say_busy(self.feature.DOING, 0.0)

    def _look(self):
        if not self._is_there():
            self._leave()
            return
        if not self._job.done:
            self.state.say_busy(self.feature.DOING, time.monotonic() - self._began)
            return
        job, question = self._forget_job()
        if job.cancelled:
            self.state.say_wrong("stopped; a change, or OK, begins again")
            return
        try:
            answer = job.answer()
            self.feature.take(self.obj, question, answer)
        except MENDABLE as error:
            self._wrong = question, str(error)
            self._say_wrong(str(error))
            return
        self.feature.keep_ready(question, answer)
        self.obj.purgeTouched()
        paint(self.obj)
        if self.feature.HIDES:
            for parent in shown_parents(self.obj):
                parent.Visibility = False
        self.state.say_found(self.obj, time.monotonic() - self._began)
        if self.extra is not None:
            self.extra.update_found(answer)

    def _say_wrong(self, message):
        """With the panel's labels for the names of properties, and how to choose what is missing."""
        labels = {each.name: each.label for each in (*self.feature.LINKS, *self.feature.CHOICES)}
        name, colon, rest = message.partition(": ")
        if colon and name in labels:
            message = f"{labels[name]}: {rest}"
        if any(box.link.name == name and not box.members for box in self.links):
            message += "\nSelect it in the view or in the tree, then click Take selection."
        self.state.say_wrong(message)

    def _forget_job(self):
        self._clock.stop()
        job, question, self._job, self._question = self._job, self._question, None, None
        return job, question

    def _write(self):
        before = shown_parents(self.obj)
        for box in self.links:
            setattr(self.obj, box.link.name, box.members)
        if self.feature.HIDES:
            after = shown_parents(self.obj)
            for parent in before:
                parent.Visibility = parent.Visibility or parent not in after
        for name in self._typed.intersection(self.fields):  # widgets round what nobody typed
            setattr(self.obj, name, self.fields[name].read())

    def _enable_fields(self):
        unused = self.feature.unused(self.obj)
        for name, field in self.fields.items():
            field.widget.setEnabled(name not in unused)

    def _close(self):
        self._delay.stop()
        self._clock.stop()
        if self.extra is not None:
            self.extra.leave()
        if FreeCADGui.ActiveDocument is not None:
            FreeCADGui.ActiveDocument.resetEdit()
        FreeCADGui.Control.closeDialog()


def _timer(owner, milliseconds, call, once=False):
    timer = QtCore.QTimer(owner)
    timer.setInterval(milliseconds)
    timer.setSingleShot(once)
    timer.timeout.connect(call)
    return timer
