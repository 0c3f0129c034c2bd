# SPDX-License-Identifier: LGPL-2.1-or-later
"""Questions in threads of their own, so that the window goes on answering."""

import threading

import FreeCAD

PAUSE = 0.02  # seconds between looks at the work


class Job(threading.Thread):
    """One question. `ask` gets a door, which `cancel` closes."""

    def __init__(self, door, ask):
        super().__init__(daemon=True, name="blossom")
        self._door = door
        self._ask = ask
        self._answer = None
        self._error = None

    def run(self):
        try:
            self._answer = self._ask(self._door)
        except BaseException as error:  # noqa: B902 - it is raised again by answer()
            self._error = error

    def cancel(self):
        self._door.cancel()

    @property
    def done(self):
        return not self.is_alive()

    @property
    def cancelled(self):
        return isinstance(self._error, self._door.Cancelled)

    def answer(self):
        """What came out, or what went wrong as an exception; of work that is done."""
        if self._error is not None:
            raise self._error
        return self._answer


def answer_of(job, text):
    """Starts a question and waits for its answer. Meanwhile a window paints itself and takes no
    input but the cancelling; without one, Ctrl-C cancels.

    text   what is being done, "Intersecting faces"
    """
    job.start()
    try:
        if FreeCAD.GuiUp:
            from .waiting import wait

            wait(job, text)
        else:
            while not job.done:
                job.join(PAUSE)
    except BaseException:
        job.cancel()
        job.join()
        raise
    return job.answer()
