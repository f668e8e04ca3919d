#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What ROS 2's own parser (Debian's python3-rosidl) reads in packages of interfaces, as JSON.

read_package.py PACKAGE DEPENDENCY...: folders. Of each message of PACKAGE and of its services {name: {fields, hash}}: a
field as [type, name, comment]; the hash is RIHS01 (REP 2016), made of what the parser says. Exits
with 3 where the parser is not installed.
"""
import hashlib
import json
import pathlib
import sys

try:
    from rosidl_adapter.parser import parse_message_file, parse_service_file
except ImportError:
    sys.exit(3)

# rosidl's type_description_interfaces/msg/FieldType.msg; byte and char as .msg means them.
PLAIN = {"int8": 2, "uint8": 3, "char": 3, "int16": 4, "uint16": 5, "int32": 6, "uint32": 7, "int64": 8,
         "uint64": 9, "float32": 10, "float64": 11, "bool": 15, "byte": 16, "string": 17}
NESTED, BOUNDED_STRING, ARRAY, BOUNDED, UNBOUNDED = 1, 21, 48, 96, 144


def described(type_):
    nested = "" if type_.is_primitive_type() else f"{type_.pkg_name}/msg/{type_.type}"
    bound = type_.string_upper_bound or 0
    kind = NESTED if nested else BOUNDED_STRING if bound else PLAIN[type_.type]
    if type_.is_array:
        kind += BOUNDED if type_.is_upper_bound else ARRAY if type_.array_size else UNBOUNDED
    return {"type_id": kind, "capacity": type_.array_size or 0, "string_capacity": bound,
            "nested_type_name": nested}


def read(folder):
    """{full name: what the parser says} of a package's messages, and of those of its services."""
    package = pathlib.Path(folder).name
    found = {f"{package}/msg/{file.stem}": parse_message_file(package, str(file))
             for file in sorted(pathlib.Path(folder).glob("msg/*.msg"))}
    for file in sorted(pathlib.Path(folder).glob("srv/*.srv")):
        service = parse_service_file(package, str(file))
        found[f"{package}/srv/{file.stem}_Request"] = service.request
        found[f"{package}/srv/{file.stem}_Response"] = service.response
    return found


def description(name, known):
    return {"type_name": name, "fields": [{"name": field.name, "type": described(field.type)}
                                          for field in known[name].fields]}


def nested_in(name, known):
    found = set()
    for field in description(name, known)["fields"]:
        inner = field["type"]["nested_type_name"]
        if inner and inner not in found:
            found |= {inner} | nested_in(inner, known)
    return found


def type_hash(name, known):
    text = json.dumps({"type_description": description(name, known),
                       "referenced_type_descriptions": [description(inner, known) for inner in
                                                        sorted(nested_in(name, known))]},
                      separators=(", ", ": "))
    return "RIHS01_" + hashlib.sha256(text.encode()).hexdigest()


def comment(field):
    """With the unit, which the parser takes out of it where it stands alone in brackets."""
    unit = field.annotations.get("unit")
    words = [f"[{unit}]"] if unit else []
    return " ".join(words + field.annotations.get("comment", [])).strip()


def fields(message):
    return [[str(field.type), field.name, comment(field)] for field in message.fields]


def main():
    own = read(sys.argv[1])
    known = dict(own)
    for folder in sys.argv[2:]:
        known.update(read(folder))
    print(json.dumps({name: {"fields": fields(message), "hash": type_hash(name, known)}
                      for name, message in own.items()}))


if __name__ == "__main__":
    main()
