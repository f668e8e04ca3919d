# SPDX-License-Identifier: Apache-2.0
"""Runs fastddsgen 2.3: as a parser that tells what it has read, and as the generator that it is.

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
          "com/eprosima/fastdds/idl/templates": ["DDSPubSubTypeHeader", "DDSPubSubTypeSource"]}
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


def call(generator, idls, search, scratch, environment=None):
    """One run of fastddsgen into scratch/out. Throws IdlError when it has any complaint."""
    out = scratch / "out"
    (scratch / "temporary").mkdir(parents=True)
    out.mkdir()
    command = [str(generator), "-cs", "-replace", "-t", str(scratch / "temporary"), "-d", str(out)]
    command += [word for folder in search for word in ("-I", str(folder))]
    done = subprocess.run(command + [str(idl) for idl in idls], cwd=scratch, errors="replace",
                          env={**os.environ, **(environment or {})}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    faults = complaints(done.stdout)
    if faults:
        raise IdlError("\n".join(faults))
    if done.returncode != 0:
        said = [line for line in ESCAPES.sub("", done.stdout).splitlines() if not NOISE.match(line)]
        raise IdlError(f"{generator}: ended with code {done.returncode}: " + " ".join(said))
    return out


def parse(generator, idls, search):
    """What each of the IDL files declares and includes, as fastddsgen has parsed it."""
    with tempfile.TemporaryDirectory(prefix="tocsin_idl_") as name:
        scratch = pathlib.Path(name)
        for folder, groups in GROUPS.items():
            (scratch / "templates" / folder).mkdir(parents=True)
            for group in groups:
                shutil.copy(TEMPLATE, scratch / "templates" / folder / f"{group}.stg")
        # The Java machine looks there before it looks into fastddsgen's own archive.
        options = "-Xbootclasspath/a:templates " + os.environ.get("JAVA_TOOL_OPTIONS", "")
        out = call(generator, idls, search, scratch, {"JAVA_TOOL_OPTIONS": options})
        try:
            return {idl: json.loads((out / f"{idl.stem}.h").read_text()) for idl in idls}
        except json.JSONDecodeError:
            raise IdlError(f"{generator}: is not version 2.3, which this needs") from None


def generate(generator, idls, search):
    """Header and source that fastddsgen makes of each file: {stem: (text, text)}.

    It writes the files that are included, too, and names of Java objects into comments.
    """
    with tempfile.TemporaryDirectory(prefix="tocsin_idl_") as name:
        out = call(generator, idls, search, pathlib.Path(name))
        return {idl.stem: tuple(re.sub(r"(//[^\n]*)@[0-9a-f]+", r"\1",
                                       (out / f"{idl.stem}.{end}").read_text())
                                for end in ("h", "cxx"))
                for idl in idls}
