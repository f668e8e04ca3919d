// SPDX-License-Identifier: Apache-2.0

/** Why a side pauses or sends again, in an operator's words: of the reasons that policies give (decision/policy.hpp). */
const words: Readonly<Record<string, string>> = {
  threshold_low: "quality is below its bound",
  threshold_high: "quality is above its bound",
  cusum_alarm: "quality has fallen",
  detector_alarm: "quality has fallen",
  reverse_alarm: "quality has risen",
  best_so_far: "quality is the best of the pause",
  belief_bad: "the link is probably bad",
  belief_good: "the link is probably good again",
  better_ahead: "a better link comes on the way",
  good_enough: "the link is good enough here",
  no_outlook: "nothing can be foreseen",
  fixed_pause_over: "the pause is over",
  forced_resume_samples: "a pause lasts no longer",
  forced_resume_time: "a pause lasts no longer",
};

/** The policy's own word where there is no better one. */
export const reasonText = (reason: string): string => words[reason] ?? reason;

/** Why the vehicle does not drive on: of the reasons of navigation_status, which begin the sentence "The vehicle". */
const standing: Readonly<Record<string, string>> = {
  no_path: "is blocked: it finds no way to its goal",
  stuck: "is blocked: it does not move",
  goal_expired: "holds: its goal was not renewed in time",
  link_lost: "does not hear the station, and does what it was told for that",
  no_pose: "holds: it does not know where it is",
  no_scan: "holds: its laser is silent",
  emergency_stop: "holds: emergency stop",
  sending: "stands to send what it has stored",
};

/** Nothing for a vehicle that drives, is there, or has nowhere to go. */
export function standingText(state: string, reason: string): string | undefined {
  if (state !== "blocked" && state !== "held") return undefined;
  return standing[reason] ?? (state === "blocked" ? "is blocked" : "holds");
}
