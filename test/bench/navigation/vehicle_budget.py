#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What each process of a vehicle takes while it drives, and an estimate for a Raspberry Pi 3.

usage: vehicle_budget.py [BRINGUP_FILE] [SECONDS]

1. How many instructions this computer does in a second of CPU: those of simulations of the bringup
   file (obstacles.yaml), counted by valgrind, through the CPU time that they take without it.
2. CPU time and memory of each process of host `uxv` while the bringup file runs in real time, from
   /proc, kernel included. Memory is the share of each page that a process has (PSS).
The estimate is the product of both, through what a core of a Cortex-A53 does at 1.2 GHz with 0.6
instructions a cycle, an assumption. Needs root, valgrind, a sourced installation and a quiet computer.
"""
import argparse
import os
import pathlib
import re
import signal
import statistics
import subprocess
import sys
import tempfile
import time

from instruction_profile import A53_HZ, A53_PER_CYCLE, START_S

TIMES = 5  # each simulation is timed so often
TICK_S = 1 / os.sysconf("SC_CLK_TCK")


def simulate(bringup, seconds, folder, tool=()):
    """CPU seconds of a simulation, and what it said."""
    command = [*tool, "tocsin-sim", bringup, "--seed", "1", "--duration", str(seconds), "--run-dir", tempfile.mkdtemp(dir=folder)]
    before = os.times()
    done = subprocess.run(command, capture_output=True, text=True)
    after = os.times()
    if done.returncode != 0:
        sys.exit(f"vehicle_budget.py: {' '.join(command)}: {done.stderr[-400:]}")
    return after.children_user + after.children_system - before.children_user - before.children_system, done.stderr


def instructions_a_second(bringup, folder):
    """Of a CPU second of a simulation here; start and reading of files are left out."""
    counts, times = [], []
    for seconds in (START_S, START_S + 60):
        _, said = simulate(bringup, seconds, folder, ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"])
        counts.append(int(re.search(r"Collected : (\d+)", said)[1]))
        times.append(statistics.median(simulate(bringup, seconds, folder)[0] for _ in range(TIMES)))
    return (counts[1] - counts[0]) / (times[1] - times[0])


def usage(folder):
    """Container of host uxv: (CPU seconds until now, PSS in bytes)."""
    found = {}
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (process / "cmdline").read_bytes().split(b"\0")
            if len(words) < 4 or words[1] != f"{folder}/deployment.yaml".encode() or words[2] != b"uxv":
                continue
            fields = (process / "stat").read_text().rpartition(")")[2].split()
            shared = re.search(r"^Pss: +(\d+) kB", (process / "smaps_rollup").read_text(), re.M)
            found[words[3].decode()] = ((int(fields[11]) + int(fields[12])) * TICK_S, int(shared[1]) * 1000)
        except (FileNotFoundError, ProcessLookupError):  # it has ended
            continue
    return found


def measured(bringup, seconds, folder):
    """Container: (share of a core, PSS in bytes) over some seconds of the real thing."""
    run = f"{folder}/real"
    launch = subprocess.Popen(["tocsin", "launch", bringup, "--run-dir", run], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        time.sleep(START_S)
        begin, before = time.monotonic(), usage(run)
        time.sleep(seconds)
        elapsed, after = time.monotonic() - begin, usage(run)
    finally:
        launch.send_signal(signal.SIGINT)
        launch.wait()
    if not before or before.keys() != after.keys():
        sys.exit(f"vehicle_budget.py: {bringup}: its processes of uxv did not run for {seconds} s")
    return {name: ((after[name][0] - before[name][0]) / elapsed, after[name][1]) for name in before}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bringup", nargs="?", default="obstacles.yaml")
    parser.add_argument("seconds", nargs="?", type=int, default=40)
    said = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rate = instructions_a_second(said.bringup, folder)
        rows = measured(said.bringup, said.seconds, folder)
    print(f"{rate / 1e9:.2f} thousand million instructions in a second of CPU here\n")
    print("| process of the vehicle | of a core here, % | million instructions a second | of a Cortex-A53 core, % | memory, MB |")
    print("| --- | --- | --- | --- | --- |")
    rows["together"] = tuple(map(sum, zip(*rows.values())))
    for name, (share, memory) in rows.items():
        a53 = share * rate / (A53_HZ * A53_PER_CYCLE)
        print(f"| {name} | {100 * share:.1f} | {share * rate / 1e6:.0f} | {100 * a53:.1f} | {memory / 1e6:.0f} |")


if __name__ == "__main__":
    main()
