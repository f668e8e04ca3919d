# SPDX-License-Identifier: Apache-2.0
"""Which test programs of a build tree have passed as they are, so that they need not run again.

A program is the same while its own bytes, those of our libraries that it loads, of the other
programs of its package, of the package's pages, and of whatever is neither page nor C++ source in
the repository are the same, and the environment's variables for it; a system test, while all that
is installed is the same, too. One that failed is not remembered.
"""
import functools
import hashlib
import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
VARIABLES = ("ASAN_OPTIONS", "TSAN_OPTIONS", "UBSAN_OPTIONS", "TOCSIN_SHARED")


@functools.lru_cache(maxsize=None)
def digest_of(file):
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError:
        return "none"


@functools.lru_cache(maxsize=None)
def files_below(folder):
    """Those of the repository, and new ones that Git does not ignore."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=folder,
                            capture_output=True, text=True, check=True).stdout.split("\0")
    return sorted(folder / name for name in listed if name)


def digest_of_all(files):
    text = "\n".join(f"{file} {digest_of(file)}" for file in files)
    return hashlib.sha256(text.encode()).hexdigest()


@functools.lru_cache(maxsize=None)
def repository_digest():
    return digest_of_all(file for file in files_below(ROOT)
                         if file.suffix not in (".cpp", ".hpp", ".md"))


@functools.lru_cache(maxsize=None)
def pages_digest(package):
    """Of the pages of a package, whose build folder is given: tests read what they promise."""
    cache = (package / "CMakeCache.txt").read_text()
    source = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache, re.MULTILINE).group(1)
    return digest_of_all(file for file in files_below(pathlib.Path(source))
                         if file.suffix == ".md")


def is_program(file):
    return file.is_file() and os.access(file, os.X_OK)


@functools.lru_cache(maxsize=None)
def loaded_by(program):
    """The libraries of the workspace that a program loads."""
    listed = subprocess.run(["ldd", program], capture_output=True, text=True).stdout
    paths = (line.split("=>")[-1].split("(")[0].strip() for line in listed.splitlines())
    return sorted(pathlib.Path(path) for path in paths if path.startswith(str(ROOT)))


@functools.lru_cache(maxsize=None)
def installed_digest():
    return digest_of_all(sorted(file for file in (ROOT / "install").rglob("*") if file.is_file()))


def digest_of_test(package, program, tests, system):
    """What decides what a test program of a package's build folder does; `tests` are all test programs,
    `system`: whether it runs what is installed."""
    others = sorted(file for place in ("*", "*/*") for file in package.resolve().glob(place)
                    if is_program(file) and file not in tests)
    read = [program, *others, *loaded_by(program)]
    facts = [repository_digest(), pages_digest(package), *(f"{file.name} {digest_of(file)}" for file in read),
             *([installed_digest()] if system else []), *(f"{name}={os.environ.get(name)}" for name in VARIABLES)]
    return hashlib.sha256("\n".join(facts).encode()).hexdigest()


class Memory:
    """The tests of a build tree that passed whole: name -> [digest, cases], in a file of the tree."""

    def __init__(self, file):
        self.file = file
        try:
            self.tests = json.loads(file.read_text())
        except (OSError, ValueError):
            self.tests = {}

    def cases(self, name, digest):
        """How many cases passed when the test was as it is; None when it is not known to be good."""
        known, cases = self.tests.get(name, (None, None))
        return cases if known == digest else None

    def keep(self, passed):
        """`passed`: name -> [digest, cases]."""
        self.tests.update(passed)
        self.file.write_text(json.dumps(self.tests, indent=1))
