# SPDX-License-Identifier: Apache-2.0
"""RIHS01, by which ROS 2 tells whether two ends mean the same by a type.

SHA-256 over a description of the type and of all types that it is made of, as JSON: REP 2016 and
rosidl_generator_type_description.
"""
import hashlib
import json
import pathlib
import re

from idl_dialect import ALIAS, ARRAY, SEQUENCE, STRING, STRUCT

NESTED, BOUNDED_STRING = 1, 21
# By the kinds of fastddsgen. ROS 2 has no enums: they stand for the number that is sent.
PLAIN = {1: 4, 2: 6, 3: 5, 4: 7, 5: 10, 6: 11, 7: 15, 8: 13, 9: 16, 12: 7, 17: 8, 18: 9, 29: 2, 30: 3,
         STRING: 17}
OF_ARRAY, OF_BOUNDED, OF_UNBOUNDED = 48, 96, 144  # added to what the elements are
BOUND = re.compile(r"\[bound (\d+)\]")
TOKEN = re.compile(r"\b(?:module|struct)\s+(\w+)\s*\{|\{|\}|(\w+)\s*(?:\[[^\]]*\]\s*)*[;,]")


class NoRosType(Exception):
    """What no interface file of ROS 2 can say, so that there is no hash."""


def bounds_in(text):
    """{(scoped type, field): n} of the comments "[bound n]" of an IDL file.

    The dialect has no bounds, as nothing would check them; those of ROS 2's types count here only.
    """
    found, scope = {}, []
    for line in text.splitlines():
        code, _, comment = line.partition("//")
        bound = BOUND.search(comment)
        for token in TOKEN.finditer(code):
            if token[0].endswith("{"):
                scope.append(token[1] or "")
            elif token[0] == "}":
                scope = scope[:-1]
            elif bound and token[2]:
                found["::".join(scope), token[2]] = int(bound[1])
    return found


def bounds_of(idl, includes, search):
    """Those of a file and of all that it includes."""
    found = bounds_in(idl.read_text(errors="replace"))
    for name in includes:
        for folder in [idl.parent, *search]:
            included = pathlib.Path(folder) / name
            if not included.is_file():
                continue
            further = re.findall(r'#include "([^"]+)"', included.read_text(errors="replace"))
            found.update(bounds_of(included, further, search))
            break
    return found


def ros_name(scoped):
    return scoped.replace("::", "/")


def plain(type_):
    """What stands behind the names of a typedef."""
    return plain(type_["content"]) if type_["kind"] == ALIAS else type_


def element(type_, bound):
    kind = type_["kind"]
    if kind == STRUCT:
        return {"type_id": NESTED, "capacity": 0, "string_capacity": 0,
                "nested_type_name": ros_name(type_["struct"])}
    if kind not in PLAIN:
        raise NoRosType
    bounded = kind == STRING and bound
    return {"type_id": BOUNDED_STRING if bounded else PLAIN[kind], "capacity": 0,
            "string_capacity": bound if bounded else 0, "nested_type_name": ""}


def field_type(type_, bound):
    type_ = plain(type_)
    if type_["kind"] not in (SEQUENCE, ARRAY):
        return element(type_, bound)
    described = element(plain(type_["content"]), 0)
    if type_["kind"] == SEQUENCE:
        described["type_id"] += OF_BOUNDED if bound else OF_UNBOUNDED
        described["capacity"] = bound
    else:
        described["type_id"] += OF_ARRAY
        described["capacity"] = 1
        for size in type_["dimensions"]:
            described["capacity"] *= int(size)
    return described


class Hashes:
    """The hashes of the types of one parsed IDL file and of what it includes."""

    def __init__(self, parsed, bounds):
        self.bounds = bounds
        self.structs = {"::".join(filter(None, [one["scope"], one["name"]])): one
                        for one in parsed["definitions"]
                        if one["is"] == "type" and one["kind"] == STRUCT}

    def described(self, scoped):
        fields = [{"name": field["name"],
                   "type": field_type(field, self.bounds.get((scoped, field["name"]), 0))}
                  for field in self.structs[scoped]["members"]]
        return {"type_name": ros_name(scoped), "fields": fields}

    def referenced(self, description):
        """Names of all types that it is made of, at any depth."""
        found = set()
        for field in description["fields"]:
            name = field["type"]["nested_type_name"]
            if name and name not in found:
                found |= {name} | self.referenced(self.described(name.replace("/", "::")))
        return found

    def of(self, scoped):
        """Empty for what ROS 2 cannot say."""
        try:
            description = self.described(scoped)
            names = sorted(self.referenced(description))
            whole = {"type_description": description,
                     "referenced_type_descriptions": [self.described(name.replace("/", "::"))
                                                      for name in names]}
        except NoRosType:
            return ""
        text = json.dumps(whole, separators=(", ", ": "), sort_keys=False)
        return "RIHS01_" + hashlib.sha256(text.encode()).hexdigest()
