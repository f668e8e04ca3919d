#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of every package of a build tree, or of some, and counts their cases.

usage: run_tests.py BUILD_FOLDER LABEL_REGEX [PACKAGE ...]

Unit and component tests run in parallel, system tests one after the other. A test program that
crashes, or leaves no result file, counts as one failed case. The last line is
"N passed, N failed, N skipped"; the exit code is 1 when a case failed.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree


def tests_of(package, labels):
    """Name, labels and result file of each test of a package's build folder."""
    listed = subprocess.run(["ctest", "--show-only=json-v1", "-L", labels], cwd=package,
                            capture_output=True, text=True, check=True)
    for test in json.loads(listed.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        command = " ".join(test.get("command", []))
        result = re.search(r"--gtest_output=xml:(\S+)", command)
        yield (package, test["name"], properties.get("LABELS", []),
               pathlib.Path(result.group(1)) if result else None)


def count_cases(result_file):
    """Passed, failed, skipped cases of one result file; None when it cannot be read."""
    try:
        root = ElementTree.parse(result_file).getroot()
    except (OSError, ElementTree.ParseError):
        return None
    cases = [case for suite in root for case in suite]
    failed = sum(case.find("failure") is not None for case in cases)
    skipped = sum(case.get("result") in ("skipped", "suppressed") for case in cases)
    return len(cases) - failed - skipped, failed, skipped


def run(test):
    """Runs one test; its counts and, when it failed, what it printed."""
    package, name, _, result_file = test
    if result_file:
        result_file.unlink(missing_ok=True)
    done = subprocess.run(["ctest", "--output-on-failure", "-R", f"^{re.escape(name)}$"],
                          cwd=package, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace")
    good = done.returncode == 0
    if result_file is None:
        counts = (1, 0, 0) if good else (0, 1, 0)
    else:
        counts = count_cases(result_file) or (0, 1, 0)
        if not good and counts[1] == 0:  # it died after its last case
            counts = (counts[0], 1, counts[2])
    if not good or counts[1]:
        print(f"FAILED {package.name}: {name}\n{done.stdout}", flush=True)
    return counts


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.split("\n\n")[1])
    wanted = sys.argv[3:]
    packages = sorted(file.parent for file in
                      pathlib.Path(sys.argv[1]).glob("*/CTestTestfile.cmake")
                      if not wanted or file.parent.name in wanted)
    tests = [test for package in packages for test in tests_of(package, sys.argv[2])]
    alone = [test for test in tests if "system" in test[2]]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = list(pool.map(run, [test for test in tests if test not in alone]))
    counts += [run(test) for test in alone]
    passed, failed, skipped = (sum(column) for column in zip((0, 0, 0), *counts))
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    sys.exit(1 if failed or not tests else 0)


main()
