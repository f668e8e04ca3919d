# SPDX-License-Identifier: Apache-2.0
"""The parts of the report besides the thesis's figures. Each adds nothing when its data are not there."""
import math

from markupsafe import Markup

from figures import Figure
from inference import NAN, estimate, estimate_over_groups, judge, number, paired_difference
from metrics import METRICS, label, less_is_better
from results import of_policy

NAMES = {"none": "no policy", "tocp": "TOCP", "tocp_dsp": "TOCP-DSP"}
COMPARED = ("thesis", "comparison")
WEIGHTS = {"critical_late": 10, "critical_very_late": 20, "high_late": 4, "high_very_late": 8, "low_undelivered": 1,
           "location_age": 20, "picture_latency": 5, "airtime": 0.1}  # CostWeights of plan/experiment_file.hpp
WANTED_PAIRS = 20


def display_name(policy):
    return NAMES.get(policy, policy)


def coloured(difference, metric, undecided="open"):
    """A difference in the colour of what it says."""
    kind = judge(difference, less_is_better(metric))
    return Markup('<span class="{}">{}</span>').format(undecided if kind == "open" else kind, number(difference))


def minus(ours, other, metric):
    return paired_difference(ours.metric(metric), other.metric(metric))


def best_of(groups, metric):
    """The group with the best mean; None when none has an answer."""
    means = [(group.mean(metric).mean, group) for group in groups]
    known = [one for one in means if math.isfinite(one[0])]
    if not known:
        return None
    return (min if less_is_better(metric) else max)(known, key=lambda one: one[0])[1]


def overview(results, page):
    of = {"duration_s": 600, "warm_up_s": 10, "observation_s": 6, **results.experiment}
    page.heading(1, "Who may speak while the link is poor: policies compared")
    page.paragraph(Markup(
        "{} runs in simulated time, each of at most {} s, of which the first {} s do not count; one observation is {} s. "
        "The components are those that drive the vehicle. Run <i>i</i> of a mission on a channel meets the same radio "
        "under every policy and payload, so that differences are paired. Intervals in brackets are 95 % confidence "
        "intervals of the mean over runs (Student's t). Build {}.").format(
            results.runs, number(of["duration_s"]), number(of["warm_up_s"]), number(of["observation_s"]), results.build))
    if results.failures:
        page.paragraph(Markup('<span class="no">{} runs failed</span> and are in no figure:').format(len(results.failures)))
        page.list(results.failures[:20])


def verdict_line(ours, other, groups, metric):
    """Whether ours beats the other, by how much, and who is best where it does not."""
    difference = minus(ours, other, metric)
    kind = judge(difference, less_is_better(metric))
    word = {"yes": "beats", "no": "loses to", "open": "does not beat"}[kind]
    line = Markup('{}: {} <span class="{}">{}</span> {} on {}: {} against {} {}, difference {} over {} pairs').format(
        ours.name, display_name(ours.policy), kind, word, display_name(other.policy), metric, number(ours.mean(metric).mean),
        number(other.mean(metric).mean), METRICS[metric][0], number(difference), difference.runs)
    best = best_of(groups, metric)
    if kind != "yes" and best:
        line += "; the {} mean has {} with {}".format("lowest" if less_is_better(metric) else "highest",
                                                      display_name(best.policy), number(best.mean(metric).mean))
    return line + "."


def verdicts(results, page):
    """Whether TOCP-DSP beats the thesis's other policies, from the confidence intervals."""
    if not results.sets("thesis"):
        return
    page.heading(2, "Does TOCP-DSP beat the others?")
    page.paragraph(Markup("A line says <i>beats</i> or <i>loses to</i> only where the 95 % interval of the paired "
                          "difference leaves out zero."))
    for groups in results.rounds("thesis"):
        ours = of_policy(groups, "tocp_dsp")
        if not ours:
            continue
        page.heading(3, ours.title)
        page.list([verdict_line(ours, other, groups, metric)
                   for metric in ("user_cost", "critical_late", "high_late", "low_delivered", "telemetry_per_max",
                                  "high_latency_p99", "probe_per_max") if best_of(groups, metric)
                   for other in groups if other is not ours])


