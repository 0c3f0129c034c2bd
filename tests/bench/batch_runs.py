#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs many small jobs through `blossom batch` and Dask, disturbs them, and compares the results.

    batch_runs.py BLOSSOM FOLDER --jobs 2000 --models MODELS --disturb --dask

Pairs of random bicubic patches are intersected, and with `--models` a tenth of the jobs asks for points
and sections of the models in that folder. There are three runs: undisturbed, with the driver killed and
started again, and with `--dask` through two workers, of which one is killed by its id at a third, and the
driver with `--disturb` at two thirds and started again. Every result has to be there once and, but for
times, to be that of the undisturbed run; a run that ended before it was disturbed is an error. Prints
seconds, rates, processor time and memory. PYTHONPATH has the package `blossom`.
"""

import argparse
import json
import math
import os
import random
import resource
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path


def make_models(program, folder, count):
    """Patches a0, a1, ... and b0, b1, ...: heights at random over the unit square."""
    rng = random.Random(1)
    for kind in "ab":
        for number in range(count):
            points = [[[i / 3, j / 3, rng.uniform(-0.3, 0.3)] for j in range(4)] for i in range(4)]
            net = {"kind": "patch", "degree": [3, 3], "points": points}
            file = folder / "net.json"
            file.write_text(json.dumps({"schema": "blossom.net/1", "nets": [net]}))
            subprocess.run([program, "convert", file, "-o", folder / f"{kind}{number}.brep", "-q"], check=True)


def question(files, number):
    """About a model: the nearest point, or a section, at places that differ from job to job."""
    file = str(files[number % len(files)])
    at = f"{number % 89},{number % 83},{number % 79}"
    if number // len(files) % 2:
        return ["query", "plane", file, "--point", at, "--normal", "1,2,3", "--json", "-"]
    return ["query", "point", file, "--at", at, "--json", "-"]


def write_jobs(folder, count, patches, files):
    with open(folder / "jobs.jsonl", "w", encoding="utf-8") as out:
        for number in range(count):
            a, b = number % patches, number // patches % patches
            arguments = ["intersect", f"a{a}.brep", f"b{b}.brep", "--json", "-"]
            if files and number % 10 == 0:
                arguments = question(files, number // 10)
            out.write(json.dumps({"id": f"job {number}", "arguments": arguments}) + "\n")


def lasting(line):
    result = json.loads(line)
    del result["run"]
    report = result.get("report", {})
    for name in ("seconds", "seconds_first"):
        report.pop(name, None)
    return result["id"], result


def results(file, count):
    lines = file.read_text(encoding="utf-8").splitlines()
    found = dict(map(lasting, lines))
    if len(lines) != count or len(found) != count:
        sys.exit(f"{file}: {len(lines)} lines, {len(found)} jobs, not {count}")
    return found


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, kill_after=None):
    """Seconds, and the exit code; negative if it was killed."""
    start = time.monotonic()
    process = subprocess.Popen([str(word) for word in command])
    try:
        process.wait(kill_after)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    return time.monotonic() - start, process.returncode


def start_cluster(folder):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    address = f"tcp://127.0.0.1:{port}"
    python = [sys.executable, "-m"]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    scheduler = ["distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", port, "--no-dashboard"]
    worker = ["distributed.cli.dask_worker", address, "--host", "127.0.0.1", "--nthreads", "1",
              "--no-dashboard", "--no-nanny", "--local-directory", str(folder)]  # fmt: skip
    processes = [subprocess.Popen([*python, *scheduler], **quiet)]
    processes += [subprocess.Popen([*python, *worker, "--name", name], **quiet) for name in ("w0", "w1")]
    return address, processes


def end_undisturbed(what):
    sys.exit(f"{what} was not killed: the run ended before; give it more --jobs")


def run_on_cluster(program, folder, jobs, disturb):
    """With one of two workers killed at a third of the results, and the driver at two thirds."""
    address, processes = start_cluster(folder)
    out = folder / "dask.jsonl"
    is_whole, is_left_alone = True, disturb
    start = time.monotonic()
    command = [sys.executable, "-m", "blossom.distributed", folder / "jobs.jsonl", "-o", out,
               "--scheduler", address, "--program", program, "-q"]  # fmt: skip
    command = [str(word) for word in command]
    driver = subprocess.Popen(command)
    while driver.poll() is None:
        time.sleep(0.5)
        have = out.read_bytes().count(b"\n") if out.exists() else 0
        if is_whole and processes[1].poll() is None and jobs / 3 < have < jobs:
            is_whole = False
            processes[1].send_signal(signal.SIGKILL)
            print(f"dask: worker {processes[1].pid} killed after {time.monotonic() - start:.1f} s "
                  f"with {have} results", flush=True)  # fmt: skip
        if is_left_alone and jobs * 2 / 3 < have < jobs:
            driver.kill()
            if driver.wait() != -signal.SIGKILL:
                break
            is_left_alone = False
            print(f"dask: driver killed after {time.monotonic() - start:.1f} s with {have} results", flush=True)
            driver = subprocess.Popen(command)
    seconds = time.monotonic() - start
    for process in processes:
        process.kill()
        process.wait()
    if is_whole:
        end_undisturbed("dask: the worker")
    if is_left_alone:
        end_undisturbed("dask: the driver")
    return seconds, driver.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--jobs", type=int, default=2000)
    parser.add_argument("--in-flight", default="2")
    parser.add_argument("--models", type=Path, help="folder of models to ask about, too")
    parser.add_argument("--disturb", action="store_true", help="kill the driver and start it again")
    parser.add_argument("--dask", action="store_true")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    program = os.path.abspath(given.program)
    patches = max(10, math.isqrt(given.jobs - 1) + 1)
    if not (given.folder / f"b{patches - 1}.brep").exists():
        make_models(program, given.folder, patches)
    known = (".brep", ".step", ".stp", ".iges")
    files = [file for file in sorted(given.models.iterdir()) if file.suffix in known] if given.models else []
    write_jobs(given.folder, given.jobs, patches, files)

    batch = [program, "batch", given.folder / "jobs.jsonl", "-q", "-j", given.in_flight, "-o"]
    calm = given.folder / "calm.jsonl"
    calm.unlink(missing_ok=True)
    before = processor_seconds()
    seconds, code = run([*batch, calm])
    processor = processor_seconds() - before
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    expected = results(calm, given.jobs)
    print(f"undisturbed: {given.jobs} jobs, {seconds:.1f} s, {given.jobs / seconds:.1f} a second, code {code}, "
          f"{processor:.2f} s of processor time, at most {memory:.0f} MB a process, {calm.stat().st_size / 1e6:.1f} MB of results", flush=True)  # fmt: skip
    if given.disturb:
        out = given.folder / "disturbed.jsonl"
        out.unlink(missing_ok=True)
        first, code = run([*batch, out], kill_after=seconds / 2)
        if code != -signal.SIGKILL:
            end_undisturbed("the driver")
        before = out.read_bytes().count(b"\n")
        rest, code = run([*batch, out])
        same = results(out, given.jobs) == expected
        print(f"driver killed after {first:.1f} s with {before} results, rest {rest:.1f} s, code {code}: "
              f"{'the same' if same else 'NOT THE SAME'}", flush=True)  # fmt: skip
    if given.dask:
        (given.folder / "dask.jsonl").unlink(missing_ok=True)
        seconds, code = run_on_cluster(program, given.folder, given.jobs, given.disturb)
        same = results(given.folder / "dask.jsonl", given.jobs) == expected
        print(f"dask: {seconds:.1f} s, {given.jobs / seconds:.1f} a second, code {code}: "
              f"{'the same' if same else 'NOT THE SAME'}", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
