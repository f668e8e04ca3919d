# SPDX-License-Identifier: Apache-2.0
"""The thesis's evaluation redone: figures 43 to 52 and its tables."""
import math

from figures import Figure
from inference import NAN, number, paired_difference
from results import of_policy
from sections import display_name

POLICIES = ("none", "threshold", "tocp", "tocp_dsp")
# Highest PER and mean QNI that the thesis prints (its chapter of results; maxima without intervals).
PRINTED = {("a", "none"): (25, NAN), ("a", "threshold"): (45, NAN), ("a", "tocp"): (15, NAN), ("a", "tocp_dsp"): (10, NAN),
           ("b", "none"): (30, 68.4), ("b", "threshold"): (20, 70.8), ("b", "tocp"): (20, 65.9),
           ("b", "tocp_dsp"): (10, 76.3)}
DIFFERENCES = (
    "Where the numbers differ, and why. The thesis prints maxima of one series per policy, without intervals; a maximum "
    "over about a hundred observations of 20 probes moves in steps of 5 % and by chance alone, so a single one says "
    "little. The link that the thesis's probes met is not known; ours was chosen so that no policy meets about its PER. "
    "Its source lets every DSP pause last three or four samples, whatever the network does, and its TOCP is a threshold "
    "on one sample; ours are the rules of its text. Probes are never paused: a policy lowers the PER over probes only as "
    "far as silence empties the queue before them, and cannot mend a weak signal.")
SHADED = "mean over {} runs; shaded: 10th to 90th percentile of the runs."


def add_bands(figure, groups, name):
    for group in groups:
        low, high = (group.percentile_series(name, share) for share in (0.1, 0.9))
        figure.line(display_name(group.policy), group.mean_series(name), 1, low, high)


def qni_figure(ours, other, figure_number, page):
    figure = Figure(f"fig{figure_number}_{ours.id}_{other.policy}",
                    f"{ours.name}: QNI with TOCP-DSP and with {display_name(other.policy)}", "observation", "QNI [%]")
    figure.axes.set_ylim(0, 100)
    add_bands(figure, (ours, other), "qni")
    page.figure(figure, f"As figure {figure_number} of the thesis: " + SHADED.format(len(ours.indices)))


def per_figure(groups, figure_number, page):
    figure = Figure(f"fig{figure_number}_{groups[0].id}_per", f"{groups[0].name}: packet error rate of the four policies",
                    "observation", "PER over probes [%]", from_zero=True)
    for group in groups:
        figure.line(display_name(group.policy), group.mean_series("probe_per"), 1)
    page.figure(figure, f"As figure {figure_number} of the thesis: share of 20 ICMP echoes without an answer, mean over "
                "runs at the same observation.")


def latency_figure(ours, none, figure_number, page):
    figure = Figure(f"fig{figure_number}_{ours.id}_latency", f"{ours.name}: latency with TOCP-DSP and without a policy",
                    "observation", "latency of telemetry [ms]")
    figure.axes.set_yscale("log")
    add_bands(figure, (ours, none), "latency_ms")
    page.figure(figure, f"As figure {figure_number} of the thesis: median of the telemetry of an observation, "
                + SHADED.format(len(ours.indices)))
    ours_ms, none_ms = (group.metric("high_latency_median") for group in (ours, none))
    change = 100 * paired_difference(ours_ms, none_ms).mean / none.mean("high_latency_median").mean
    page.paragraph(
        "Latency: the thesis tells 24 % less with TOCP-DSP in Mission A. Here the median latency of class high is "
        f"{number(ours.mean('high_latency_median'))} ms against {number(none.mean('high_latency_median'))} ms without a "
        f"policy: {number(change)} %.")


def table(groups):
    rows = [["policy", "max PER, thesis [%]", "max PER over probes, ours [%]", "peak of the mean curve, ours [%]",
             "max PER of telemetry, ours [%]", "mean QNI, thesis [%]", "mean QNI, ours [%]"]]
    for group in groups:
        per_max, qni_mean = PRINTED.get((group.mission, group.policy), (NAN, NAN))
        peak = max((value for value in group.mean_series("probe_per") if math.isfinite(value)), default=NAN)
        rows.append([display_name(group.policy), number(per_max), number(group.mean("probe_per_max")), number(peak),
                     number(group.mean("telemetry_per_max")), number(qni_mean), number(group.mean("qni_mean"))])
    return rows


def add_round(groups, first, page):
    """Numbers 43 to 47 for the first mission, 48 to 52 for the second."""
    page.heading(3, groups[0].title)
    four = [one for one in (of_policy(groups, policy) for policy in POLICIES) if one]
    ours = of_policy(groups, "tocp_dsp")
    for offset, policy in enumerate(("none", "threshold", "tocp")):
        other = of_policy(groups, policy)
        if ours and other:
            qni_figure(ours, other, first + offset, page)
    if four:
        per_figure(four, first + 3, page)
    none = of_policy(groups, "none")
    if ours and none:
        latency_figure(ours, none, first + 4, page)
    page.table(table(four))


def figures(results, page):
    sets = results.sets("thesis")
    if not sets:
        return
    page.heading(2, "The thesis's figures 43 to 52")
    for one in sets:
        groups = [own for own in results.rounds("thesis") if own[0].set == one["name"]]
        for i, own in enumerate(groups):
            add_round(own, 48 if i % 2 else 43, page)
    page.paragraph(DIFFERENCES)
