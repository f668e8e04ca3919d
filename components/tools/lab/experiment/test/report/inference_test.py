# SPDX-License-Identifier: Apache-2.0
"""Of report/inference.py: means, intervals, verdicts and numbers."""
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "report"))

from inference import (NAN, Estimate, estimate, estimate_over_groups, judge, number, paired_difference,  # noqa: E402
                       percentile, t_quantile_975)


class Inference(unittest.TestCase):
    def test_quantiles_of_student_are_those_of_the_tables(self):
        for degrees, quantile in ((1, 12.7062), (2, 4.30265), (3, 3.18245), (10, 2.22814), (29, 2.04523), (99, 1.98422)):
            self.assertAlmostEqual(t_quantile_975(degrees), quantile, 4)

    def test_a_mean_has_its_interval(self):
        sut = estimate([1, 2, NAN, 3, 4])
        half = t_quantile_975(3) * math.sqrt(5 / 3 / 4)
        self.assertEqual((sut.mean, sut.runs), (2.5, 4))
        self.assertAlmostEqual(sut.low, 2.5 - half)
        self.assertAlmostEqual(sut.high, 2.5 + half)

    def test_of_one_run_there_is_no_interval_and_of_none_no_mean(self):
        self.assertTrue(math.isnan(estimate([5]).low))
        self.assertTrue(math.isnan(estimate([NAN]).mean))
        self.assertEqual(estimate([]).runs, 0)

    def test_pairs_leave_out_runs_without_an_answer(self):
        self.assertEqual(paired_difference([3, NAN, 5, 7], [1, 1, NAN, 5])[0::3], (2, 2))
        with self.assertRaises(ValueError):
            paired_difference([1], [1, 2])

    def test_over_groups_the_interval_is_that_of_their_means(self):
        self.assertEqual(estimate_over_groups([1, 3, 10, NAN, NAN], [1, 1, 2, 2, 3]), estimate([2, 10]))

    def test_percentiles_are_nearest_ranks(self):
        self.assertEqual([percentile([4, 1, 3, 2], share) for share in (0.05, 0.25, 0.5, 0.75, 1)], [1, 1, 2, 3, 4])
        self.assertTrue(math.isnan(percentile([], 0.5)))

    def test_a_verdict_needs_an_interval_without_zero(self):
        below = Estimate(-2, -3, -1, 5)
        above = Estimate(2, 1, 3, 5)
        cases = ((below, True, "yes"), (below, False, "no"), (above, True, "no"), (above, False, "yes"),
                 (Estimate(1, -1, 3, 5), True, "open"), (Estimate(1, NAN, NAN, 1), True, "open"))
        for difference, less, kind in cases:
            self.assertEqual(judge(difference, less), kind)

    def test_numbers_have_three_digits(self):
        for value, text in ((1234.5, "1234"), (12.345, "12.3"), (1.2345, "1.23"), (-0.12345, "-0.123"), (0, "0"), (NAN, "-"),
                            (Estimate(2, 1, 3, 5), "2.00 [1.00, 3.00]"), (Estimate(2, NAN, NAN, 1), "2.00")):
            self.assertEqual(number(value), text)


unittest.main()