def cost_over_fits(group, other, fits):
    """The cost, minus another's if there is one, with its interval over fits: runs take the fits in turn."""
    values = group.metric("user_cost")
    if other:
        values = [a - b for a, b in zip(values, other.metric("user_cost"), strict=True)]
    return estimate_over_groups(values, [(index - 1) % fits for index in group.indices])


def recommended(rounds, fits):
    """Which policy costs least in all rounds, and in how many of them surely."""
    winners, told, clear = set(), [], 0
    for groups in rounds:
        best = best_of(groups, "user_cost")
        sure = all(group is best or cost_over_fits(group, best, fits).low > 0 for group in groups)
        winners.add(best.policy)
        clear += sure
        told.append(f"{best.set}, {best.title}: {display_name(best.policy)}"
                    + ("" if sure else ", not told apart from all others"))
    if len(winners) > 1:
        return f"No policy is the best everywhere over {fits} fits ({'; '.join(told)})."
    return (f"Use {display_name(winners.pop())}: over {fits} fits it costs users least in all {len(rounds)} rounds, and "
            f"less than every other policy with 95 % confidence in {clear} of them.")


def recommendation(results, page):
    """Which policy to use, with the chance of the fit in the interval; only of several fits."""
    fits = results.experiment.get("fits", 1)
    rounds = [groups for groups in results.rounds(*COMPARED) if len(groups) > 1 and best_of(groups, "user_cost")]
    if fits < 2 or not rounds:
        return
    page.heading(2, "Which policy to use")
    page.paragraph(Markup("<strong>{}</strong>").format(recommended(rounds, fits)))
    page.paragraph(f"Every policy's parameters were fitted {fits} times, each time to other runs, and each evaluated run "
                   "took one of the fits in turn. The interval is over fits, so that it holds their chance and that of "
                   "the runs.")
    for groups in rounds:
        best = best_of(groups, "user_cost")
        page.heading(3, f"{groups[0].set}: {groups[0].title}")
        rows = [["policy", "cost over fits", *(f"fit {fit + 1}" for fit in range(fits)), f"minus {display_name(best.policy)}"]]
        for group in groups:
            costs = list(zip(group.metric("user_cost"), group.indices))
            own = [estimate([cost for cost, index in costs if (index - 1) % fits == fit]).mean for fit in range(fits)]
            rows.append([display_name(group.policy), number(cost_over_fits(group, None, fits)), *map(number, own),
                         "" if group is best else number(cost_over_fits(group, best, fits))])
        page.table(rows)


PARTS_OF_COST = ("critical_late", "critical_very_late", "high_late", "high_very_late", "low_delivered", "location_age_p99",
                 "picture_latency_p99", "airtime")
CONTESTED = ("user_cost", "critical_late", "high_late", "critical_lost", "low_delivered", "location_age_p99",
             "telemetry_per_max", "high_latency_p99", "probe_per_max")


def cost_table(groups, ours):
    rows = [["policy", "cost", "TOCP-DSP minus this", *map(label, PARTS_OF_COST)]]
    for group in sorted(groups, key=lambda group: group.mean("user_cost").mean):
        rows.append([display_name(group.policy), number(group.mean("user_cost")),
                     "" if group is ours else coloured(minus(ours, group, "user_cost"), "user_cost"),
                     *(number(group.mean(metric)) for metric in PARTS_OF_COST)])
    return rows


def best_table(contests):
    rows = [["set and round", "metric", "best mean", "its policy", "TOCP-DSP", "TOCP-DSP minus best"]]
    for groups, ours in contests:
        for metric in CONTESTED:
            best = best_of(groups, metric)
            if best:
                rows.append([f"{ours.set}: {ours.title}", label(metric), number(best.mean(metric)),
                             display_name(best.policy), number(ours.mean(metric)),
                             "it is the best" if best is ours else coloured(minus(ours, best, metric), metric)])
    return rows


