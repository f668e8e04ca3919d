// SPDX-License-Identifier: Apache-2.0

/** The time of the page [ms]: never goes back. */
export const pageNow = (): number => performance.timeOrigin + performance.now();
