# SPDX-License-Identifier: LGPL-2.1-or-later
"""The jobs of `blossom batch` on a cluster of Dask.

    python3 -m blossom.distributed JOBS -o RESULTS --local 2
    python3 -m blossom.distributed JOBS -o RESULTS --scheduler tcp://host:8786

List, results and exit codes are those of `blossom batch`; either can go on with what the other has
begun. Workers need the program `blossom`, and the folder of the list under the same name.

A worker has as many jobs at a time as it has threads, and nothing waits in it, so that when it is
lost it is known which jobs it had. They run again, each alone; a job that had a worker KILLS times
when it was lost is reported as failed.
"""

from __future__ import annotations

import argparse
import collections
import fcntl
import importlib
import itertools
import json
import logging
import os
import queue
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

KILLS = 3
LOOK = 0.5  # seconds between two looks at which workers there are
FETCH = 10  # seconds that a result may take from a worker that is there
KEEP = 1  # seconds between two times that results are brought to the disk
CHUNK_SECONDS = 1  # that jobs which are handed over together take
MOST_IN_CHUNK = 100


def dask_distributed() -> Any:
    """Dask's package, which few users of this one need."""
    try:
        return importlib.import_module("distributed")
    except ImportError:
        raise Refused("Dask's package distributed is missing (Debian's python3-distributed)") from None


class Refused(Exception):
    """The batch cannot go on; the message says why."""


def run_chunk(command: list[str], lines: list[bytes]) -> list[bytes]:
    """What a worker does: the results of some jobs, as lines. Fewer if the program was ended."""
    done = subprocess.run(command, input=b"".join(lines), capture_output=True, check=False)
    if done.returncode == 2:  # it refuses what it was told, as no job can make it do
        raise RuntimeError(done.stderr.decode(errors="replace").strip())
    return [line + b"\n" for line in done.stdout.split(b"\n")[:-1]]


