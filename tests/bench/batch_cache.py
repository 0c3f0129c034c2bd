#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `blossom batch --cache` saves, and that it changes nothing.

    batch_cache.py BLOSSOM FOLDER MODEL...

Each model is looked at by a few jobs, in three runs: without a folder of models, with an empty one,
and with the one that the second run has filled. Prints processor seconds of each, and the jobs whose
results differ.
"""

import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
from pathlib import Path

COMMANDS = {
    "info": ["info", "{}"],
    "face": ["intersect", "{}#1", "{}#2"],
    "point": ["query", "point", "{}", "--at", "1,2,3"],
    "bounds": ["query", "plane", "{}", "--point", "0,0,0.1", "--normal", "0.1,0.2,1"],
}


def write_jobs(file, models):
    with open(file, "w", encoding="utf-8") as out:
        for model in models:
            for name, words in COMMANDS.items():
                arguments = [word.replace("{}", os.path.abspath(model)) for word in words] + ["--json", "-"]
                out.write(json.dumps({"id": f"{name} {model}", "arguments": arguments}) + "\n")


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, out):
    """Processor seconds, and the lasting results by their ids."""
    out.unlink(missing_ok=True)
    before = processor_seconds()
    subprocess.run([*map(str, command), str(out)], check=False)
    results = {}
    for line in out.read_text(encoding="utf-8").splitlines():
        result = json.loads(line)
        result.pop("run")
        for name in ("seconds", "seconds_first"):
            result.get("report", {}).pop(name, None)
        results[result["id"]] = json.dumps(result, sort_keys=True)
    return processor_seconds() - before, results


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("models", nargs="+")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    jobs, cache = given.folder / "jobs.jsonl", given.folder / "cache"
    write_jobs(jobs, given.models)
    shutil.rmtree(cache, ignore_errors=True)
    batch = [given.program, "batch", jobs, "-q", "--time-limit", "120"]
    seconds, expected = run([*batch, "-o"], given.folder / "without.jsonl")
    print(f"without: {len(expected)} jobs, {seconds:.1f} processor seconds", flush=True)
    differ = 0
    for name in ("empty", "filled"):
        seconds, found = run([*batch, "--cache", cache, "-o"], given.folder / f"{name}.jsonl")
        others = [job for job in expected if found.get(job) != expected[job]]
        differ += len(others)
        print(f"{name}: {seconds:.1f} processor seconds; {len(others)} differ", *others[:5], sep="\n  ", flush=True)
    entries = [file.stat().st_size for file in cache.glob("*.model")]
    print(f"{len(entries)} of {len(given.models)} models are kept, {sum(entries) / 1e6:.1f} MB")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