def costs(results, page):
    """All policies by the one cost of what users feel, and which is best at what."""
    contests = [(groups, of_policy(groups, "tocp_dsp")) for groups in results.rounds(*COMPARED)
                if len(groups) > 1 and of_policy(groups, "tocp_dsp")]
    if not contests:
        return
    weights = {**WEIGHTS, **results.experiment.get("cost", {})}
    page.heading(2, "Judged by one cost")
    page.paragraph(
        "What users feel, in one number: the share of class critical and high that comes late (250 ms, and once more 1 s) "
        "or never, what of class low is not delivered, the age of the location, the delay of pictures, and the airtime "
        "that others cannot have. The weights of this experiment, in units of one percent of class low: "
        + ", ".join(f"{name} {number(weight)}" for name, weight in weights.items())
        + ". Silence is no gain by itself: what it keeps from class low costs, and what it spares the others shows in "
        "their lateness.")
    for groups, ours in contests:
        page.heading(3, f"{ours.set}: {ours.title}")
        figure = Figure(f"cost_{ours.id}", f"{ours.name}: cost of what users feel", "", "cost [% of class low]", True)
        for group in groups:
            figure.interval(display_name(group.policy), group.mean("user_cost"))
        page.figure(figure, "Mean over runs with its 95 % interval; lower is better.")
        page.table(cost_table(groups, ours))
    page.heading(3, "Which policy is best at what")
    page.paragraph("The best mean of each round, and TOCP-DSP beside it; red where TOCP-DSP is worse with 95 % confidence. "
                   "The best of several is picked from the same runs, so that it looks a little better than it is.")
    page.table(best_table(contests))


def fit(results, page):
    """By which rule the policies got their parameters."""
    page.heading(2, "How the policies got their parameters")
    if not results.fitted:
        page.paragraph("No file of fitted parameters: each policy has its defaults or what the experiment file sets.")
        return
    page.paragraph(Markup(
        "By one rule for all, with <code>tocsin experiment fit</code>, on runs without a policy whose seeds are not among "
        "those compared here. The laws of QNI on a good and on a poor link are normals by maximum likelihood, the mean "
        "lengths of both states are counted; all policies that use laws share them. Then each policy's own two numbers "
        "(threshold: both levels; TOCP: alpha and length of the pause; TOCP-DSP: alpha and discount; tocp_reverse: both "
        "alphas) are those of a grid of 100 (threshold: 399) pairs that have the least cost per slot, when the recorded "
        "samples are decided again. Silence does not change a recorded sample, as it changes a real link a little. The "
        "parameters minimise this cost, not the latency and PER that the thesis is judged by."))
    page.table([["mission", "policy", "parameters"],
                *([mission, policy, " ".join(settings)] for mission, policies in sorted(results.fitted.items())
                  for policy, settings in sorted(policies.items()))])


def helps(ours, none):
    """One word from what the table of regimes shows."""
    kinds = {judge(minus(ours, none, metric), True) for metric in ("telemetry_per_max", "high_lost", "high_latency_p99")}
    if "yes" in kinds:
        return "helps and harms" if "no" in kinds else "helps"
    return "harms" if "no" in kinds else "no difference shown"


def regimes(results, page):
    """In which regime TOCP-DSP helps: payload by payload and channel by channel."""
    rows = [["set and round", "TOCP-DSP", "max PER of telemetry [%]", "lost, class high [%]", "p99 latency, high [ms]",
             "delivered, class low [%]", "location age p95 [s]"]]
    for groups in results.rounds(*COMPARED):
        ours, none = (of_policy(groups, policy) for policy in ("tocp_dsp", "none"))
        if ours and none:
            rows.append([f"{ours.set}: {ours.title}", helps(ours, none),
                         *(coloured(minus(ours, none, metric), metric)
                           for metric in ("telemetry_per_max", "high_lost", "high_latency_p99", "low_delivered",
                                          "location_age_p95"))])
    if len(rows) == 1:
        return
    page.heading(2, "Where a policy helps, and where it does not")
    page.paragraph(
        "TOCP-DSP minus no policy, paired. Pausing a few kbit/s of telemetry does not make a link lose less: without the "
        "camera nothing is relieved, and what is paused is simply late. With the camera on a channel that is busy already, "
        "the queue before a poor link is full of pictures, and their silence gives the other classes room: they come "
        "sooner. Where the signal is weak but the channel not full, silence can even raise the loss of what is still sent; "
        "probably because the rate control then has only a few small packets to learn from.")
    page.paragraph("Latency and age alone favour whoever says least: a policy that is silent half of the time has the "
                   "emptiest queue. Read them together with the share of class low that was delivered.")
    page.table(rows)