class Results:
    """The file of results: one write for each line, at its end; see plugin/cli/batch/results.h."""

    def __init__(self, file: str) -> None:
        self._descriptor = os.open(file, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o666)
        self._kept = time.monotonic()
        try:
            fcntl.flock(self._descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Refused(f"{file}: another batch is writing it") from None

    def add(self, line: bytes) -> None:
        size = os.fstat(self._descriptor).st_size
        try:
            whole = os.write(self._descriptor, line) == len(line)
        except OSError:
            whole = False
        if not whole:
            os.ftruncate(self._descriptor, size)
            raise Refused("the results cannot be written")
        if time.monotonic() > self._kept + KEEP:
            self.keep()

    def keep(self) -> None:
        os.fdatasync(self._descriptor)
        self._kept = time.monotonic()

    def close(self) -> None:
        self.keep()
        os.close(self._descriptor)


def killed_line(job: dict[str, Any]) -> bytes:
    """The result of a job that was there too often when a worker was lost."""
    result = {
        "id": job["id"],
        "status": "failed",
        "code": 1,
        "arguments": job["arguments"],
        "run": {"attempts": KILLS, "seconds": 0, "memory_mb": 0},
        "messages": [f"blossom: its worker was lost each of the {KILLS} times that it ran"],
    }
    return json.dumps(result, ensure_ascii=False, separators=(",", ":")).encode() + b"\n"


class Driver:
    """Hands jobs to the workers of a client and their results to `add`."""

    def __init__(
        self, client: Any, command: list[str], jobs: Iterable[bytes], add: Callable[[bytes], None],
        patience: float,
    ) -> None:  # fmt: skip
        self._client, self._command, self._add, self._patience = client, command, add, patience
        self._jobs = iter(jobs)  # lines
        self._again: collections.deque[bytes] = collections.deque()  # lines, each to run alone
        self._kills: collections.Counter[str] = collections.Counter()  # by id
        self._running: dict[str, tuple[Any, str, list[bytes]]] = {}  # future, worker, lines
        self._ended: queue.SimpleQueue[str] = queue.SimpleQueue()  # keys
        self._numbers = itertools.count()
        self._seconds: float | None = None  # that a job takes
        self.done = 0

    def run(self, tick: Callable[[], None] = lambda: None) -> None:
        """Until every job has a result."""
        workers: dict[str, int] = {}
        seen, looked = time.monotonic(), float("-inf")
        while True:
            now = time.monotonic()
            if now > looked + LOOK:
                workers, looked = self._client.nthreads(), now
                seen = now if workers else seen
                self._take_from_lost(workers)
                tick()
            if now > seen + self._patience:
                raise Refused(f"there has been no worker for {self._patience:g} s")
            self._hand_out(workers)
            if workers and not self._running:
                return
            try:
                self._take(self._ended.get(timeout=LOOK))
            except queue.Empty:
                continue

    def _chunk(self) -> list[bytes]:
        if self._again:
            return [self._again.popleft()]
        wanted = CHUNK_SECONDS / self._seconds if self._seconds else 1
        return list(itertools.islice(self._jobs, max(1, min(MOST_IN_CHUNK, int(wanted)))))

    def _hand_out(self, workers: dict[str, int]) -> None:
        busy = collections.Counter(worker for _, worker, _ in self._running.values())
        for worker, threads in workers.items():
            for _ in range(threads - busy[worker]):
                if lines := self._chunk():
                    self._submit(lines, worker)

    def _submit(self, lines: list[bytes], worker: str) -> None:
        key = f"blossom-{os.getpid()}-{next(self._numbers)}"  # new each time, so that none is blamed
        future = self._client.submit(
            run_chunk, self._command, lines, key=key, workers=[worker], pure=False
        )
        self._running[key] = future, worker, lines
        future.add_done_callback(lambda _, key=key: self._ended.put(key))

    def _take_from_lost(self, workers: dict[str, int]) -> None:
        for key, (future, worker, lines) in list(self._running.items()):
            if worker not in workers:
                del self._running[key]
                future.cancel()
                self._lose(lines)

    def _take(self, key: str) -> None:
        if key not in self._running:
            return
        future, _, lines = self._running.pop(key)
        results = self._fetch(future)
        for result in results:
            self._add(result)
            seconds = json.loads(result)["run"]["seconds"]
            self._seconds = seconds if self._seconds is None else 0.9 * self._seconds + 0.1 * seconds
            self.done += 1
        if len(results) < len(lines):
            have = {json.loads(result)["id"] for result in results}
            self._lose([line for line in lines if json.loads(line)["id"] not in have])

    @staticmethod
    def _fetch(future: Any) -> list[bytes]:
        """Lines; none where the worker was lost. Other errors are the cluster's and end the batch."""
        dask = dask_distributed()
        try:
            results: list[bytes] = future.result(timeout=FETCH)
            return results
        except (dask.KilledWorker, dask.TimeoutError, dask.CancelledError):
            return []
        except FileNotFoundError as error:
            raise Refused(f"a worker has no program '{error.filename}'") from None
        except RuntimeError as error:
            raise Refused(f"a worker says: {error}") from None

    def _lose(self, lines: list[bytes]) -> None:
        for line in lines:
            job = json.loads(line)
            self._kills[job["id"]] += 1
            if self._kills[job["id"]] < KILLS:
                self._again.append(line)
            else:
                self._add(killed_line(job))
                self.done += 1


class ProgressLine:
    """On stderr, if that is a terminal."""

    def __init__(self, driver: Driver, count: int, quiet: bool) -> None:
        self._driver, self._count = driver, count
        self._silent = quiet or not sys.stderr.isatty()
        self._start = time.monotonic()

    def tick(self) -> None:
        if self._silent or not self._driver.done:
            return
        rate = self._driver.done / (time.monotonic() - self._start)
        left = (self._count - self._driver.done) / rate
        print(f"\r\033[K{self._driver.done} of {self._count} jobs; {rate:.3g} a second, {left:.0f} s left",
              end="", file=sys.stderr, flush=True)  # fmt: skip

    def wipe(self) -> None:
        if not self._silent:
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def client_of(given: argparse.Namespace) -> Any:
    dask = dask_distributed()
    for name in ("distributed", "asyncio"):  # lost workers are no news here
        logging.getLogger(name).setLevel(logging.CRITICAL)
    if given.scheduler:
        return dask.Client(given.scheduler, timeout=given.patience)
    cluster = dask.LocalCluster(
        n_workers=given.local, threads_per_worker=1, dashboard_address=None, silence_logs=logging.CRITICAL
    )
    return dask.Client(cluster)


def parsed(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python3 -m blossom.distributed", description="the jobs of `blossom batch` on a cluster of Dask")
    parser.add_argument("jobs", metavar="JOBS", help="list of jobs (JSON lines)")
    parser.add_argument("-o", "--output", metavar="FILE", required=True, help="results, added to")
    where = parser.add_mutually_exclusive_group(required=True)
    where.add_argument("--scheduler", metavar="ADDRESS", help="such as tcp://host:8786")
    where.add_argument("--local", metavar="N", type=int, help="start so many workers here")
    parser.add_argument("--shard", metavar="I/N", help="do only a part of the jobs")
    parser.add_argument("--folder", metavar="DIR", help="where the jobs work; else where the list is")
    for name in ("--time-limit", "--memory-limit", "--retries"):
        parser.add_argument(name, help="as `blossom batch` has it")
    parser.add_argument("--cache", metavar="DIR", help="as `blossom batch` has it; on each worker")
    parser.add_argument("--threads", default="1", help="of a job")
    parser.add_argument("--patience", metavar="S", type=float, default=60, help="seconds to wait for workers")
    parser.add_argument("--program", default="blossom", help="the program, on the workers, too")
    parser.add_argument("-q", "--quiet", action="store_true", help="say nothing but errors")
    return parser.parse_args(arguments)


def passed(given: argparse.Namespace, *names: str) -> list[str]:
    """Options of `blossom batch` as they were given here."""
    values = {name: getattr(given, name[2:].replace("-", "_")) for name in names}
    return [word for name, value in values.items() if value is not None for word in (name, value)]


def work(given: argparse.Namespace, lines: list[bytes]) -> None:
    command = [given.program, "batch", "-", "-o", "-", "-q", "-j", "1", "--folder",
               os.path.abspath(given.folder or Path(given.jobs).parent),
               *passed(given, "--time-limit", "--memory-limit", "--retries", "--threads", "--cache")]  # fmt: skip
    results = Results(given.output)
    with client_of(given) as client:
        try:
            driver = Driver(client, command, lines, results.add, given.patience)
            progress = ProgressLine(driver, len(lines), given.quiet)
            driver.run(progress.tick)
            progress.wipe()
        finally:
            results.close()
            if client.cluster:
                client.cluster.close()


def of_this_run(summary: str, done: int, seconds: float) -> str:
    """What `blossom batch` says once all results are there, with those that were made now."""

    def told(found: re.Match[str]) -> str:
        before = int(found[1]) - done
        return (f"; {before} of them before" if before > 0 else "") + f"; {seconds:.3g} s"

    return re.sub(r"; (\d+) of them before; \S+ s$", told, summary, count=1, flags=re.MULTILINE)


def all_done(given: argparse.Namespace) -> int:
    """The exit code."""
    if given.cache:
        given.cache = os.path.abspath(given.cache)
    if os.sep in given.program:
        given.program = os.path.abspath(given.program)
    if shutil.which(given.program) is None:
        raise Refused(f"there is no program '{given.program}'; --program names it")
    batch = [given.program, "batch", given.jobs, "-o", given.output, *passed(given, "--shard", "--folder")]
    # The program looks at the list, repairs the results, and says what is left.
    left = subprocess.run([*batch, "--list"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=False)
    if left.returncode != 0:
        return left.returncode
    start = time.monotonic()
    if lines := left.stdout.splitlines(keepends=True):
        work(given, lines)
    # With all results there, it makes the summary and the exit code.
    quiet = ["-q"] if given.quiet else []
    end = subprocess.run([*batch, *quiet], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=False)
    print(of_this_run(end.stdout, len(lines), time.monotonic() - start) if lines else end.stdout, end="")
    return end.returncode


def main(arguments: list[str] | None = None) -> int:
    """Returns the exit code."""
    try:
        return all_done(parsed(arguments))
    except KeyboardInterrupt:
        print("blossom: interrupted; the same command does what has no result yet", file=sys.stderr)
        return 130
    except (Refused, OSError) as error:
        print(f"blossom: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
