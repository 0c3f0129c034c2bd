# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints where this interpreter looks for packages below an install prefix, relative to it.

usage: install_folder.py PREFIX

Debian's looks below /usr/lib/python3 and below /usr/local/lib/python3.11. Below a prefix where it
looks nowhere, packages lie as below its own.
"""

import site
import sys
from pathlib import Path


def package_folder(prefix):
    """The first folder of packages below a prefix that is not one of the prefix `local` in it."""
    for folder in map(Path, site.getsitepackages()):
        if folder.is_relative_to(prefix) and folder.relative_to(prefix).parts[0] != "local":
            return folder.relative_to(prefix)
    return None


print(package_folder(sys.argv[1]) or package_folder(sys.prefix))