def channels(results, page):
    """What the radio was: SNR along the path, share of poor time."""
    page.heading(2, "The channels")
    shown = set()
    step_s = results.experiment.get("observation_s", 6)
    for group in results.groups:
        if (group.mission, group.channel) in shown:
            continue
        shown.add((group.mission, group.channel))
        figure = Figure(f"snr_{group.id}", f"{group.name}, channel {group.channel}: mean SNR on the way", "time [s]",
                        "mean SNR [dB]")
        mean = group.mean_series("snr_db")
        figure.line("mean over runs", mean, step_s, group.percentile_series("snr_db", 0.1),
                    group.percentile_series("snr_db", 0.9))
        figure.line("poor below", [results.experiment.get("poor_below_snr_db", 10)] * len(mean), step_s)
        page.figure(figure, "Mean over fading at the vehicle's place; shaded: 10th to 90th percentile of the runs, whose "
                    f"shadowing differs. Truly poor in {number(group.mean('poor_share'))} % of the time, in "
                    f"{number(group.mean('poor_intervals'))} intervals a run.")
        page.paragraph(
            f"{group.name}, channel {group.channel}, payload {group.payload}, {display_name(group.policy)}: highest PER "
            f"over probes {number(group.mean('probe_per_max'))} %, highest PER of telemetry "
            f"{number(group.mean('telemetry_per_max'))} %, our own airtime {number(group.mean('airtime'))} %. Shadowing, "
            "background load and all else: see the channel files under Settings.")


BOARDS = (
    ("lateness", "too late or never", "late or lost [%]",
     {"critical, 250 ms": "critical_late", "critical, 1 s": "critical_very_late", "critical, never": "critical_lost",
      "high, 250 ms": "high_late", "high, 1 s": "high_very_late", "high, never": "high_lost"},
     "Share of samples put on the link that came later than that or never, mean over runs with its 95 % interval."),
    ("ages", "age of information at the ground station", "mean age [s]",
     {"location": "location_age_mean", "network quality": "quality_age_mean", "heartbeat": "heartbeat_age_mean",
      "transmission state": "state_age_mean", "battery (low)": "battery_age_mean", "CPU load (low)": "cpu_age_mean",
      "camera (low)": "camera_age_mean"},
     "Age of the newest received sample of each topic, mean over time and runs with its 95 % interval. Network quality "
     "is measured every six seconds."),
    ("losses", "lost of what was sent, by class", "lost [%]",
     {"critical": "critical_lost", "high": "high_lost", "low, no camera": "low_lost", "camera": "camera_lost",
      "goals": "goals_lost"},
     "Share of samples put on the link that never arrived, mean over runs with its 95 % interval; what the gate held back "
     "was not sent."))
BOXED = ("user_cost", "critical_late", "high_late", "location_age_p99", "telemetry_per_max", "probe_per_max",
         "high_latency_p99", "location_age_p95", "silence_mean", "silence_max", "detect", "resume", "completion")


def distributions(results, page):
    """Distributions over the runs of the thesis's policies."""
    if results.sets("thesis"):
        page.heading(2, "Distributions over runs")
    for groups in results.rounds("thesis"):
        first = groups[0]
        page.heading(3, first.title)
        for name, title, axis, metrics, caption in BOARDS:
            figure = Figure(f"{name}_{first.id}", f"{first.name}: {title}", "", axis, True)
            for i, group in enumerate(groups):
                figure.marks(display_name(group.policy), list(metrics), [group.mean(one) for one in metrics.values()],
                             0.6 / len(groups) * i - 0.3)
            page.figure(figure, caption)
        for metric in BOXED:
            figure = Figure(f"box_{first.id}_{metric}", f"{first.name}: {metric} over runs", "", label(metric), True)
            for group in groups:
                figure.box(display_name(group.policy), group.metric(metric))
            page.figure(figure, f"Box: quartiles and median over {len(first.indices)} runs; whiskers: 5th to 95th "
                        f"percentile. {METRICS[metric][2]}.")


