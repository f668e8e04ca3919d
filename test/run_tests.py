#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of every package of a build tree, or of some, and counts their cases.

usage: run_tests.py [--changed] BUILD_FOLDER LABEL_REGEX [PACKAGE ...]

With --changed a program that is what it was when it passed counts as it did then, and is not run
again (passed_before.py).

As many tests run side by side as there are cores, those that took longest the last time first; system
tests mostly wait, and twice as many run. One with the property RUN_SERIAL runs alone, after the others. A system
test gets a network, process ids, a /dev/shm and mounts of its own, so that no other test hears or
finds it; where the kernel or the container forbids that, system tests run one after the other. A test program that
crashes, or leaves no result file, counts as one failed case. The last line is
"N passed, N failed, N skipped"; the exit code is 1 when a case failed.
"""
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

from passed_before import Memory, digest_of_test

Test = collections.namedtuple("Test", "package name system serial result_file program")
Outcome = collections.namedtuple("Outcome", "passed failed skipped reasons seconds")

# Root has the right to namespaces; anybody else becomes root of a user namespace first. The shell
# stays, as the process that reaps orphans.
PRIVATE_WORLD = ["unshare", "--net", "--mount", "--pid", "--fork", "--mount-proc",
                 *([] if os.geteuid() == 0 else ["--map-root-user"]), "sh", "-c", """mount -t tmpfs -o mode=1777 tmpfs /dev/shm && ip link set lo up &&
                 { echo 0 0 > /proc/sys/net/ipv4/ping_group_range || true; } 2>/dev/null &&
                 "$@"; exit $? """, "-"]
SLOWEST_SHOWN = 5


def tests_of(package, labels):
    """The tests of a package's build folder that have one of the labels."""
    listed = subprocess.run(["ctest", "--show-only=json-v1", "-L", labels], cwd=package,
                            capture_output=True, text=True, check=True)
    for test in json.loads(listed.stdout)["tests"]:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        result = re.search(r"--gtest_output=xml:(\S+)", " ".join(test.get("command", [])))
        yield Test(package, test["name"], "system" in properties.get("LABELS", []),
                   properties.get("RUN_SERIAL", False),
                   pathlib.Path(result.group(1)) if result else None,
                   next((word for word in map(pathlib.Path, test.get("command", []))
                         if word.is_absolute() and package.resolve() in word.parents), None))


def read_cases(result_file):
    """Passed, failed, skipped cases of one result file and the reasons of the skipped ones; None
    when it cannot be read."""
    try:
        root = ElementTree.parse(result_file).getroot()
    except (OSError, ElementTree.ParseError):
        return None
    cases = [case for suite in root for case in suite]
    failed = sum(case.find("failure") is not None for case in cases)
    skipped = [case for case in cases if case.get("result") in ("skipped", "suppressed")]
    reasons = [(case.find("skipped").get("message") or "").split("\n")[-1]
               for case in skipped if case.find("skipped") is not None]
    return len(cases) - failed - len(skipped), failed, len(skipped), reasons


def run(test, prefix):
    """Runs one test, and prints what it printed when it failed."""
    if test.result_file:
        test.result_file.unlink(missing_ok=True)
    begin = time.monotonic()
    done = subprocess.run([*prefix, "ctest", "--output-on-failure", "-R", f"^{re.escape(test.name)}$"],
                          cwd=test.package, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace")
    seconds = time.monotonic() - begin
    good = done.returncode == 0
    counts = (1, 0, 0, []) if good else (0, 1, 0, [])
    if test.result_file:
        counts = read_cases(test.result_file) or (0, 1, 0, [])
        if not good and counts[1] == 0:  # it died after its last case
            counts = (counts[0], 1, *counts[2:])
    if not good or counts[1]:
        print(f"FAILED {test.package.name}: {test.name}\n{done.stdout}", flush=True)
    return Outcome(*counts, seconds)


def name_of(test):
    return f"{test.package.name}/{test.name}"


def read_times(file):
    try:
        return json.loads(file.read_text())
    except (OSError, ValueError):
        return {}


def private_world():
    """What to put before a command so that it hears nobody and nobody hears it; None when this is
    not allowed here."""
    tried = subprocess.run([*PRIVATE_WORLD, "true"], capture_output=True)
    return PRIVATE_WORLD if tried.returncode == 0 else None


def run_all(tests):
    world = private_world() if any(test.system for test in tests) else []
    if world is None:
        print("system tests run one after the other: no network namespaces here", flush=True)
    alone = [test for test in tests if test.serial or (test.system and world is None)]
    wait = any(test.system and test not in alone for test in tests)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() * (2 if wait else 1)) as pool:
        started = [(test, pool.submit(run, test, world if test.system else []))
                   for test in tests if test not in alone]
        outcomes = {test: future.result() for test, future in started}
    outcomes.update((test, run(test, (world or []) if test.system else [])) for test in alone)
    return outcomes


def report(outcomes):
    slowest = sorted(outcomes, key=lambda test: -outcomes[test].seconds)[:SLOWEST_SHOWN]
    print("slowest: " + ", ".join(f"{test.name} {outcomes[test].seconds:.0f} s" for test in slowest))
    for test, outcome in outcomes.items():
        for reason, count in collections.Counter(outcome.reasons).items():
            print(f"skipped {count} of {test.name}: {reason}")
    passed, failed, skipped = (sum(column) for column in
                               zip((0, 0, 0), *(outcome[:3] for outcome in outcomes.values())))
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    return failed == 0 and bool(outcomes)


def run_changed(tests, file):
    """Runs those that are not known to be good as they are."""
    memory = Memory(file)
    programs = {test.program for test in tests}
    digests = {test: digest_of_test(test.package, test.program, programs, test.system)
               for test in tests if test.program}
    known = {test: memory.cases(name_of(test), digest) for test, digest in digests.items()}
    known = {test: cases for test, cases in known.items() if cases is not None}
    outcomes = {test: Outcome(cases, 0, 0, [], 0) for test, cases in known.items()}
    new = run_all([test for test in tests if test not in known])
    outcomes.update(new)
    # What was skipped may be there the next time.
    memory.keep({name_of(test): [digests[test], outcome.passed] for test, outcome in new.items()
                 if test in digests and outcome.failed == outcome.skipped == 0})
    if known:
        print(f"{len(known)} of {len(tests)} programs are those that have passed, and were not run")
    return outcomes, new


def main():
    arguments = sys.argv[1:]
    changed = arguments[:1] == ["--changed"]
    arguments = arguments[changed:]
    if len(arguments) < 2:
        sys.exit(__doc__.split("\n\n")[1])
    build, labels, wanted = pathlib.Path(arguments[0]), arguments[1], arguments[2:]
    packages = sorted(file.parent for file in build.glob("*/CTestTestfile.cmake")
                      if not wanted or file.parent.name in wanted)
    times_file = build / "test_times.json"
    times = read_times(times_file)
    tests = [test for package in packages for test in tests_of(package, labels)]
    # System tests are the long ones, as far as nothing is known.
    tests.sort(key=lambda test: -times.get(name_of(test), 60 * test.system))
    if changed:
        outcomes, new = run_changed(tests, build / "tests_passed.json")
    else:
        outcomes = new = run_all(tests)
    times.update((name_of(test), round(outcome.seconds, 2)) for test, outcome in new.items())
    times_file.write_text(json.dumps(times, indent=1))
    sys.exit(0 if report(outcomes) else 1)


main()
