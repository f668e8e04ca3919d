#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes C++ that knows every message type of the workspace by both generators: how to fill one with
values drawn from a seed, and its description for our runtime and for Cyclone DDS.

usage: make_types.py OUTPUT IDL ...
"""
import pathlib
import re
import sys

TOKEN = re.compile(r"\bmodule\s+(?P<module>\w+)\s*\{|\bstruct\s+(?P<struct>\w+)\s*\{(?P<body>[^{}]*)\}|"
                   r"\benum\s+\w+\s*\{[^{}]*\}|(?P<end>\})")
HEAD = """// Made by make_types.py.
#include "types.hpp"

{includes}

namespace tocsin::interop {{
namespace {{

{declarations}
{templates}
{definitions}
}}  // namespace

const std::vector<MessageType>& all_types() {{
  static const std::vector<MessageType> all{{
{entries}  }};
  return all;
}}

}}  // namespace tocsin::interop
"""
TEMPLATES = """template <class T>
void fill(T& value, Random& random) {
  if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(0);
  } else if constexpr (std::is_same_v<T, bool>) {
    value = random() % 2 == 1;
  } else {
    value = static_cast<T>(random() % 101);
  }
}
void fill(std::string& value, Random& random) { value.assign(random() % 7, 'x'); }
template <class T>
void fill(std::vector<T>& list, Random& random) {
  list.resize(random() % 4);
  for (std::size_t i = 0; i < list.size(); ++i) {
    T item{};
    fill(item, random);
    list[i] = item;
  }
}
template <class T, std::size_t size>
void fill(std::array<T, size>& list, Random& random) {
  for (T& item : list) fill(item, random);
}
"""


def structs_of(text):
    """(module path, name, field names) of each struct."""
    text = re.sub(r"//[^\n]*|@\w+(\([^)]*\))?", "", text)
    path = []
    for found in TOKEN.finditer(text):
        if found["module"]:
            path.append(found["module"])
        elif found["end"]:
            path.pop()
        elif found["struct"]:
            fields = []
            for declaration in found["body"].split(";"):
                declaration = re.sub(r"\[[^]]*\]|<.*>", " ", declaration).strip()
                if declaration:
                    first, *others = declaration.split(",")
                    fields += [first.split()[-1], *(other.strip() for other in others)]
            # A leading underscore says that the name is none of IDL's own words.
            yield tuple(path), found["struct"], [field.lstrip("_") for field in fields]


def main():
    output, *files = sys.argv[1:]
    declarations, definitions, entries, includes = [], [], [], []
    for file in map(pathlib.Path, files):
        package = file.parent.parent.name
        includes += [f'#include "{package}/{file.stem}.hpp"', f'#include "{file.stem}.h"']
        for path, name, fields in structs_of(file.read_text()):
            cpp, c = "::".join((*path, name)), "_".join((*path, name))
            declarations.append(f"void fill({cpp}& message, Random& random);")
            body = "".join(f"  fill(message.{field}(), random);\n" for field in fields)
            definitions.append(f"void fill({cpp}& message, Random& random) {{\n{body}}}\n")
            entries.append(f"      {{&type_info<{cpp}>(), &{c}_desc, make<{cpp}>}},\n")
    make = ("template <class T>\nstd::shared_ptr<void> make(Random& random) {\n"
            "  auto message = std::make_shared<T>();\n  fill(*message, random);\n"
            "  return message;\n}\n")
    pathlib.Path(output).write_text(HEAD.format(
        includes="\n".join(includes), declarations="\n".join(declarations), templates=TEMPLATES,
        definitions="\n".join(definitions) + "\n" + make, entries="".join(entries)))


if __name__ == "__main__":
    main()