# What the table of a comparison shows; runs.csv has them all.
SHOWN = (
    "user_cost", "critical_late", "critical_very_late", "high_late", "high_very_late", "qni_mean", "probe_per_mean",
    "probe_per_max", "telemetry_per", "telemetry_per_max", "critical_lost", "high_lost", "goals_lost", "low_lost",
    "camera_lost", "high_delivered", "low_delivered", "critical_latency_median", "critical_latency_p99",
    "high_latency_median", "high_latency_p99", "low_latency_p99", "picture_latency_p99", "goal_latency_p99",
    "location_age_mean", "location_age_p95", "location_age_p99", "battery_age_mean", "battery_age_p95", "camera_age_mean",
    "heartbeat_age_mean", "state_age_mean", "cpu_age_mean", "link_bytes", "airtime", "detect", "missed", "resume",
    "sent_in_poor", "silent_in_good", "pauses", "silence_mean", "silence_max", "completion")


def comparisons(results, page):
    """All metrics of every policy of every set of kind thesis and comparison."""
    for one in results.sets(*COMPARED):
        page.heading(2, one.get("title") or one["name"])
        for groups in results.rounds(*COMPARED):
            if groups[0].set != one["name"]:
                continue
            page.heading(3, f"{groups[0].title}: {len(groups[0].indices)} runs each")
            means = [[label(metric), *(group.mean(metric) for group in groups)] for metric in SHOWN]
            page.table([["mean over runs", *(display_name(group.policy) for group in groups)],
                        *([row[0], *map(number, row[1:])] for row in means if any(mean.runs for mean in row[1:]))])
            ours = of_policy(groups, "tocp_dsp")
            others = [group for group in groups if group is not ours]
            if ours and others:
                page.details("paired differences (green: better, red: worse, with 95 % confidence)",
                             [["TOCP-DSP minus ...", *(display_name(group.policy) for group in others)],
                              *([label(metric), *(coloured(minus(ours, group, metric), metric, "") for group in others)]
                                for metric in SHOWN)])


SWEPT = ("telemetry_per_max", "high_lost", "high_latency_p99", "low_delivered", "detect", "missed", "resume",
         "sent_in_poor", "silent_in_good", "silence_max")


def sensitivity(results, page):
    settings = {one["name"]: " ".join(one.get("set") or []) for one in results.experiment["policies"]}
    for one in results.sets("sensitivity"):
        page.heading(2, one.get("title") or one["name"])
        for groups in results.rounds("sensitivity"):
            first = groups[0]
            if first.set != one["name"]:
                continue
            page.heading(3, f"{first.title}: {len(first.indices)} runs each")
            for metric in ("high_latency_p99", "silent_in_good", "sent_in_poor"):
                figure = Figure(f"sensitivity_{first.id}_{metric}", f"{first.name}: {metric} of the variants", "",
                                label(metric), True)
                for group in groups:
                    figure.interval(group.policy, group.mean(metric))
                page.figure(figure, "Mean with its 95 % interval.")
            page.table([["variant", *map(label, SWEPT), "set"],
                        *([group.policy, *(number(group.mean(metric)) for metric in SWEPT), settings[group.policy]]
                          for group in groups)])


AGREED = ("qni_mean", "probe_per_mean", "telemetry_per", "critical_lost", "high_lost", "low_lost", "camera_lost",
          "high_delivered", "low_delivered", "silent_in_good", "high_latency_median", "high_latency_p99", "link_bytes",
          "airtime", "completion", "stalled")


class Pair:
    """A simulated and a real run of the same seed."""

    def __init__(self, name, simulated, real):
        self.name = name
        self.simulated = simulated
        self.real = real
        self.finished = simulated["completed"] == real["completed"] == 1


