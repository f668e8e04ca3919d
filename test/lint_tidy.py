#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over our sources (not the tests), in parallel.

Most of its time goes into the headers, so the sources of one target are looked at together, as
one translation unit that includes them. Where they cannot stand together, or something is
wrong, each is looked at by itself: what is reported never depends on the neighbours.

What was clean is remembered in the user's cache folder under the hash of everything that went
into it: the text of the sources and of all our headers that they include, the command line, and
.clang-tidy. It is not looked at again until one of these changes, in whichever clone.
"""
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLEAN = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or "~/.cache").expanduser() / "tocsin/tidy"
KEPT_DAYS = 30
TOGETHER = 20  # sources of one translation unit at most: so that every core has work to the end

Source = collections.namedtuple("Source", "file command read")


def dependencies(package):
    """Object file -> files that the compiler read for it, from Ninja's log."""
    listed = subprocess.run(["ninja", "-t", "deps"], cwd=package, capture_output=True, text=True)
    found = {}
    for block in listed.stdout.split("\n\n"):
        head, *files = block.split("\n")
        found[head.split(":")[0]] = [line.strip() for line in files if line.strip()]
    return found


def compiled_as_one(file):
    """The sources that a file of CMake's unity build includes; any other file itself."""
    if file.parent.name != "Unity" or not file.exists():
        return [file]
    return [pathlib.Path(name) for name in re.findall(r'#include "(.+)"', file.read_text())]


def targets():
    """Package folder -> target -> its sources that are ours and no tests, each once."""
    for database in sorted(ROOT.glob("build/*/compile_commands.json")):
        read = dependencies(database.parent)
        found, seen = collections.defaultdict(list), set()
        for entry in json.loads(database.read_text()):
            output = re.search(r" -o (\S+)", entry["command"]).group(1)
            for file in compiled_as_one(pathlib.Path(entry["file"])):
                ours = ROOT in file.parents and ROOT / "build" not in file.parents
                if not ours or "test" in file.parts or file in seen or not file.exists():
                    continue
                seen.add(file)
                found[output.split(".dir/")[0]].append(
                    Source(file, entry["command"], read.get(output, [])))
        for sources in found.values():
            for first in range(0, len(sources), TOGETHER):
                yield sources[first:first + TOGETHER]


def flags(source):
    """The compiler's flags without its name, its output and its input."""
    words = shlex.split(source.command)
    while words and not words[0].startswith("-"):
        words.pop(0)
    return [word for before, word in zip([""] + words, words)
            if word not in ("-o", "-c") and before not in ("-o", "-c")]


def key(sources):
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes())
    for source in sources:
        digest.update(f"{source.file} {flags(source)}".replace(str(ROOT), "").encode())
    for name in sorted({name for source in sources for name in [str(source.file), *source.read]}):
        path = (ROOT / "build" / name) if not os.path.isabs(name) else pathlib.Path(name)
        if ROOT in path.parents and path.exists():
            digest.update(path.read_bytes())
    return digest.hexdigest()


def tidy(file, arguments):
    """Empty when the file is clean, else what clang-tidy says. The command may be GCC's."""
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={ROOT}/.clang-tidy", str(file), "--", *arguments,
                           "-Wno-unknown-warning-option"],
                          capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stdout or done.stderr


def check(sources):
    """Complaints about sources of one target; nothing when they are clean."""
    mark = CLEAN / key(sources)
    if mark.exists():
        mark.touch()
        return []
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as unit:
        unit.write("".join(f'#include "{source.file}"\n' for source in sources))
        unit.flush()
        clean = not tidy(unit.name, flags(sources[0]))
    complaints = [] if clean else [tidy(source.file, flags(source)) for source in sources]
    if not any(complaints):
        mark.touch()
    return [text for text in complaints if text]


def forget_old():
    for mark in CLEAN.iterdir():
        if time.time() - mark.stat().st_mtime > KEPT_DAYS * 86400:
            mark.unlink(missing_ok=True)


def main():
    CLEAN.mkdir(parents=True, exist_ok=True)
    forget_old()
    groups = sorted(targets(), key=len, reverse=True)
    if not groups:
        sys.exit("lint: nothing to look at; build first (bringup/build)")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = [text for texts in pool.map(check, groups) for text in texts]
    print("\n".join(complaints) or f"clang-tidy: {sum(map(len, groups))} files are clean")
    sys.exit(1 if complaints else 0)


main()
