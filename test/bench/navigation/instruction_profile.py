#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Instructions that each component of a vehicle takes while it drives, by valgrind's callgrind.

usage: instruction_profile.py [BRINGUP_FILE] [SECONDS]

Simulates the bringup file (obstacles.yaml) for two durations and prints, for the time between, the
instructions of each component's ticks per simulated second, and the share of a core of a Cortex-A53
that they would take at 1.2 GHz (Raspberry Pi 3) with 0.6 instructions a cycle, an assumption. DDS,
sockets and the kernel are not simulated, so they are not counted. Needs valgrind and a sourced
installation (tocsin).
"""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

START_S = 15  # until it drives, and files are loaded
A53_HZ = 1.2e9
A53_PER_CYCLE = 0.6
TICK = re.compile(r"^\s*([\d,]+)\s.*?tocsin::(?:[a-z_]+::)*(\w+Component)::tick\(")


def instructions(bringup, seconds, folder):
    """Inclusive instructions of each component's ticks."""
    counts = folder / f"counts_{seconds}"
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", "tocsin-sim", bringup, "--seed", "1",
               "--duration", str(seconds), "--run-dir", str(folder / f"run_{seconds}")]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"instruction_profile.py: {' '.join(command)}: {done.stderr[-400:]}")
    listed = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", str(counts)],
                            capture_output=True, text=True, check=True, env=os.environ | {"LC_ALL": "C"})
    ticks = collections.Counter()
    for line in listed.stdout.splitlines():
        if found := TICK.match(line):
            ticks[found[2]] += int(found[1].replace(",", ""))
    return ticks


def main():
    bringup = sys.argv[1] if len(sys.argv) > 1 else "obstacles.yaml"
    seconds = int(sys.argv[2]) if len(sys.argv) > 2 else 30
    with tempfile.TemporaryDirectory() as folder:
        before = instructions(bringup, START_S, pathlib.Path(folder))
        after = instructions(bringup, START_S + seconds, pathlib.Path(folder))
    print("| component | million instructions a second | of a Cortex-A53 core, % |\n| --- | --- | --- |")
    total = 0
    for name, count in sorted((after - before).items(), key=lambda one: -one[1]):
        total += count
        print_row(name, count / seconds)
    print_row("together", total / seconds)


def print_row(name, per_second):
    print(f"| {name} | {per_second / 1e6:.2f} | {100 * per_second / (A53_HZ * A53_PER_CYCLE):.2f} |")


if __name__ == "__main__":
    main()
