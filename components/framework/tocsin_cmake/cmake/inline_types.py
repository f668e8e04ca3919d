# SPDX-License-Identifier: Apache-2.0
"""Moves the small functions of generated types into the header, as inline.

fastddsgen defines each accessor, constructor and assignment in the .cxx file: a call into a shared
library for one move of a number, and copies that construct first and assign then. Here accessors
and default constructors become inline, and what copies, moves or destroys becomes the compiler's
own (`= default`), which does the same to the same members. CDR coding stays in the .cxx file.
"""
import re

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
