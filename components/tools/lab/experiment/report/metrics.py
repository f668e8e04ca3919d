# SPDX-License-Identifier: Apache-2.0
"""The metrics for readers: unit, whether less is better, definition; by their column in runs.csv, in its order."""

METRICS = {
    "qni_mean": ("%", False, "network quality indicator, mean over the vehicle's decisions"),
    "qni_min": ("%", False, "the lowest QNI of the run"),
    "probe_per_mean": ("%", True, "share of ICMP echoes without an answer: mean over the vehicle's measurements"),
    "probe_per_max": ("%", True, "the highest of these measurements (20 echoes each)"),
    "telemetry_per": ("%", True,
        "share of the vehicle's samples that were put on the link and never arrived, all topics but the camera; what "
        "the gate held back was not sent"),
    "telemetry_per_max": ("%", True, "the highest share lost in one observation (at least 10 samples sent in it)"),
    "user_cost": ("1", True,
        "one cost of what users feel: weighted sum of the late shares of class critical and high, of class low not "
        "delivered, of the age of the location, of the delay of pictures and of airtime; the weights are the "
        "experiment file's, in units of one percent of class low"),
    "critical_late": ("%", True,
        "share of samples sent that came later than 250 ms or never, class critical of the vehicle"),
    "critical_very_late": ("%", True, "the same, later than 1 s or never"),
    "high_late": ("%", True, "share that came later than 250 ms or never, class high"),
    "high_very_late": ("%", True, "the same, later than 1 s or never"),
    "critical_lost": ("%", True,
        "share of samples sent that never arrived, repaired or not, class critical of the vehicle"),
    "high_lost": ("%", True, "the same of class high"),
    "low_lost": ("%", True, "the same of class low without the camera"),
    "camera_lost": ("%", True, "the same of the camera"),
    "goals_lost": ("%", True, "the same of the ground station's goals (class high)"),
    "high_delivered": ("%", False, "share that arrived of all that the vehicle's components wrote, class high"),
    "low_delivered": ("%", False, "the same of class low, camera included, held back ones counted"),
    "critical_latency_median": ("ms", True, "from write to acknowledgement, median, class critical"),
    "critical_latency_p99": ("ms", True, "the same, 99th percentile"),
    "high_latency_median": ("ms", True, "from write to acknowledgement, median, class high"),
    "high_latency_p99": ("ms", True, "the same, 99th percentile"),
    "low_latency_p99": ("ms", True, "the same, class low without the camera"),
    "picture_latency_p99": ("ms", True, "from write to acknowledgement of a whole picture, 99th percentile"),
    "goal_latency_p99": ("ms", True, "from write to acknowledgement of the ground station's goals"),
    "location_age_mean": ("s", True,
        "age of the newest received sample at the ground station, looked at each half second: mean"),
    "location_age_p95": ("s", True, "the same, 95th percentile"),
    "location_age_p99": ("s", True, "the same, 99th percentile"),
    "quality_age_mean": ("s", True, "network quality: the same, mean"),
    "quality_age_p95": ("s", True, "network quality: 95th percentile"),
    "battery_age_mean": ("s", True, "battery state (class low): mean"),
    "battery_age_p95": ("s", True, "battery state (class low): 95th percentile"),
    "camera_age_mean": ("s", True, "camera (class low): mean"),
    "camera_age_p95": ("s", True, "camera (class low): 95th percentile"),
    "heartbeat_age_mean": ("s", True, "heartbeat (class critical): mean"),
    "heartbeat_age_p95": ("s", True, "heartbeat (class critical): 95th percentile"),
    "state_age_mean": ("s", True, "transmission state (class critical): mean"),
    "state_age_p95": ("s", True, "transmission state (class critical): 95th percentile"),
    "cpu_age_mean": ("s", True, "CPU load (class low): mean"),
    "cpu_age_p95": ("s", True, "CPU load (class low): 95th percentile"),
    "link_bytes": ("MB", True, "IP packets given to the radio, both directions"),
    "airtime": ("%", True, "share of the run that our frames and acknowledgements were on the air"),
    "poor_share": ("%", True, "share of the run in which the link was truly poor"),
    "poor_intervals": ("1", True, "truly poor intervals of at least two observations; shorter gaps do not divide one"),
    "missed": ("1", True, "of these, without any pause"),
    "detect": ("s", True,
        "from the begin of a truly poor interval, where the clairvoyant pauses, to the pause: mean over the intervals "
        "that had one"),
    "resume": ("s", True, "from the end of a truly poor interval, where the clairvoyant resumes, to speaking: mean"),
    "sent_in_poor": ("%", True, "share of the truly poor time in which the gate was open"),
    "silent_in_good": ("%", True, "share of the other time in which it was closed"),
    "slot_cost": ("1", True,
        "cost per 1000 observations: 1 for one spoken in while the link was truly poor (for more than half of it), 0.5"
        " for a silent one while it was good, 0.1 for a silent one while poor, 0.5 for each change; the costs of the "
        "decision library, to which `fit` fits the policies"),
    "slot_regret": ("1", True,
        "the same, minus the cost of the clairvoyant, who knows the truth beforehand and is never silent for more than"
        " 30 observations"),
    "pauses": ("1", True, "pauses of the vehicle"),
    "silence_mean": ("s", True, "length of a pause, mean"),
    "silence_max": ("s", True, "length of the longest pause"),
    "completion": ("s", True, "from the first goal to the last waypoint; none when it was not reached"),
    "completed": ("1", False, "1 when the mission was done within the run"),
    "stalled": ("%", True, "share of observations in which the machine froze (real runs)"),
}


def less_is_better(metric):
    return METRICS[metric][1]


def label(metric):
    """`name [unit]`."""
    return f"{metric} [{METRICS[metric][0]}]"
