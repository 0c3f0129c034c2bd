# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work that is ended, watched, or asked for by several threads at a time."""

import os
import sys
import threading
import unittest

import numpy as np
from support import FLOOR, HARD, HARD_OPTIONS, WALL, made_files

import blossom

BLOCK = made_files() / "block.step"


class Ending(unittest.TestCase):
    def test_a_handle_ends_work(self):
        cancel = blossom.Cancel()
        threading.Timer(0.2, cancel.cancel).start()
        with self.assertRaises(blossom.Cancelled):
            blossom.intersect(*HARD, time_limit=60, cancel=cancel, **HARD_OPTIONS)
        self.assertTrue(cancel.cancelled)

    def test_progress_is_told_and_may_end_work(self):
        told = []

        def progress(seconds):
            told.append(seconds)
            if len(told) == 5:
                raise KeyError("enough")

        with self.assertRaisesRegex(KeyError, "enough"):
            blossom.intersect(*HARD, time_limit=60, progress=progress, **HARD_OPTIONS)
        self.assertEqual(told, sorted(told))

    @unittest.skipUnless(sys.platform == "linux", "only there threads have priorities")
    def test_work_gives_way_and_its_caller_does_not(self):
        """That would keep Python's lock from others for as long as it waits for its turn."""
        own = os.getpriority(os.PRIO_PROCESS, threading.get_native_id())
        seen = set()

        def progress(seconds):
            threads = (int(each) for each in os.listdir("/proc/self/task"))
            seen.update(os.getpriority(os.PRIO_PROCESS, each) for each in threads)
            raise KeyError("enough")

        with self.assertRaisesRegex(KeyError, "enough"):
            blossom.intersect(*HARD, time_limit=60, nice=7, progress=progress, **HARD_OPTIONS)
        self.assertIn(min(own + 7, 19), seen)  # the system's last one
        self.assertEqual(os.getpriority(os.PRIO_PROCESS, threading.get_native_id()), own)
        with self.assertRaisesRegex(ValueError, "^nice: 20 is more than 19$"):
            blossom.intersect(FLOOR, WALL, nice=20)

    def test_what_a_model_holds_may_be_asked_while_another_thread_works(self):
        for _ in range(20):
            model = blossom.read(BLOCK)
            done = threading.Event()

            def ask():
                while not done.is_set():
                    model.face_names, model.part_paths, model.face_numbers, model.to_brep()
            asking = threading.Thread(target=ask)
            asking.start()
            try:
                model.area
                model.check()
            finally:
                done.set()
                asking.join()

    def test_two_threads_may_ask_one_model(self):
        model, lengths = blossom.read(BLOCK), []

        def ask():
            for z in range(1, 20):
                lengths.append(model.section((0, 0, z), (0, 0, 1))[0].length)

        threads = [threading.Thread(target=ask) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        np.testing.assert_allclose(lengths, 200)


if __name__ == "__main__":
    unittest.main(verbosity=2)
