#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes <stem>.hpp and <stem>_type_info.cpp for each IDL file: the TypeInfo of every struct.

usage: describe_idl.py PACKAGE OUTPUT_DIRECTORY FILE.idl ...

Reads the subset of IDL that this workspace uses: modules, constants, structs. What it does not
understand is an error with file and line; nothing is skipped silently.
"""
import pathlib
import re
import sys

FIELD = re.compile(r"(?:@\w+(?:\([^)]*\))?\s+)*([\w:<>, ]+?)\s+(\w+)\s*(\[[\w:]+\])?\s*;$")


def structs_of(path):
    """Yields (module path, struct name, [field names]) in the order of the file."""
    scope, struct, fields = [], None, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = re.sub(r"//.*|^\s*#.*", "", line).strip()
        for module in re.findall(r"module\s+(\w+)\s*\{", line):
            scope.append(module)
        line = re.sub(r"module\s+\w+\s*\{", "", line).strip()
        if not line or line.startswith("const "):
            continue
        start = re.match(r"(?:@final\s+)?struct\s+(\w+)\s*\{$", line)
        if start:
            struct, fields = start.group(1), []
        elif re.fullmatch(r"(\};?\s*)+", line):
            for _ in range(line.count("}")):
                if struct:
                    yield list(scope), struct, fields
                    struct = None
                else:
                    scope.pop()
        elif struct and FIELD.match(line):
            fields.append(FIELD.match(line).group(2))
        else:
            sys.exit(f"{path}:{number}: not understood: {line}")


def includes_of(path):
    return re.findall(r'^\s*#include\s+"(\w+)\.idl"', path.read_text(), re.MULTILINE)


def header(package, stem, includes, types):
    more = "".join(f'#include "{name}.hpp"\n' for name in includes)
    names = "\n".join(
        f"template <>\nconst TypeInfo& type_info<{'::'.join(scope)}::{name}>();"
        for scope, name, _ in types)
    return (f"// Generated from {stem}.idl.\n#pragma once\n\n"
            f'#include "idl_support/type_info.hpp"\n#include "{package}/{stem}.h"\n{more}\n'
            f"namespace tocsin {{\n{names}\n}}  // namespace tocsin\n")


def visit_function(scope, name, fields):
    body = "".join(f'  cdr::visit_value(v, "{field}", m.{field}());\n' for field in fields)
    return f"void visit_fields(FieldVisitor& v, const {'::'.join(scope + [name])}& m) {{\n{body}}}\n"


def skip_function(scope, name, fields):
    body = " &&\n         ".join(
        f"cdr::skip_field<decltype(std::declval<const M&>().{field}())>(c)" for field in fields)
    return (f"bool skip_{name}(WireCursor& c) {{\n  using M = {'::'.join(scope + [name])};\n"
            f"  return {body};\n}}\n")


def source(package, stem, types):
    text = [f'// Generated from {stem}.idl.\n#include "{package}/{stem}.hpp"\n\n']
    text.append('#include <utility>\n\n#include "idl_support/cdr_type.hpp"\n')
    text.append('#include "idl_support/type_registry.hpp"\n\n')
    text.append("namespace tocsin {\nnamespace {\n")
    text += [visit_function(*item) + skip_function(*item) for item in types]
    text.append("}  // namespace\n")
    for scope, name, _ in types:
        qualified = "::".join(scope + [name])
        wire = "::".join(scope + ["dds_", name + "_"])
        text.append(f"template <>\nconst TypeInfo& type_info<{qualified}>() {{\n"
                    f'  static const TypeInfo info = cdr::make_type_info<{qualified}>(\n'
                    f'      "{wire}", [](const void* m, FieldVisitor& v) {{\n'
                    f"        visit_fields(v, *static_cast<const {qualified}*>(m));\n      }},\n"
                    f"      skip_{name});\n"
                    "  return info;\n}\n")
    text.append("namespace {\nconst bool registered = [] {\n")
    text += [f"  register_type(type_info<{'::'.join(scope + [name])}>());\n"
             for scope, name, _ in types]
    text.append("  return true;\n}();\n}  // namespace\n}  // namespace tocsin\n")
    return "".join(text)


def put(path, text):
    """Writes only what differs, so that nothing is compiled in vain."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main():
    package, out = sys.argv[1], pathlib.Path(sys.argv[2])
    for name in sys.argv[3:]:
        path = pathlib.Path(name)
        types = [item for item in structs_of(path)]
        put(out / f"{path.stem}.hpp", header(package, path.stem, includes_of(path), types))
        put(out / f"{path.stem}_type_info.cpp", source(package, path.stem, types))


if __name__ == "__main__":
    main()
