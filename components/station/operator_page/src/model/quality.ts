// SPDX-License-Identifier: Apache-2.0
// The link's quality in five steps that people with any colour vision tell apart: orange is poor,
// blue is good, grey lies between (Okabe and Ito's palette).

/** Upper limits of the steps, of a QNI in [0, 100]. */
const limits = [30, 45, 60, 75];
export const qualitySteps = limits.length + 1;
export const qualityWords = ["very poor", "poor", "fair", "good", "very good"] as const;

/** 0 (very poor) to 4; undefined for what was not measured. */
export function qualityStep(qni: number | undefined): number | undefined {
  if (qni === undefined || Number.isNaN(qni)) return undefined;
  const step = limits.findIndex((limit) => qni < limit);
  return step < 0 ? limits.length : step;
}
