# SPDX-License-Identifier: Apache-2.0
"""Everything in the folder of an experiment, as `tocsin experiment run` wrote it."""
import csv
import itertools
import math
import os

import yaml

from inference import NAN, estimate, percentile
from metrics import METRICS

ROUND = ("set", "mission", "channel", "payload")  # runs that differ only in policy and seed
SERIES = "time_s,qni,probe_per,snr_db,active,poor,sent,lost,latency_ms,stalled"


class ResultsError(Exception):
    """The folder holds no results, or other ones than this program knows."""


def numbers(line):
    return [float(cell) if cell else NAN for cell in line.split(",")]


class Group:
    """The runs of one combination, paired with those of other policies by their order."""

    def __init__(self, row):
        self.place = tuple(row[key] for key in ROUND)
        self.set, self.mission, self.channel, self.payload = self.place
        self.policy = row["policy"]
        self.indices = []  # numbers of the seeds, ascending
        self.values = []  # of each run by metric; empty: failed
        self.series = []  # of each run: its observations by name

    def metric(self, name):
        """The metric in every run; NaN where it has no answer."""
        return [run.get(name, NAN) for run in self.values]

    def mean(self, name):
        return estimate(self.metric(name))

    def over_observations(self, name, summary):
        """`summary` over the runs at each observation that at least half of them reached."""
        result = []
        for i in itertools.count():
            reached = [run[i] for run in self.series if i < len(run)]
            if not reached or 2 * len(reached) < len(self.series):
                return result
            result.append(summary([one[name] for one in reached if math.isfinite(one[name])]))

    def mean_series(self, name):
        return self.over_observations(name, lambda values: estimate(values).mean)

    def percentile_series(self, name, share):
        return self.over_observations(name, lambda values: percentile(values, share))

    @property
    def name(self):
        """"Mission A" for a."""
        return "Mission " + (self.mission.upper() if len(self.mission) == 1 else self.mission)

    @property
    def title(self):
        return f"{self.name}, channel {self.channel}, payload {self.payload}"

    @property
    def id(self):
        return "_".join(self.place)


def read_run(path):
    """Why the run failed, its metrics and its observations; "damaged file" for half a file."""
    try:
        with open(path, encoding="utf-8") as file:
            lines = file.read().split("\n")
        if lines[3] != SERIES or lines[-2] != "end":
            return "damaged file", {}, []
        failure = lines[0].removeprefix("failure ")
        values = dict(zip(METRICS, numbers(lines[2].removeprefix("values "))))
        names = SERIES.split(",")
        series = [dict(zip(names, numbers(line), strict=True)) for line in lines[4:-2]]
        return failure, values, series
    except (OSError, ValueError, IndexError):
        return "damaged file", {}, []


class Results:
    """Groups in the order of the plan: simulated and real ones."""

    def __init__(self, folder):
        self.folder = folder
        paths = {name: os.path.join(folder, name) for name in ("settings.yaml", "runs.csv", "real.csv")}
        have = {name: os.path.exists(path) for name, path in paths.items()}
        if not have["settings.yaml"] or not (have["runs.csv"] or have["real.csv"]):
            raise ResultsError(f"{folder}: holds no results of tocsin experiment run (settings.yaml, runs.csv or real.csv)")
        with open(paths["settings.yaml"], encoding="utf-8") as file:
            self.settings = file.read()
        settings = yaml.safe_load(self.settings)
        self.build = ", earlier runs ".join([str(settings["build"]), *(settings.get("earlier_builds") or [])])
        self.experiment = yaml.safe_load(settings["experiment"])
        self.failures = []  # "run: why"
        self.groups = self.read_table("runs.csv", "series")
        self.runs = sum(len(group.indices) for group in self.groups)
        self.real = self.read_table("real.csv", "real")
        self.fitted = self.fitted_of(settings)

    def read_table(self, table, kind):
        """The groups of one table; rows of a group follow each other."""
        path = os.path.join(self.folder, table)
        if not os.path.exists(path):
            return []
        groups = []
        with open(path, encoding="utf-8", newline="") as file:
            rows = csv.DictReader(file)
            unknown = [name for name in rows.fieldnames[10:] if name not in METRICS]
            if unknown:
                raise ResultsError(f"{path}: column {unknown[0]} is no metric that this report knows")
            for row in rows:
                group = Group(row)
                if not groups or (groups[-1].place, groups[-1].policy) != (group.place, group.policy):
                    groups.append(group)
                run = ".".join([*group.place, group.policy, row["index"]])
                failure, values, series = read_run(os.path.join(self.folder, kind, run + ".csv"))
                if failure:
                    self.failures.append(f"{run}: {failure}")
                groups[-1].indices.append(int(row["index"]))
                groups[-1].values.append({} if failure else values)
                groups[-1].series.append([] if failure else series)
        return groups

    def fitted_of(self, settings):
        """The fitted parameters among the files of settings.yaml, which are named by their whole paths."""
        end = os.path.basename(self.experiment.get("fitted") or "")
        for path, text in (settings.get("files") or {}).items():
            if end and os.path.basename(path) == end:
                return yaml.safe_load(text)
        return {}

    def sets(self, *kinds):
        """Sets of these kinds, kind by kind."""
        every = self.experiment["sets"]
        return [one for kind in kinds for one in every if one.get("kind", "comparison") == kind]

    def rounds(self, *kinds):
        """Of the sets of these kinds: groups of the same set, mission, channel and payload."""
        for one in self.sets(*kinds):
            own = [group for group in self.groups if group.set == one["name"]]
            for _, groups in itertools.groupby(own, key=lambda group: group.place):
                yield list(groups)


def of_policy(groups, policy):
    """The group of that policy; None when there is none."""
    return next((group for group in groups if group.policy == policy), None)
