#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes C++ and TypeScript of IDL files: for each <stem>.hpp, _type_info.cpp and .ts.

fastddsgen parses. What the dialect does not know is refused with file and line, and nothing is
written.
"""
import argparse
import pathlib
import sys

import cpp_types
import describe_idl
import idl_dialect
import idl_parser
import ros_definition
import ros_typescript
import type_hash


def put(path, text):
    """Writes only what differs, so that nothing is compiled in vain."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def files_of(package, idl, parsed, bounds):
    """{file name: text} of one IDL file."""
    stem = idl.stem
    text = idl.read_text(errors="replace")
    definitions = ros_definition.definitions(text, parsed)
    types = idl_dialect.structs(parsed)
    return {f"{stem}.ts": ros_typescript.file_text(stem, text, parsed),
            f"{stem}.hpp": cpp_types.header(stem, parsed),
            f"{stem}_type_info.cpp": describe_idl.source(package, stem, types, definitions,
                                                         type_hash.Hashes(parsed, bounds))}


def refuse_faults(parsed):
    """Throws one IdlError with the faults of all files."""
    faults = []
    for idl, content in parsed.items():
        try:
            idl_dialect.check(idl, content)
        except idl_parser.IdlError as error:
            faults.append(str(error))
    if faults:
        raise idl_parser.IdlError("\n".join(faults))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--generator", default="fastddsgen", help="the program fastddsgen, 2.3 or 4.0")
    parser.add_argument("--package", required=True, help="folder of the headers in an #include")
    parser.add_argument("--out", required=True, type=pathlib.Path, help="folder of what is made")
    parser.add_argument("--search", action="append", default=[], metavar="FOLDER",
                        help="where an #include of IDL is looked for")
    parser.add_argument("idl", nargs="+", type=pathlib.Path)
    return parser.parse_args()


def main():
    given = arguments()
    idls = [idl.absolute() for idl in given.idl]
    search = [pathlib.Path(folder).absolute() for folder in given.search]
    try:
        parsed = idl_parser.parse(given.generator, idls, search)
        refuse_faults(parsed)
    except (idl_parser.IdlError, OSError) as error:
        sys.exit(str(error))
    given.out.mkdir(parents=True, exist_ok=True)
    for idl in idls:
        bounds = type_hash.bounds_of(idl, parsed[idl]["includes"], search)
        for name, text in files_of(given.package, idl, parsed[idl], bounds).items():
            put(given.out / name, text)


if __name__ == "__main__":
    main()
