#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a map of the link buys in Mission C: simulated runs of bringup/foresight.yaml, two rounds each.

usage: foresight_missions.py [ways|policies] [SEEDS]

ways:     seconds without link and metres driven, in the first round (learned on the way) and in the
          second (known), for some values of navigator.link_detour; 0 is the shortest way
policies: what the classes of the vehicle lose, for policies of its transmission_controller

A second without link is a measurement of which half of the probes or more had no answer. Needs a
sourced installation (tocsin).
"""
import csv
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

csv.field_size_limit(10**9)
ROUND_ENDS = re.compile(r"(\d+):(\d+):([\d.]+) info \[mission_control\] waypoint 6 reached")


class Run:
    """One simulated mission and what the vehicle recorded of it."""

    def __init__(self, folder, seed, settings):
        self.folder = pathlib.Path(folder)
        command = ["tocsin", "sim", "foresight.yaml", "--seed", str(seed), "--run-dir", str(self.folder / "run")]
        done = subprocess.run(command + [f"--set={one}" for one in settings], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"foresight_missions.py: {' '.join(command)}: {done.stderr[-400:]}")
        self.time_s = float(re.match(r"([\d.]+) s simulated", done.stdout)[1])
        hours, minutes, seconds = ROUND_ENDS.search(done.stderr).groups()
        self.first_round_s = int(hours) * 3600 + int(minutes) * 60 + float(seconds)

    def rows(self, topic, host="uxv"):
        out = self.folder / f"{host}_{topic}"
        subprocess.run(["tocsin", "bag", "export", str(self.folder / "run" / host / "bag"), "-o", str(out),
                        "--topics", f"/{topic}"], check=True, capture_output=True)
        with open(out / f"{topic}.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def silent_s(self):
        """In the first round and the second."""
        rounds = [0, 0]
        rows = self.rows("network_quality")
        begin = stamp(rows[0])
        for row in rows:
            if float(row["per_percent"]) >= 50:
                rounds[stamp(row) - begin > self.first_round_s] += 1
        return rounds

    def driven_m(self):
        rounds, last = [0, 0], None
        rows = self.rows("location")
        begin = stamp(rows[0])
        for row in rows:
            at = (float(row["pose.pose.position.x"]), float(row["pose.pose.position.y"]))
            if last and math.dist(at, last) < 0.05:
                continue
            if last:
                rounds[stamp(row) - begin > self.first_round_s] += math.dist(at, last)
            last = at
        return rounds

    def classes(self):
        """Of the vehicle's router, counted to the end."""
        last = [row for row in self.rows("link_state") if row["role"] == "uxv"][-1]
        return {one["traffic_class"]: one for one in json.loads(last["classes"])}

    def paused_s(self):
        return sum(row["role"] == "uxv" and row["active"] in ("0", "false") for row in self.rows("transmission_state"))


def stamp(row):
    return float(row["send_s"])


def missions(seeds, settings, measure):
    """The mean of what is measured of each run, and the half width of its 95 % interval."""
    measured = []
    for seed in range(1, seeds + 1):
        with tempfile.TemporaryDirectory() as folder:
            measured.append(measure(Run(folder, seed, settings)))
    columns = list(zip(*measured))
    return [(statistics.mean(one), 1.96 * statistics.stdev(one) / math.sqrt(seeds)) for one in columns]


def print_row(name, values):
    print(f"| {name} | " + " | ".join(f"{mean:.1f} ± {half:.1f}" for mean, half in values) + " |", flush=True)


def ways(seeds):
    print("| link_detour | without link, round 1, s | round 2, s | way, round 1, m | round 2, m | mission, s |")
    print("| --- | --- | --- | --- | --- | --- |")
    for detour in (0, 0.15, 0.3):
        settings = [f"navigator.link_detour={detour}"]
        print_row(detour, missions(seeds, settings, lambda run: [*run.silent_s(), *run.driven_m(), run.time_s]))


def policies(seeds):
    def measure(run):
        classes = run.classes()
        values = []
        for name in ("critical", "high", "low"):
            one = classes[name]
            values.append(100 * (one["late"] + one["lost"]) / max(1, one["delivered"] + one["lost"]))
        return [*values, 100 * classes["low"]["delivered"] / classes["low"]["offered"],
                sum(one["bytes"] for one in classes.values()) / 1e6, run.paused_s()]

    print("| policy | critical late or lost, % | high, % | low, % | low delivered of written, % | sent, MB | paused, s |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for policy in ("none", "tocp_dsp", "foresight"):
        print_row(policy, missions(seeds, [f"transmission_controller.policy={policy}"], measure))


def main():
    subjects = {"ways": ways, "policies": policies}
    chosen = sys.argv[1] if len(sys.argv) > 1 else "ways"
    count = sys.argv[2] if len(sys.argv) > 2 else "20"
    if chosen not in subjects or not count.isdigit() or int(count) < 2:
        sys.exit(f"foresight_missions.py: {' '.join(sys.argv[1:])}: is not ways or policies, and a number of seeds from 2")
    subjects[chosen](int(count))


if __name__ == "__main__":
    main()
