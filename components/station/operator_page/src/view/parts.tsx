// SPDX-License-Identifier: Apache-2.0
// Small parts that every panel uses.
import type { ComponentChildren } from "preact";

import { type Heard, ageText, freshness } from "../model/freshness.ts";

export function Panel(props: { name: string; title: string; aside?: ComponentChildren; children: ComponentChildren }) {
  return (
    <section class={`panel ${props.name}`} aria-label={props.title}>
      <header>
        <h2>{props.title}</h2>
        {props.aside}
      </header>
      {props.children}
    </section>
  );
}

/** The age of what is not fresh any more. */
export function Age({ at, now }: { at: number | undefined; now: number }) {
  if (at === undefined || freshness(at, now) === "fresh") return null;
  return <span class="age"> {ageText(now - at)} ago</span>;
}

/** A value with its name; grey with its age when stale, only the age when unknown. */
export function Value<Type>(props: {
  label: string;
  heard: Heard<Type> | undefined;
  now: number;
  show: (value: Type) => ComponentChildren;
  bad?: (value: Type) => boolean;
}) {
  const { heard, now } = props;
  const state = freshness(heard?.at, now);
  const isBad = heard !== undefined && state === "fresh" && props.bad?.(heard.value);
  return (
    <div class={`value ${state}${isBad ? " bad" : ""}`}>
      <dt>{props.label}</dt>
      <dd>
        {heard === undefined ? "–" : state === "unknown" ? "?" : props.show(heard.value)}
        <Age at={heard?.at} now={now} />
      </dd>
    </div>
  );
}

/** A number with its unit; "–" when it was not measured. */
export function number(value: number | undefined, digits: number, unit = ""): string {
  if (value === undefined || !Number.isFinite(value)) return "–";
  return `${value.toFixed(digits)}${unit && "\u202f"}${unit}`;
}

/** 1234 as "1.2 k", so that columns stay narrow. */
export function count(value: number): string {
  if (value < 10_000) return String(value);
  return value < 1e6 ? `${(value / 1000).toFixed(0)}\u202fk` : `${(value / 1e6).toFixed(1)}\u202fM`;
}
