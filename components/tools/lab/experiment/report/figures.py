# SPDX-License-Identifier: Apache-2.0
"""Diagrams: each is one `<name>.svg`, which the page holds, and one `<name>.png`."""
import io
import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot  # noqa: E402

from inference import percentile  # noqa: E402

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#999999")
matplotlib.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "tocsin", "font.size": 9, "axes.grid": True, "grid.color": "#dddddd",
    "axes.axisbelow": True, "axes.spines.top": False, "axes.spines.right": False, "axes.prop_cycle": matplotlib.cycler(
        color=COLOURS)})


def any_finite(values):
    return any(math.isfinite(value) for value in values)


def error_bars(means):
    """How far each interval reaches below and above its mean; 0 where it is not known."""
    return [[one.mean - one.low if math.isfinite(one.low) else 0 for one in means],
            [one.high - one.mean if math.isfinite(one.low) else 0 for one in means]]


class Figure:
    """A diagram that is drawn at once; `x` and `y` name its axes."""

    def __init__(self, name, title, x, y, from_zero=False):
        self.name = name
        self.figure, self.axes = matplotlib.pyplot.subplots(figsize=(7.6, 4.2))
        self.axes.set(title=title, xlabel=x, ylabel=y)
        self.from_zero = from_zero
        self.labels = []

    def line(self, title, values, step, low=(), high=()):
        """Through (i step, values[i]), with a shaded band; gaps where it is NaN."""
        places = [i * step for i in range(len(values))]
        drawn = self.axes.plot(places, values, label=title) if any_finite(values) else []
        if drawn and any_finite(low) and any_finite(high):
            self.axes.fill_between(places, low, high, color=drawn[0].get_color(), alpha=0.18, linewidth=0)

    def box(self, label, values):
        """Quartiles and median, whiskers from the 5th to the 95th percentile, at the next place."""
        self.labels.append(label)
        known = [value for value in values if math.isfinite(value)]
        if not known:
            return
        shares = {"whislo": 0.05, "q1": 0.25, "med": 0.5, "q3": 0.75, "whishi": 0.95}
        box = {name: percentile(known, share) for name, share in shares.items()}
        place = len(self.labels)
        colour = COLOURS[(place - 1) % len(COLOURS)]
        style = {"color": colour}
        self.axes.bxp([box], [place], showfliers=False, boxprops=style, whiskerprops=style, capprops=style,
                      medianprops={"color": colour, "linewidth": 3})

    def interval(self, label, mean):
        """A mean with its interval at the next place."""
        self.labels.append(label)
        if math.isfinite(mean.mean):
            self.axes.errorbar([len(self.labels)], [mean.mean], error_bars([mean]), fmt="o", capsize=4, color=COLOURS[0])

    def marks(self, title, labels, means, shift):
        """A mean with its interval at each of `labels`, `shift` to the right; NaN means are left out."""
        self.labels = labels
        known = [(i + 1 + shift, one) for i, one in enumerate(means) if math.isfinite(one.mean)]
        if known:
            places, shown = zip(*known)
            self.axes.errorbar(places, [one.mean for one in shown], error_bars(shown), fmt="o", capsize=3, label=title)

    def points(self, x, y):
        """With the line on which both are equal."""
        if x and y:
            self.axes.plot(x, y, "o", markersize=4)
            self.axes.axline((min(x), min(x)), slope=1, color="#999999", linestyle="--", linewidth=1)

    def draw(self, folder):
        """Writes both files and returns the <svg> element."""
        if self.labels:
            self.axes.set_xlim(0.3, len(self.labels) + 0.7)
            self.axes.set_xticks(range(1, len(self.labels) + 1), self.labels, rotation=30 if len(self.labels) > 5 else 0)
        if self.from_zero:
            self.axes.set_ylim(bottom=0)
        if self.axes.get_legend_handles_labels()[1]:
            self.axes.legend(fontsize="small")
        rotated = len(self.labels) > 5
        self.figure.subplots_adjust(left=0.1, right=0.97, top=0.92, bottom=0.25 if rotated else 0.12)
        path = os.path.join(folder, self.name)
        self.figure.savefig(path + ".png", dpi=150, metadata={"Software": None})
        text = io.StringIO()
        self.figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
        matplotlib.pyplot.close(self.figure)
        with open(path + ".svg", "w", encoding="utf-8") as file:
            file.write(text.getvalue())
        return text.getvalue()[text.getvalue().index("<svg"):]
