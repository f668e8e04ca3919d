# SPDX-License-Identifier: Apache-2.0
"""The structs of an IDL file in the syntax of ROS 2's .msg files, for who reads recordings without us.

What that syntax cannot say (a list of lists) has no definition. An enum is the number that is sent.
"""
import re

from idl_dialect import ALIAS, ARRAY, SEQUENCE, STRING, STRUCT, own_definitions

NUMBERS = {1: "int16", 2: "int32", 3: "uint16", 4: "uint32", 5: "float32", 6: "float64", 7: "bool",
           8: "char", 9: "byte", 12: "uint32", 17: "int64", 18: "uint64", 29: "int8", 30: "uint8"}


def wire_name(scoped):
    """`a::msg::B` as it stands on the wire."""
    *scope, name = scoped.split("::")
    return "::".join([*scope, "dds_", name + "_"])


def msg_name(scoped):
    """`a/B` of `a::msg::B`, `a::srv::B` and `a::action::B`; None: it is nothing of ROS 2."""
    parts = scoped.split("::")
    known = len(parts) == 3 and parts[1] in ("msg", "srv", "action")
    return f"{parts[0]}/{parts[2]}" if known else None


def list_of(content, size):
    inner = type_text(content)
    return None if inner is None or inner.endswith("]") else f"{inner}[{size}]"


def type_text(type_):
    """`float64[9]`, `std_msgs/Header`; None: .msg cannot say it."""
    kind = type_["kind"]
    if kind == ALIAS:
        return type_text(type_["content"])
    if kind == STRUCT:
        return msg_name(type_["struct"])
    if kind == SEQUENCE:
        return list_of(type_["content"], "")
    if kind == ARRAY:
        size = 1
        for dimension in type_["dimensions"]:
            size *= int(dimension)
        return list_of(type_["content"], size)
    return "string" if kind == STRING else NUMBERS.get(kind)


def struct_in(type_):
    """The struct that a field is made of, if it is."""
    while "content" in type_:
        type_ = type_["content"]
    return type_.get("struct")


def comments(text, struct):
    """{field: what stands behind it on its line}."""
    begin = re.search(rf"\bstruct\s+{struct['name']}\b", text)
    at = begin.end() if begin else len(text)
    found = {}
    for field in struct["members"]:
        here = re.compile(rf"\b{field['name']}\b[^;\n{{}}]*;(?:[ \t]*//[/<]*[ \t]*(\S[^\n]*))?").search(text, at)
        if here:
            at = here.end()
            found[field["name"]] = (here.group(1) or "").rstrip()
    return found


def definition(text, struct, scoped):
    """(wire name, lines of its own fields, wire names of the structs in it); None: .msg cannot say it."""
    notes = comments(text, struct)
    lines, parts = [], []
    for field in struct["members"]:
        said = type_text(field)
        if said is None:
            return None
        note = notes.get(field["name"])
        lines.append(f"{said} {field['name']}" + (f"  # {note}" if note else ""))
        part = struct_in(field)
        if part and wire_name(part) not in parts:
            parts.append(wire_name(part))
    return wire_name(scoped), "".join(line + "\n" for line in lines), parts


def definitions(text, parsed):
    """The definitions of the file's own messages, in their order; `text` is the file."""
    found = []
    for one in own_definitions(parsed):
        scoped = "::".join(filter(None, [one["scope"], one["name"]]))
        if one["kind"] == STRUCT and msg_name(scoped):
            found.append(definition(text, one, scoped))
    return [one for one in found if one]
