#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a map of the link and policy foresight are worth to users: Missions A, B and C, on a radio with one queue and on one
with 802.11e's four.

usage: foresight_experiment.py [SEEDS [FOLDER]]

Each seed has a building of its own (shadowing) and meets every row of the table. Map: none; learned on the way; known, from
an earlier mission in the same building; other, from an earlier mission in another building. Prints the users' cost of
`tocsin experiment`, what of it differs from policy none without a map over pairs of equal seeds, and 95 % intervals. FOLDER
keeps the runs, and the same command goes on there. Needs a sourced installation (tocsin).
"""
import concurrent.futures
import csv
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

CONFIG = pathlib.Path(__file__).resolve().parents[3] / "config"
ROOM = """extends: mission.yaml
parameters: [./room_parameters.yaml]
hosts: {uxv: {containers: [{name: drive, components: [modelled_localiser]}, {name: payload, components: [link_mapper]}]}}
"""
# name, policy, map
ROWS = [("none", "none", "none"), ("tocp_dsp", "tocp_dsp", "none"), ("none_learned", "none", "learned"),
        ("foresight_learned", "foresight", "learned"), ("none_known", "none", "known"),
        ("foresight_known", "foresight", "known"), ("none_other", "none", "other"), ("foresight_other", "foresight", "other")]
RADIOS = {"": "one queue", "_categories": "802.11e"}
METRICS = ("user_cost", "critical_late", "high_late", "low_delivered", "location_age_p99", "completion")


def policy_text(name, policy, kind, maps):
    detour = 0 if kind == "none" else 0.15
    folder = f"{maps}/{name}/${{seed}}" if kind in ("known", "other") else ""
    return (f"  - {{name: {name}, policy: {policy}, set: [navigator.link_detour={detour}, "
            f"\"link_mapper.map_name={folder}\"]}}\n")


def experiment_text(bringup, missions, channel, rows, maps, seeds, duration_s=900):
    """Of one radio; it has the same name for both, so both have the same seeds."""
    text = f"bringup: {bringup}\nwithout: [gcs/view]\nduration_s: {duration_s}\nwarm_up_s: 5\nmissions:\n"
    text += "".join(f"  - {{name: {name}, file: {file}}}\n" for name, file in missions)
    text += f"channels:\n  - {{name: radio, file: \"{channel}\"}}\n"
    text += "payloads:\n  - {name: camera, camera: true}\npolicies:\n"
    text += "".join(policy_text(*row, maps) for row in rows)
    return text + f"sets:\n  - {{name: foresight, title: What a map of the link is worth, seeds: {seeds}}}\n"


def run(folder, name, text):
    """The rows of runs.csv of an experiment."""
    file = folder / f"{name}.yaml"
    file.write_text(text, encoding="utf-8")
    done = subprocess.run(["tocsin", "experiment", "run", str(file), "--out", str(folder / name)], stdout=subprocess.DEVNULL, check=False)
    if done.returncode != 0:
        sys.exit(f"foresight_experiment.py: tocsin experiment run {file} ended with {done.returncode}")
    with open(folder / name / "runs.csv", encoding="utf-8", newline="") as rows:
        return list(csv.DictReader(rows))


def learn(bringup, missions, channel, runs, folder):
    """A mission without policy in the building of each run, which leaves its map of the link in `folder`."""
    keeps_files = folder / "faults.yaml"

    def drive(one):
        mission = next(file for name, file in missions if name == one["mission"])
        command = ["tocsin", "sim", str(bringup), "--seed", one["seed"], "--channel", channel.replace("${mission}", one["mission"]),
                   "--set", f"mission_control.mission_file={mission}", "--set", "navigator.link_detour=0",
                   "--set", f"link_mapper.map_name={folder}/{one['seed']}"]
        command += ["--faults", str(keeps_files)]
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([*command, "--run-dir", f"{scratch}/run"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"foresight_experiment.py: {' '.join(command)}: {done.stderr[-400:]}")

    folder.mkdir(parents=True, exist_ok=True)
    # Files are kept in simulations with faults: here one without effect.
    keeps_files.write_text("faults: [{kind: loss, at_s: 1, for_s: 0.001, amount: 0}]\n", encoding="utf-8")
    missing = [one for one in runs if not (folder / f"{one['seed']}.signal.csv").exists()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(drive, missing))


def copy_maps(learned, maps, runs):
    """Each learned map under its seed, and as that of another building: of the next seed of the mission."""
    for mission in {one["mission"] for one in runs}:
        seeds = sorted({one["seed"] for one in runs if one["mission"] == mission})
        for place, seed in enumerate(seeds):
            for name, _, kind in ROWS:
                if kind not in ("known", "other"):
                    continue
                source = seed if kind == "known" else seeds[(place + 1) % len(seeds)]
                (maps / name).mkdir(parents=True, exist_ok=True)
                shutil.copy(learned / f"{source}.signal.csv", maps / name / f"{seed}.signal.csv")


def interval(values):
    return statistics.mean(values), 1.96 * statistics.stdev(values) / math.sqrt(len(values))


def print_table(runs):
    baseline = {(one["mission"], one["radio"], one["index"]): float(one["user_cost"]) for one in runs if one["policy"] == "none"}
    print("| mission | radio | policy | map | users' cost | more than none | critical late, % | high, % | low delivered, % | "
          "location p99, s | mission, s |")
    print("| --- " * 11 + "|")
    for mission in sorted({one["mission"] for one in runs}):
        for radio in RADIOS:
            for name, policy, kind in ROWS:
                group = [one for one in runs if (one["mission"], one["radio"], one["policy"]) == (mission, radio, name)]
                pairs = [float(one["user_cost"]) - baseline[mission, radio, one["index"]] for one in group]
                means = [statistics.mean(float(one[metric]) for one in group if one[metric]) for metric in METRICS]
                more = "" if name == "none" else "{:+.1f} ± {:.1f}".format(*interval(pairs))
                print(f"| {mission.upper()} | {RADIOS[radio]} | {policy} | {kind} | {means[0]:.1f} | {more} | {means[1]:.2f} | {means[2]:.2f} | "
                      f"{means[3]:.1f} | {means[4]:.2f} | {means[5]:.0f} |", flush=True)


def compare(folder, seeds):
    (folder / "room.yaml").write_text(ROOM, encoding="utf-8")
    (folder / "room_parameters.yaml").write_text("navigator: {localisation: localiser}\n", encoding="utf-8")
    (folder / "hall_categories.yaml").write_text("extends: hall.yaml\nradio_channel: {access_categories: true}\n", encoding="utf-8")
    missions = {name: CONFIG / f"missions/mission_{name}.yaml" for name in ("a", "b", "c")}
    rooms = (folder / "room.yaml", [(name, missions[name]) for name in ("a", "b")], str(CONFIG / "radio/thesis_${mission}"))
    shutil.copy(CONFIG / "radio/hall.yaml", folder / "hall.yaml")
    hall = ("survey.yaml", [("c", missions["c"])], str(folder / "hall"))
    runs = []
    for place, (bringup, files, channel) in (("rooms", rooms), ("hall", hall)):
        maps = folder / f"maps_{place}"
        plan = run(folder, f"seeds_{place}",
                   experiment_text(bringup, files, channel + ".yaml", [("seeds", "none", "none")], maps, seeds, 10))
        learn(bringup, files, channel + ".yaml", plan, maps / "learned")
        copy_maps(maps / "learned", maps, plan)
        for radio in RADIOS:
            text = experiment_text(bringup, files, f"{channel}{radio}.yaml", ROWS, maps, seeds)
            runs += [{**one, "radio": radio} for one in run(folder, f"runs_{place}{radio}", text)]
    print_table(runs)


def main():
    count = sys.argv[1] if len(sys.argv) > 1 else "20"
    if not count.isdigit() or int(count) < 2 or len(sys.argv) > 3:
        sys.exit(f"foresight_experiment.py: {' '.join(sys.argv[1:])}: is not a number of seeds from 2, and a folder")
    if len(sys.argv) > 2:
        folder = pathlib.Path(sys.argv[2]).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        return compare(folder, int(count))
    with tempfile.TemporaryDirectory() as folder:
        return compare(pathlib.Path(folder), int(count))


if __name__ == "__main__":
    main()