def pairs_in(results):
    """All that there are; a run that failed is in none."""
    pairs = []
    for real in results.real:
        for group in results.groups:
            if (group.place, group.policy) != (real.place, real.policy):
                continue
            simulated = dict(zip(group.indices, group.values))
            pairs += [Pair(f"{real.policy} {index}", simulated[index], values)
                      for index, values in zip(real.indices, real.values) if values and simulated.get(index)]
    return pairs


def values_of(pairs, metric):
    """The metric of the simulated and of the real runs, of pairs in which both have an answer."""
    both = [(one.simulated[metric], one.real[metric]) for one in pairs]
    known = [(a, b) for a, b in both if math.isfinite(a) and math.isfinite(b)]
    return [a for a, _ in known], [b for _, b in known]


def target(pairs, metric, what):
    simulated, real = values_of(pairs, metric)
    difference = paired_difference(real, simulated)
    close = abs(difference.mean) <= 2
    enough = difference.runs >= WANTED_PAIRS
    kind, word = ("no", "not met") if not close else ("yes", "met") if enough else ("open", "so far, over too few pairs")
    return Markup('<span class="{}">{}</span>: {} within 2.00 over at least {} paired runs; real minus simulated {} over {} '
                  'pairs.').format(kind, word, what, WANTED_PAIRS, number(difference), difference.runs)


def reality_table(halves):
    columns = ("simulated, {}", "real, {}", "real minus simulated", "pairs")
    rows = [["metric", *(column.format(half) for half in halves for column in columns)]]
    for metric in AGREED:
        row = [label(metric)]
        for pairs in halves.values():
            simulated, real = values_of(pairs, metric)
            difference = paired_difference(real, simulated)
            row += [number(estimate(simulated)), number(estimate(real)), number(difference), str(difference.runs)]
        rows.append(row)
    return rows


def reality(results, page):
    """Simulated and real runs of the same seeds."""
    if not results.real:
        return
    pairs = pairs_in(results)
    page.heading(2, "Simulated against real")
    page.paragraph("The same seeds through the whole real stack: processes, Fast DDS, IP packets through the link emulator, "
                   "real time. Observations in which the emulator was more than 50 ms late, because the machine froze, are "
                   "marked (stalled).")
    if not pairs:
        page.paragraph("There are no simulated runs of these seeds yet: tocsin experiment run FILE without --real, into the "
                       "same folder, makes them.")
        return
    halves = {"all": pairs, "both finished": [one for one in pairs if one.finished]}
    page.table(reality_table(halves))
    left_out = ", ".join(one.name for one in pairs if not one.finished) or "none"
    page.paragraph(
        "The rule was set before these runs: a pair is left out of the right half when one of its two vehicles did not "
        "reach its last waypoint within the run (metric completed), because a vehicle that stands where the radio is dead "
        f"measures that place for minutes. Both halves are shown. Of {len(pairs)} pairs left out: {left_out}.")
    page.list([target(half, metric, f"{what}, {name}{' pairs' if name == 'all' else ''},") for name, half in halves.items()
               for metric, what in (("qni_mean", "mean QNI"), ("high_delivered", "delivered share of class high"))])
    for metric in ("qni_mean", "high_delivered"):
        unit = METRICS[metric][0]
        figure = Figure(f"real_{metric}", f"Simulated and real, run by run: {metric}", f"simulated [{unit}]", f"real [{unit}]")
        figure.points(*values_of(pairs, metric))
        page.figure(figure, METRICS[metric][2] + ".")


def definitions(_, page):
    page.heading(2, "What is measured")
    page.table([["metric", "unit", "definition"], *([name, unit, text] for name, (unit, _, text) in METRICS.items())])
    page.paragraph(
        "PER over probes and PER over telemetry are different things: probes are 92-byte packets both ways, never repaired "
        "and never paused; telemetry goes one way, partly repaired, partly paused. What never arrived is found as gaps in "
        "each writer's numbers; a gap's samples are placed evenly between their neighbours, and losses after the last "
        "arrival of a writer are not seen. Latency is that of samples that arrived.")


def settings(results, page):
    page.heading(2, "Settings")
    page.details("settings.yaml: build, experiment file, channels, missions, seeds", text=results.settings)
