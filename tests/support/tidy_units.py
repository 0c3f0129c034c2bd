#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names what a build compiles, a line each, for clang-tidy: tidy_units.py COMPILE_COMMANDS [ROOM]"""
import json
import sys
from pathlib import Path

commands = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
room = sys.argv[2] if len(sys.argv) > 2 else ""
files = [each["file"] for each in commands if "/gpl/" not in each["file"]]
# What is compiled together has the room's name with _ for /.
found = [file for file in files if f"/{room}/" in file or f"unity_{room.replace('/', '_')}" in file or not room]
if not found:
    sys.exit(f"no source is in {room}")
print("\n".join(found))
