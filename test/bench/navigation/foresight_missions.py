#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a map of the link buys in Mission C: simulated runs of bringup/foresight.yaml, two rounds each.

usage: foresight_missions.py [ways|rooms|policies|pictures] [SEEDS]

ways:     seconds without link and metres driven, in the first round (learned on the way) and in the
          second (known), for some values of navigator.link_detour; 0 is the shortest way
rooms:    the same for two rounds of Missions A and B in the classroom
policies: what the classes of the vehicle lose, for policies of its transmission_controller
pictures: when all pictures of a survey are on the station that stores those that do not cross
          (bringup/survey.yaml with config/traffic_survey.yaml), for policies, ways and stops

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
MISSIONS = pathlib.Path(__file__).resolve().parents[3] / "config/missions"
REACHED = re.compile(r"(\d+):(\d+):([\d.]+) info \[mission_control\] waypoint (\d+) reached")


class Run:
    """One simulated mission and what the vehicle recorded of it."""

    round_waypoints = 6

    def __init__(self, folder, seed, settings, bringup="foresight.yaml", more=()):
        self.folder = pathlib.Path(folder)
        command = ["tocsin", "sim", bringup, "--seed", str(seed), "--run-dir", str(self.folder / "run"), *more]
        done = subprocess.run(command + [f"--set={one}" for one in settings], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"foresight_missions.py: {' '.join(command)}: {done.stderr[-400:]}")
        self.time_s = float(re.match(r"([\d.]+) s simulated", done.stdout)[1])
        for hours, minutes, seconds, waypoint in REACHED.findall(done.stderr):
            if int(waypoint) == self.round_waypoints:
                self.first_round_s = int(hours) * 3600 + int(minutes) * 60 + float(seconds)

    def mission_s(self):
        """When the mission was over."""
        rows = self.rows("mission_status", "gcs")
        return stamp(next(row for row in rows if row["state"] == "done")) - stamp(rows[0])

    def waiting(self):
        """Pictures that wait on the vehicle, each second from its start."""
        rows = [row for row in self.rows("link_state") if row["role"] == "uxv"]
        begin = stamp(rows[0])
        return [(stamp(row) - begin, sum(one["waiting"] for one in json.loads(row["stored"]))) for row in rows]

    def rows(self, topic, host="uxv"):
        out = self.folder / f"{host}_{topic}"
        if not out.exists():
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


def over_seeds(seeds, measure):
    """The mean of what `measure(folder, seed)` gives for each seed, and the half width of its 95 % interval."""
    measured = []
    for seed in range(1, seeds + 1):
        with tempfile.TemporaryDirectory() as folder:
            measured.append(measure(folder, seed))
    return [(statistics.mean(one), 1.96 * statistics.stdev(one) / math.sqrt(seeds)) for one in zip(*measured)]


def missions(seeds, settings, measure):
    return over_seeds(seeds, lambda folder, seed: measure(Run(folder, seed, settings)))


def print_row(name, values):
    print(f"| {name} | " + " | ".join(f"{mean:.1f} ± {half:.1f}" for mean, half in values) + " |", flush=True)


def ways(seeds):
    print("| link_detour | without link, round 1, s | round 2, s | way, round 1, m | round 2, m | mission, s |")
    print("| --- | --- | --- | --- | --- | --- |")
    for detour in (0, 0.15, 0.3):
        settings = [f"navigator.link_detour={detour}"]
        print_row(detour, missions(seeds, settings, lambda run: [*run.silent_s(), *run.driven_m(), run.time_s]))


def rooms(seeds):
    print("| mission | link_detour | without link, round 1, s | round 2, s | way, round 1, m | round 2, m |")
    print("| --- | --- | --- | --- | --- | --- |")
    for mission, channel in (("mission_a", "classroom"), ("mission_b", "classroom_mission_b")):
        for detour in (0, 0.15):
            def measure(folder, seed, detour=detour, mission=mission, channel=channel):
                run = RoomRun(folder, seed, [f"navigator.link_detour={detour}"], mission, channel)
                return [*run.silent_s(), *run.driven_m()]
            print_row(f"{mission} | {detour}", over_seeds(seeds, measure))


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


