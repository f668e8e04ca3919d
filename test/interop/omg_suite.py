#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the OMG's DDS interoperability suite by its own script, interoperability_report.py, with
`tocsin shapes` on one side and the same program on Cyclone DDS on the other, and prints a table.

usage: omg_suite.py SUITE_FOLDER [CASE ...]     CASE: Test_Domain_0; without, all of them

SUITE_FOLDER is a checkout of github.com/omg-dds/dds-rtps; its script needs python3-pexpect and
python3-junitparser. Both directions run beside each other, each in a network of its own, which
takes root. With data representation XCDR1, as Fast DDS 2.9.1 has no other.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
OURS = REPOSITORY / "install/shapes/bin/tocsin-shapes"
CYCLONE = REPOSITORY / "build/interop_test/cyclone_shapes"
OWN_NETWORK = ["unshare", "--net", "--mount", "--pid", "--fork", "--mount-proc", "sh", "-c",
               'mount -t tmpfs tmpfs /dev/shm && ip link set lo multicast on up && "$@"', "-"]


def results_in(output):
    """By case, what its programs came to as [(expected, found)]; empty when all is as expected."""
    results = {}
    case = None
    for line in output.splitlines():
        verdict = re.match(r"\w*?(Test_\w+) : (OK|ERROR)$", line)
        codes = re.match(r"\w+ expected code: (\w+); Code found: (\w+)$", line)
        if verdict:
            case = verdict.group(1)
            results[case] = []
        elif codes and case:
            results[case].append(codes.groups())
    return results


def run(suite, publisher, subscriber, cases):
    """Results of the suite's script for one direction."""
    with tempfile.TemporaryDirectory() as folder:
        command = [*OWN_NETWORK, sys.executable, str(suite / "interoperability_report.py"),
                   "-P", str(publisher), "-S", str(subscriber), "-x", "1",
                   "-o", f"{folder}/report.xml", *(["-t", *cases] if cases else [])]
        done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=suite)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: {done.stderr.strip()}")
    return results_in(done.stdout)


def cell(result):
    """What stands in the table for a case."""
    found = [code for _, code in result]
    if not found:
        return "yes"
    return "not supported" if any("UNSUPPORTED" in code for code in found) else ", ".join(found)


def table(directions):
    """Rows of the cases that do not come to what is expected, then the sums."""
    lines = ["| case | expected | we publish | Cyclone publishes |", "| --- | --- | --- | --- |"]
    for case in directions[0]:
        results = [direction.get(case, [("?", "NOT_RUN")]) for direction in directions]
        if any(results) and "not supported" not in map(cell, results):
            expected = next(", ".join(code for code, _ in one) for one in results if one)
            lines.append(f"| {case[5:]} | {expected} | {' | '.join(map(cell, results))} |")
    for name, direction in zip(("we publish", "Cyclone publishes"), directions):
        cells = [cell(result) for result in direction.values()]
        supported = len(cells) - cells.count("not supported")
        lines.append(f"\n{name}: {cells.count('yes')} of {supported} as expected, "
                     f"{len(cells) - supported} not supported")
    return "\n".join(lines)


def main():
    """Both directions."""
    if len(sys.argv) < 2 or not (pathlib.Path(sys.argv[1]) / "test_suite.py").exists():
        sys.exit(__doc__)
    suite = pathlib.Path(sys.argv[1]).resolve()
    for program in (OURS, CYCLONE):
        if not os.access(program, os.X_OK):
            sys.exit(f"{program}: build it first")
    with concurrent.futures.ThreadPoolExecutor() as pool:
        jobs = [pool.submit(run, suite, one, other, sys.argv[2:])
                for one, other in ((OURS, CYCLONE), (CYCLONE, OURS))]
        print(table([job.result() for job in jobs]))


if __name__ == "__main__":
    main()
