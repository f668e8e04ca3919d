#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over our sources (not the tests), in parallel.

A file that was clean is remembered in build/tidy/ under the hash of everything that went into it:
its text and that of all our headers that it includes, its command line, .clang-tidy. It is not
looked at again until one of these changes.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLEAN = ROOT / "build/tidy"


def dependencies(package):
    """Object file -> files that the compiler read for it, from Ninja's log."""
    listed = subprocess.run(["ninja", "-t", "deps"], cwd=package, capture_output=True, text=True)
    found = {}
    for block in listed.stdout.split("\n\n"):
        head, *files = block.split("\n")
        found[head.split(":")[0]] = [line.strip() for line in files if line.strip()]
    return found


def compilations():
    """Package folder, source, command line, and what was read, of each source of ours."""
    for database in sorted(ROOT.glob("build/*/compile_commands.json")):
        read = dependencies(database.parent)
        seen = set()
        for entry in json.loads(database.read_text()):
            source = pathlib.Path(entry["file"])
            ours = ROOT in source.parents and ROOT / "build" not in source.parents
            if not ours or "test" in source.parts or source in seen or not source.exists():
                continue
            seen.add(source)
            output = re.search(r" -o (\S+)", entry["command"])
            yield database.parent, source, entry["command"], read.get(output.group(1), [])


def key(source, command, read):
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes())
    digest.update(shlex.join(shlex.split(command)).encode())
    for name in sorted({str(source), *read}):
        path = (ROOT / "build" / name) if not os.path.isabs(name) else pathlib.Path(name)
        if ROOT in path.parents and path.exists():
            digest.update(path.read_bytes())
    return digest.hexdigest()


def check(compilation):
    """Empty when the file is clean, else what clang-tidy says."""
    package, source, command, read = compilation
    mark = CLEAN / key(source, command, read)
    if mark.exists():
        return ""
    done = subprocess.run(["clang-tidy", "--quiet", "-p", str(package), str(source)],
                          capture_output=True, text=True)
    if done.returncode == 0:
        mark.touch()
        return ""
    return done.stdout + (done.stderr if not done.stdout else "")


def main():
    CLEAN.mkdir(parents=True, exist_ok=True)
    files = list(compilations())
    if not files:
        sys.exit("lint: nothing to look at; build first (bringup/build)")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = [text for text in pool.map(check, files) if text]
    print("\n".join(complaints) or f"clang-tidy: {len(files)} files are clean")
    sys.exit(1 if complaints else 0)


main()
