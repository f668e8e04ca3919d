#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Copies generated types with their small functions moved into the header, as inline.

usage: inline_types.py FROM_DIRECTORY TO_DIRECTORY STEM ...

fastddsgen defines each accessor, constructor and assignment in the .cxx file: a call into a shared
library for one move of a number, and copies that construct first and assign then. Here accessors
and default constructors become inline, and what copies, moves or destroys becomes the compiler's
own (`= default`), which does the same to the same members. CDR coding stays in the .cxx file.
"""
import pathlib
import re
import sys

from describe_idl import put

COMMENT = re.compile(r"/\*!.*?\*/\n", re.DOTALL)
DECLARATION = re.compile(r"(?P<start>(?P<name>\w+)(?:& operator =)?\(\s*"
                         r"(?:const (?P=name)& x|(?P=name)&& x)\)(?: noexcept)?|~\w+\(\));")
DEFINITION = re.compile(r"^(?P<signature>\w[^;{}#]*?\b(?P<owner>\w+)::(?P<name>operator \W+|~?\w+)"
                        r"\((?P<arguments>[^{}]*?))\n\{\n.*?^\}\n", re.DOTALL | re.MULTILINE)
CODING = re.compile(r"(get(Max|KeyMax)?CdrSerializedSize|(de)?serialize(Key)?|isKeyDefined|"
                    r"operator [!=]=)$")


def is_default(definition):
    """Of what the compiler can make itself: destructor, copy, move."""
    name, owner = definition["name"], definition["owner"]
    takes_itself = re.search(rf"(const {owner}&|{owner}&&) x\)", definition["arguments"])
    return name.startswith("~") or (name in (owner, "operator =") and takes_itself is not None)


def inlined(header, source):
    """The header and source with each small function in its new place."""
    moved = []

    def sort(definition):
        if CODING.match(definition["name"]):
            return definition[0]
        if not is_default(definition):
            moved.append("inline " + definition[0])
        return ""

    source = DEFINITION.sub(sort, COMMENT.sub("", source))
    header = DECLARATION.sub(r"\g<start> = default;", COMMENT.sub("", header))
    guard = header.rindex("#endif")
    includes = "#include <cstring>\n#include <utility>\n\n"
    return header[:guard] + includes + "\n".join(moved) + "\n" + header[guard:], source


def main():
    raw, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    for stem in sys.argv[3:]:
        header, source = inlined(*((raw / f"{stem}.{end}").read_text() for end in ("h", "cxx")))
        put(out / f"{stem}.h", header + "\n")
        put(out / f"{stem}.cxx", source)


if __name__ == "__main__":
    main()
