// SPDX-License-Identifier: Apache-2.0

/** Whether keys write there, or choose, so that letters are not the page's. The space bar stops everywhere. */
export const isWriting = (place: EventTarget | null): boolean =>
  place instanceof HTMLSelectElement || (place instanceof HTMLInputElement && place.type === "text");
