#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damages model files in small ways and runs a command on each.

    mutate.py --seed 1 --count 200 part.step gear.iges -- blossom info

Every file is damaged COUNT times: bytes flipped, numbers and references changed, lines deleted or
doubled, the end cut off. The command gets the damaged file as its last argument. Reported are
signals, exit codes that the command does not have, runs beyond the limit or of more than SLOW
seconds of computing, and messages that are names of C++ things instead of words. The same seed makes the same
damage; `--only N` runs damage N alone and keeps its file.
"""

import argparse
import collections
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

KNOWN_CODES = {0, 2, 3, 4}
NO_WORDS = re.compile(rb"Standard_\w+|StdFail_|NCollection|TColStd|basic_ios|std::|[A-Za-z_]\w+::\w+")


def flip_bytes(data, rng):
    for _ in range(rng.randint(1, 4)):
        data[rng.randrange(len(data))] = rng.randrange(256)


def pick(data, rng, pattern):
    found = [m.span() for m in re.finditer(pattern, data)]
    return rng.choice(found) if found else None


def change_number(data, rng):
    span = pick(data, rng, rb"-?\d+(\.\d*)?([Ee][+-]?\d+)?")
    if span:
        news = [b"0", b"-1", b"1e300", b"nan", b"99999999", b"2147483647", b"x", b"", b"1.5", b"7"]
        data[span[0] : span[1]] = rng.choice(news)


def change_reference(data, rng):
    span = pick(data, rng, rb"#\d+")
    other = pick(data, rng, rb"#\d+")
    if span:
        data[span[0] : span[1]] = rng.choice([data[other[0] : other[1]], b"#0", b"#999999999"])
    else:
        change_number(data, rng)


def some_lines(data, rng):
    lines = bytes(data).splitlines(keepends=True)
    start = rng.randrange(len(lines))
    return lines, start, min(len(lines), start + rng.randint(1, 3))


def delete_lines(data, rng):
    lines, start, end = some_lines(data, rng)
    data[:] = b"".join(lines[:start] + lines[end:])


def double_lines(data, rng):
    lines, start, end = some_lines(data, rng)
    data[:] = b"".join(lines[:end] + lines[start:end] + lines[end:])


def cut_off(data, rng):
    del data[rng.randrange(len(data)) :]


DAMAGES = [flip_bytes, change_number, change_reference, delete_lines, double_lines, cut_off]


def damaged(original, seed, number):
    rng = random.Random(f"{seed}/{number}")
    data = bytearray(original)
    for _ in range(rng.choice([1, 1, 2, 3])):
        if data:
            rng.choice(DAMAGES)(data, rng)
    return bytes(data)


def fault_of(command, file, limit, slow):
    """What is wrong with a run, in a few words; empty if all is well."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        run = subprocess.run([*command, str(file)], capture_output=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return "hang", b""
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if run.returncode < 0 or run.returncode > 128:
        return f"signal {abs(run.returncode) % 128}", run.stderr
    if run.returncode not in KNOWN_CODES:
        return f"exit code {run.returncode}", run.stderr
    said = run.stderr.replace(str(file).encode(), b"")
    if run.returncode == 2 and not said.strip():
        return "says nothing", run.stderr
    if match := NO_WORDS.search(said):
        return f"no words: {match.group().decode(errors='replace')}", run.stderr
    return (f"slow: {seconds:.1f} s", run.stderr) if seconds > slow else ("", run.stderr)


def main():
    arguments, command = sys.argv[1:], []
    if "--" in arguments:
        at = arguments.index("--")
        arguments, command = arguments[:at], arguments[at + 1 :]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100, help="damages of each file")
    parser.add_argument("--limit", type=float, default=20, help="seconds that a run may last")
    parser.add_argument("--slow", type=float, default=2, help="seconds of computing beyond which a run is slow")
    parser.add_argument("--only", type=int, help="the number of one damage")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the files with findings")
    wanted = parser.parse_args(arguments)
    if not command:
        parser.error("-- COMMAND is missing")
    print(f"seed {wanted.seed}")
    findings = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for original in wanted.files:
            data = original.read_bytes()
            numbers = range(wanted.count) if wanted.only is None else [wanted.only]
            for number in numbers:
                file = pathlib.Path(folder) / f"{original.stem}-{number}{original.suffix}"
                file.write_bytes(damaged(data, wanted.seed, number))
                fault, said = fault_of(command, file, wanted.limit, wanted.slow)
                if fault:
                    findings[fault] += 1
                    line = said.strip().splitlines()[-1:] or [b""]
                    print(f"{file.name}: {fault}: {line[0].decode(errors='replace')}", flush=True)
                    if wanted.keep:
                        wanted.keep.mkdir(parents=True, exist_ok=True)
                        shutil.copy(file, wanted.keep)
                file.unlink()
    runs = len(wanted.files) * (wanted.count if wanted.only is None else 1)
    print(f"{runs} runs, {sum(findings.values())} findings")
    for fault, count in findings.most_common():
        print(f"  {count} {fault}")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
