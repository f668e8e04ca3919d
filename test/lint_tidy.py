#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""clang-tidy over our sources and tests, in parallel.

Most of its time goes into the headers, so the sources of one target, and the tests of one package,
are looked at together, as one translation unit that includes them; each test in a namespace of its
own. Where they cannot stand together, or something is wrong, halves are looked at, down to one file:
what is reported never depends on the neighbours. Tests have the checks of TEST_CHECKS.

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
sys.path.insert(0, str(ROOT / "components/framework/tocsin_cmake/cmake"))
from unite_tests import united  # noqa: E402
CLEAN = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or "~/.cache").expanduser() / "tocsin/tidy"
KEPT_DAYS = 30
TOGETHER = 20  # sources of one translation unit at most: so that every core has work to the end

# Of .clang-tidy what finds mistakes in tests: their names are sentences, and their copies are cheap.
TEST_CHECKS = ("-*,bugprone-argument-comment,bugprone-assert-side-effect,bugprone-copy-constructor-init,"
               "bugprone-dangling-handle,bugprone-inaccurate-erase,bugprone-infinite-loop,bugprone-integer-division,"
               "bugprone-parent-virtual-call,bugprone-string-constructor,bugprone-swapped-arguments,"
               "bugprone-too-small-loop-variable,bugprone-undelegated-constructor,bugprone-unused-raii,"
               "bugprone-use-after-move,bugprone-virtual-near-miss,readability-function-size")

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


def is_test(source):
    return "test" in source.file.parts


def targets():
    """The sources that are ours, each once, by target; those of tests by package."""
    for database in sorted(ROOT.glob("build/*/compile_commands.json")):
        read = dependencies(database.parent)
        found, seen = collections.defaultdict(list), set()
        for entry in json.loads(database.read_text()):
            output = re.search(r" -o (\S+)", entry["command"]).group(1)
            for file in compiled_as_one(pathlib.Path(entry["file"])):
                ours = ROOT in file.parents and ROOT / "build" not in file.parents
                if not ours or file in seen or not file.exists():
                    continue
                seen.add(file)
                source = Source(file, entry["command"], read.get(output, []))
                found["tests" if is_test(source) else output.split(".dir/")[0]].append(source)
        for sources in found.values():
            for first in range(0, len(sources), TOGETHER):
                yield sources[first:first + TOGETHER]


def flags(source):
    """The compiler's flags without its name, its output and its input."""
    words = shlex.split(source.command)
    while words and not words[0].startswith("-"):
        words.pop(0)
    dropped = ("-o", "-c", "-include")  # included is GCC's precompiled GoogleTest, which tests include, too
    return [word for before, word in zip([""] + words, words) if word not in dropped and before not in dropped]


def key(sources):
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes() + TEST_CHECKS.encode())
    for source in sources:
        digest.update(f"{source.file} {flags(source)}".replace(str(ROOT), "").encode())
    for name in sorted({name for source in sources for name in [str(source.file), *source.read]}):
        path = (ROOT / "build" / name) if not os.path.isabs(name) else pathlib.Path(name)
        if ROOT in path.parents and path.exists():
            digest.update(path.read_bytes())
    return digest.hexdigest()


def tidy(file, arguments, test):
    """Empty when the file is clean, else what clang-tidy says. The command may be GCC's."""
    checks = [f"--checks={TEST_CHECKS}", "--header-filter=/test/"] if test else []
    quiet = "-w" if test else "-Wno-unknown-warning-option"
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={ROOT}/.clang-tidy", *checks, str(file), "--",
                           *arguments, quiet],
                          capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stdout or done.stderr


def joined_flags(sources):
    """The flags of all, and where their own headers lie; an option stays in front of its value."""
    beside = [f"-iquote{source.file.parent}" for source in sources]
    options = beside + [flag for source in sources
               for flag in re.sub(r"^(-isystem|-include|-I|-D)\n", "\\1\0", "\n".join(flags(source)), flags=re.M).split("\n")]
    return [word for option in dict.fromkeys(options) for word in option.split("\0")]


def complaints_of(sources):
    test = is_test(sources[0])
    if len(sources) == 1:
        text = tidy(sources[0].file, flags(sources[0]), test)
        return [text] if text else []
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as unit:
        unit.write(united(source.file for source in sources) if test
                   else "".join(f'#include "{one.file}"\n' for one in sources))
        unit.flush()
        arguments = joined_flags(sources) if test else flags(sources[0])
        if not tidy(unit.name, arguments, test):
            return []
    middle = len(sources) // 2
    return complaints_of(sources[:middle]) + complaints_of(sources[middle:])


def check(sources):
    """Complaints about sources of one group; nothing when they are clean."""
    mark = CLEAN / key(sources)
    if mark.exists():
        mark.touch()
        return []
    complaints = complaints_of(sources)
    if not complaints:
        mark.touch()
    return complaints


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