class RoomRun(Run):
    """Two rounds of a mission in the classroom, by a modelled localiser."""

    def __init__(self, folder, seed, settings, mission, channel):
        folder = pathlib.Path(folder)
        text = (MISSIONS / f"{mission}.yaml").read_text(encoding="utf-8")
        waypoints = [line for line in text.splitlines() if line.strip().startswith("- {")]
        self.round_waypoints = len(waypoints)
        (folder / "rounds.yaml").write_text("\n".join(["waypoints:", *waypoints, *waypoints, ""]), encoding="utf-8")
        (folder / "parameters.yaml").write_text(
            f"mission_control: {{mission_file: {folder}/rounds.yaml}}\n"
            "navigator: {localisation: localiser}\nlink_mapper: {map_name: '${run_dir}/link'}\n", encoding="utf-8")
        (folder / "room.yaml").write_text(
            "extends: mission.yaml\nparameters: [./parameters.yaml]\n"
            f"radio: {{channel: '${{share}}/config/radio/{channel}.yaml'}}\n"
            "hosts: {uxv: {containers: [{name: drive, components: [modelled_localiser]}, "
            "{name: payload, components: [link_mapper]}]}}\n", encoding="utf-8")
        super().__init__(folder, seed, settings, str(folder / "room.yaml"))


class Survey(Run):
    """Mission C with four stored pictures a second, and so long after it that all can cross."""

    def __init__(self, folder, seed, settings):
        bringup = pathlib.Path(folder) / "pictures.yaml"
        bringup.write_text("extends: survey.yaml\ntraffic: ${share}/config/traffic_survey.yaml\nstop_when_exits: ~\n", encoding="utf-8")
        settings = [*settings, "mission_control.exit_when_over=false", "camera.rate_hz=4"]
        super().__init__(folder, seed, settings, str(bringup), ("--duration", "900"))

    def measures(self):
        """Mission [s], all pictures there [s], mean delay of a picture by Little's law [s], most that wait, critical late or
        lost of what arrived [%]."""
        waiting = self.waiting()
        few = 3  # that are on their way always
        critical, low = (self.classes()[name] for name in ("critical", "low"))
        there = max((at for at, count in waiting if count > few), default=0)
        delay = sum(count for _, count in waiting) / max(1, low["offered"])
        late = 100 * (critical["late"] + critical["lost"]) / max(1, critical["delivered"] + critical["lost"])
        return [self.mission_s(), max(there, self.mission_s()), delay, max(count for _, count in waiting), late]


def pictures(seeds):
    print("| policy | link_detour | send_stop_s | backfill_share | mission, s | all there after, s | mean delay, s | "
          "most that wait | critical late or lost, % |")
    print("| --- " * 9 + "|")
    for policy, detour, stop, share in (("none", 0, 0, 0.2), ("tocp_dsp", 0, 0, 0.2), ("none", 0, 0, 0.6), ("none", 0.15, 0, 0.2),
                                        ("none", 0.15, 0, 0.6), ("none", 0.15, 60, 0.2), ("foresight", 0.15, 0, 0.2)):
        settings = [f"transmission_controller.policy={policy}", f"navigator.link_detour={detour}",
                    f"navigator.send_stop_s={stop}", f"link_router.backfill_share={share}"]
        values = over_seeds(seeds, lambda folder, seed, settings=settings: Survey(folder, seed, settings).measures())
        print_row(f"{policy} | {detour} | {stop} | {share}", values)


def main():
    subjects = {"ways": ways, "rooms": rooms, "policies": policies, "pictures": pictures}
    chosen = sys.argv[1] if len(sys.argv) > 1 else "ways"
    count = sys.argv[2] if len(sys.argv) > 2 else "20"
    if chosen not in subjects or not count.isdigit() or int(count) < 2:
        sys.exit(f"foresight_missions.py: {' '.join(sys.argv[1:])}: is not ways, rooms, policies or pictures, and a number of seeds from 2")
    subjects[chosen](int(count))


if __name__ == "__main__":
    main()
