# SPDX-License-Identifier: Apache-2.0
"""Runs fastddsgen, 2.3 or 4.0, as a parser that tells what it has read.

What it says is passed on as file:line: reason; its Java stack traces are not.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

TEMPLATE = pathlib.Path(__file__).with_name("fields.stg")
# Every template group that fastddsgen applies; what it would generate could fail on what it reads.
GROUPS = {"com/eprosima/fastcdr/idl/templates": ["TypesHeader", "TypesSource"],
          "com/eprosima/fastdds/idl/templates": [
              "DDSPubSubTypeHeader", "DDSPubSubTypeSource", "TypesCdrAuxHeader",
              "TypesCdrAuxHeaderImpl", "XTypesTypeObjectHeader", "XTypesTypeObjectSource"]}
VALUE = re.compile(r"~(.*?)~", re.DOTALL)
ESCAPES = re.compile(r"\x1b\[[0-9;]*m")
CURRENT = re.compile(r"Processing the file (?P<file>.*)\.\.\.$")
PLACED = re.compile(r"(?P<file>\S.*?):(?P<line>\d+):\d+: (?:fatal )?error: (?P<text>.*)")
WARNED = re.compile(r"WARNING \(File (?P<file>\w+), Line (?P<line>\d+)\): (?P<text>.*)")
DROPPED = re.compile(r"line \d+:\d+ token recognition error at: '(?P<token>.*)'")
NOISE = re.compile(r"\s*at |Exception in thread|Picked up|Loading templates|Processing the file|"
                   r"Generating |Adding project|\s+\d* \|")
OTHER_NAMES = {"float32": "float", "float64": "double", "bool": "boolean", "byte": "octet",
               "int": "long", "uint": "unsigned long", "int128": None, "std_string": "string"}


class IdlError(Exception):
    """What is wrong with an IDL file: one line per fault, as file:line: reason."""


def line_with(file, token):
    """The number of the first line that holds `token` outside of a comment."""
    lines = pathlib.Path(file).read_text(errors="replace").splitlines()
    found = [number for number, line in enumerate(lines, 1) if token in line.split("//")[0]]
    return found[0] if found else 1


def reason(text):
    """What fastddsgen says, without names of Java objects, and with the name that IDL has."""
    text = re.sub(r" \(Definition: [^)]*\)", "", text).replace(". Ignoring...", "").rstrip(".")
    unknown = re.match(r"'(\w+)' was not defined previously", text)
    name = OTHER_NAMES.get(unknown.group(1)) if unknown else None
    return f"{text}; IDL calls it {name}" if name else text


def complaints(log):
    """The faults that fastddsgen or the preprocessor names, in their order, each once."""
    faults, current = [], "IDL"
    for line in ESCAPES.sub("", log).splitlines():
        now = CURRENT.match(line)
        placed = PLACED.match(line) or WARNED.match(line)
        dropped = DROPPED.match(line)
        if now:
            current = now["file"]
        elif placed:
            file = placed["file"]
            file = current if file == pathlib.Path(current).stem else file
            faults.append(f"{file}:{placed['line']}: {reason(placed['text'])}")
        elif dropped:
            faults.append(f"{current}:{line_with(current, dropped['token'])}: "
                          f"'{dropped['token']}' is no part of IDL")
    return list(dict.fromkeys(faults))


def call(generator, idls, search, scratch):
    """One run of fastddsgen into scratch/out. Throws IdlError when it has any complaint."""
    out = scratch / "out"
    (scratch / "temporary").mkdir(parents=True)
    out.mkdir()
    command = [str(generator), "-cs", "-replace", "-t", str(scratch / "temporary"), "-d", str(out)]
    command += [word for folder in search for word in ("-I", str(folder))]
    # The Java machine looks there before it looks into fastddsgen's own archive.
    options = "-Xbootclasspath/a:templates " + os.environ.get("JAVA_TOOL_OPTIONS", "")
    done = subprocess.run(command + [str(idl) for idl in idls], cwd=scratch, errors="replace",
                          env={**os.environ, "JAVA_TOOL_OPTIONS": options}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    faults = complaints(done.stdout)
    if faults:
        raise IdlError("\n".join(faults))
    if done.returncode != 0:
        said = [line for line in ESCAPES.sub("", done.stdout).splitlines() if not NOISE.match(line)]
        raise IdlError(f"{generator}: ended with code {done.returncode}: " + " ".join(said))
    return out


def read(out, stem):
    """What our template has made of an IDL file. Throws ValueError or StopIteration when it has not."""
    headers = (file for file in sorted(out.rglob(f"{stem}.h*")) if file.suffix in (".h", ".hpp"))
    return json.loads(VALUE.sub(lambda value: json.dumps(value[1]), next(headers).read_text()))


def parse(generator, idls, search):
    """What each of the IDL files declares and includes, as fastddsgen has parsed it."""
    with tempfile.TemporaryDirectory(prefix="tocsin_idl_") as name:
        scratch = pathlib.Path(name)
        for folder, groups in GROUPS.items():
            (scratch / "templates" / folder).mkdir(parents=True)
            for group in groups:
                shutil.copy(TEMPLATE, scratch / "templates" / folder / f"{group}.stg")
        out = call(generator, idls, search, scratch)
        try:
            return {idl: read(out, idl.stem) for idl in idls}
        except (ValueError, StopIteration):
            raise IdlError(f"{generator}: is neither version 2.3 nor 4.0, which this knows") from None
