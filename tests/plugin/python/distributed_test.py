# SPDX-License-Identifier: LGPL-2.1-or-later
"""The jobs of a batch on a cluster: one result for each, whatever happens to workers."""

import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from support import made_files

try:
    import distributed
except ImportError:
    distributed = None

PROGRAM = os.environ["BLOSSOM_PROGRAM"]
INTERSECT = ["intersect", "block.step", "drill.step", "--json", "-"]

# Stands before the program: a job named "killer" takes the worker that has it with it.
WRAPPER = """#!/bin/sh
jobs=$(cat)
case "$jobs" in *killer*) echo x >> "{folder}/kills"; kill -9 $PPID; exit 9 ;; esac
printf '%s\\n' "$jobs" | "{program}" "$@"
"""


def lasting(result):
    """A result without what differs from run to run."""
    report = {k: v for k, v in result.get("report", {}).items() if not k.startswith("seconds")}
    return {**{k: v for k, v in result.items() if k != "run"}, "report": report}


@unittest.skipIf(distributed is None, "Dask's distributed is not installed")
class Distributed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.models = made_files()

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="blossom-distributed-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        for name in ("block.step", "drill.step"):
            (self.folder / name).symlink_to(self.models / name)
        self.list = self.folder / "jobs.jsonl"
        self.results = self.folder / "results.jsonl"

    def write_jobs(self, jobs):
        self.list.write_text("".join(json.dumps({"id": k, "arguments": v}) + "\n" for k, v in jobs.items()))

    def run_module(self, *options, **more):
        command = [sys.executable, "-m", "blossom.distributed", self.list, "-o", self.results]
        return subprocess.run([*command, *options], text=True, capture_output=True, timeout=100, **more)

    def found(self, file=None):
        results = [json.loads(line) for line in (file or self.results).read_text().splitlines()]
        by_id = {result["id"]: result for result in results}
        self.assertEqual(len(by_id), len(results), "a job has two results")
        return by_id

    def expected(self):
        file = self.folder / "single.jsonl"
        subprocess.run([PROGRAM, "batch", self.list, "-o", file, "-q"], check=False)
        return {name: lasting(result) for name, result in self.found(file).items()}

    def start(self, *command):
        process = subprocess.Popen(
            [sys.executable, "-m", *map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start_cluster(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
        port = address.rpartition(":")[2]
        self.start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard")
        worker = ["distributed.cli.dask_worker", address, "--host", "127.0.0.1", "--nthreads", 1,
                  "--no-dashboard", "--no-nanny", "--local-directory", self.folder]  # fmt: skip
        return address, [self.start(*worker, "--name", name) for name in ("w0", "w1")]

    def test_results_are_those_of_one_machine(self):
        self.write_jobs({**{f"cut {i}": INTERSECT for i in range(6)}, "missing": ["info", "nowhere.step"]})
        done = self.run_module("--local", "2", "--program", PROGRAM)
        self.assertEqual(done.returncode, 1, done.stderr)  # a job failed
        self.assertTrue(done.stdout.startswith("7 jobs: 6 done, 0 stopped, 1 failed; "), done.stdout)
        self.assertNotIn("of them before", done.stdout)
        self.assertEqual({k: lasting(v) for k, v in self.found().items()}, self.expected())
        before = self.results.read_text()
        self.assertEqual(self.run_module("--local", "2", "--program", PROGRAM).returncode, 1)
        self.assertEqual(self.results.read_text(), before)

    def test_jobs_of_a_lost_worker_run_again(self):
        self.write_jobs({f"cut {i}": INTERSECT for i in range(60)})
        address, workers = self.start_cluster()
        command = [sys.executable, "-m", "blossom.distributed", self.list, "-o", self.results]
        driver = subprocess.Popen([*command, "--scheduler", address, "--program", PROGRAM, "-q"])
        while not (self.results.exists() and self.results.read_text().count("\n") > 3):
            self.assertIsNone(driver.poll())
            time.sleep(0.05)
        workers[0].send_signal(signal.SIGKILL)
        self.assertEqual(driver.wait(100), 0)
        self.assertEqual({k: lasting(v) for k, v in self.found().items()}, self.expected())

    def test_job_that_kills_its_workers_fails_and_the_others_are_done(self):
        wrapper = self.folder / "wrapper"
        wrapper.write_text(WRAPPER.format(program=PROGRAM, folder=self.folder))
        wrapper.chmod(0o755)
        self.write_jobs({"cut 1": INTERSECT, "killer": INTERSECT, **{f"cut {i}": INTERSECT for i in range(2, 9)}})
        done = self.run_module("--local", "2", "--program", wrapper)
        self.assertEqual(done.returncode, 1, done.stderr)
        found = self.found()
        self.assertEqual(found.pop("killer")["messages"], ["blossom: its worker was lost each of the 3 times that it ran"])
        self.assertEqual({result["status"] for result in found.values()}, {"done"})
        self.assertEqual(len(found), 8)
        self.assertEqual((self.folder / "kills").read_text().count("x"), 3)

    def test_what_cannot_begin_is_said(self):
        self.write_jobs({"a": INTERSECT})
        self.assertIn("there is no program 'nowhere'", self.run_module("--local", "1", "--program", "nowhere").stderr)
        self.list.write_text("no JSON\n")
        refused = self.run_module("--local", "1", "--program", PROGRAM)
        self.assertEqual(refused.returncode, 2)
        self.assertTrue(refused.stderr.startswith(f"blossom: {self.list}:1: is no JSON, as a job is: "))


if __name__ == "__main__":
    unittest.main()
