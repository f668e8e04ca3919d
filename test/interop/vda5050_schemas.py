#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks messages against the JSON schemas of VDA 5050, which are at https://github.com/VDA5050/VDA5050.

usage: vda5050_schemas.py SCHEMAS_2_1 SCHEMAS_3_0 < MESSAGES

SCHEMAS_...: the folder json_schemas of that release. MESSAGES: lines as random_messages_test of vda5050_gateway writes them (JSON with topic,
payload and refused), or as `mosquitto_sub -v` prints them (topic, space, payload).
What the vehicle sends must be valid; an order that is not valid must be refused. Exit code 1 when one is not so.
"""
import collections
import json
import pathlib
import re
import sys

import jsonschema

TAKEN = ("order", "instantActions")
FATES = {True: "refused", False: "taken or known", None: "received"}


def load(folder: str) -> dict:
    """Schemas by the last level of their topic. Those of 3.0.0 have commas before closing brackets, which JSON has not."""
    schemas = {}
    for file in pathlib.Path(folder).glob("*.schema"):
        text = re.sub(r",(\s*[}\]])", r"\1", file.read_text(encoding="utf-8"))
        schemas[file.stem] = jsonschema.Draft202012Validator(
            json.loads(text), format_checker=jsonschema.FormatChecker()
        )
    if not schemas:
        sys.exit(f"vda5050_schemas.py: no *.schema in {folder}")
    return schemas


def parse(line: str) -> tuple:
    """Topic, payload and whether an order was refused; None: not known."""
    if line.startswith("{"):
        message = json.loads(line)
        return message["topic"], message["payload"], message["refused"]
    topic, _, payload = line.partition(" ")
    return topic, payload, None


def fault_of(schema, payload: str) -> str | None:
    try:
        message = json.loads(payload)
    except ValueError as error:
        return f"no JSON: {error}"
    best = jsonschema.exceptions.best_match(schema.iter_errors(message))
    return None if best is None else f"{best.json_path}: {best.message[:200]}"


def main() -> int:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    schemas = {"v2": load(sys.argv[1]), "v3": load(sys.argv[2])}
    counts: collections.Counter = collections.Counter()
    wrong = 0
    for line in filter(str.strip, sys.stdin):
        topic, payload, refused = parse(line)
        levels = topic.split("/")
        schema = schemas.get(levels[1] if len(levels) == 5 else "", {}).get(levels[-1])
        if schema is None:
            continue
        fault = fault_of(schema, payload)
        name = f"{levels[1]} {levels[-1]}"
        if levels[-1] in TAKEN:
            counts[f"{name}: {'in' if fault else ''}valid, {FATES[refused]}"] += 1
            is_wrong = fault is not None and refused is False
        else:
            counts[f"{name}: {'in' if fault else ''}valid"] += 1
            is_wrong = fault is not None
        if is_wrong:
            wrong += 1
            print(f"{topic}: {fault}\n  {payload[:400]}")
    for name, count in sorted(counts.items()):
        print(f"{count:7} {name}")
    print(f"{wrong} wrong")
    return 1 if wrong or not counts else 0


if __name__ == "__main__":
    sys.exit(main())
