# SPDX-License-Identifier: Apache-2.0
"""Means over runs and what a difference says; NaN is a run without an answer."""
import functools
import math
from typing import NamedTuple

NAN = math.nan


class Estimate(NamedTuple):
    """A mean and where it lies with 95 % confidence (Student's t over runs)."""
    mean: float  # NaN: no run had an answer
    low: float  # NaN with fewer than two runs
    high: float
    runs: int  # that had an answer


def student_within(t, degrees):
    """P(|T| <= t) of Student's t with whole degrees of freedom (Abramowitz and Stegun 26.7.3, 26.7.4)."""
    angle = math.atan(t / math.sqrt(degrees))
    odd = degrees % 2
    term = math.cos(angle) if odd else 1.0
    total = 0.0
    for k in range(2 + odd, degrees + 1, 2):
        total += term
        term *= math.cos(angle) ** 2 * (k - 1) / k
    total *= math.sin(angle)
    return 2 / math.pi * (angle + total) if odd else total


@functools.lru_cache(maxsize=None)
def t_quantile_975(degrees):
    """The 97.5 % quantile of Student's t with `degrees` of freedom, at least 1; by bisection."""
    low, high = 1.9, 13.0
    while high - low > 1e-12:
        middle = (low + high) / 2
        low, high = (middle, high) if student_within(middle, degrees) < 0.95 else (low, middle)
    return high


def estimate(values):
    known = [value for value in values if math.isfinite(value)]
    n = len(known)
    if n == 0:
        return Estimate(NAN, NAN, NAN, 0)
    mean = sum(known) / n
    if n == 1:
        return Estimate(mean, NAN, NAN, 1)
    half = t_quantile_975(n - 1) * math.sqrt(sum((value - mean) ** 2 for value in known) / (n - 1) / n)
    return Estimate(mean, mean - half, mean + half, n)


def paired_difference(a, b):
    """Mean of a[i] - b[i] over the runs in which both have an answer."""
    return estimate([x - y for x, y in zip(a, b, strict=True)])


def estimate_over_groups(values, groups):
    """The mean over groups of the groups' means, with the interval over groups.

    Where runs of a group have something random in common (the fit of their parameters), it holds the chance of that,
    too. `groups` has a number for each value; `runs` counts groups.
    """
    members = {}
    for value, group in zip(values, groups, strict=True):
        members.setdefault(group, []).append(value)
    return estimate([estimate(members[group]).mean for group in sorted(members)])


def percentile(values, share):
    """Nearest rank; `share` in (0, 1]. NaN of nothing."""
    if not values:
        return NAN
    return sorted(values)[max(0, math.ceil(share * len(values)) - 1)]


def judge(difference, less_is_better):
    """Of ours minus another: "yes" is better and "no" worse with 95 % confidence, else "open"."""
    if difference.high < 0:
        return "yes" if less_is_better else "no"
    if difference.low > 0:
        return "no" if less_is_better else "yes"
    return "open"


def number(value):
    """To three digits; "-" for what is none. An Estimate with its interval."""
    if isinstance(value, Estimate):
        if not math.isfinite(value.low):
            return number(value.mean)
        return f"{number(value.mean)} [{number(value.low)}, {number(value.high)}]"
    if not math.isfinite(value):
        return "-"
    size = abs(value)
    decimals = 0 if size >= 100 or value == 0 else 1 if size >= 10 else 2 if size >= 1 else 3
    return f"{value:.{decimals}f}"
