# SPDX-License-Identifier: Apache-2.0
"""The messages of an IDL file in TypeScript, as a reader of ros2msg decodes them, for pages.

<stem>.ts declares an interface for each struct, in a global namespace named after its ROS package,
and exports each one's name and its whole definition in ROS 2's .msg syntax, for who writes it.
"""
import json

import ros_definition
from idl_dialect import ALIAS, ARRAY, SEQUENCE, STRING, STRUCT, own_definitions

BOOLEAN, BIG, UINT8 = 7, (17, 18), 30
SEPARATOR = f"\n{'=' * 80}\n"


def list_text(content):
    while content["kind"] == ALIAS:
        content = content["content"]
    if content["kind"] == UINT8:
        return "Uint8Array"
    if content["kind"] in (STRUCT, STRING, BOOLEAN):
        return f"readonly {type_text(content)}[]"
    return f"ArrayLike<{type_text(content)}>"


def type_text(type_):
    """`bigint`, `readonly string[]`, `std_msgs.Header`."""
    kind = type_["kind"]
    if kind == ALIAS:
        return type_text(type_["content"])
    if kind in (SEQUENCE, ARRAY):
        return list_text(type_["content"])
    if kind == STRUCT:
        return ros_definition.msg_name(type_["struct"]).replace("/", ".")
    if kind == STRING:
        return "string"
    return "boolean" if kind == BOOLEAN else "bigint" if kind in BIG else "number"


def interface(struct, notes):
    lines = [f"    interface {struct['name']} {{"]
    for field in struct["members"]:
        note = notes.get(field["name"], "").replace("*/", "* /")
        lines += [f"      /** {note} */"] if note else []
        lines.append(f"      readonly {field['name']}: {type_text(field)};")
    return "\n".join([*lines, "    }", ""])


def scoped_name(one):
    return "::".join(filter(None, [one["scope"], one["name"]]))


def own_text(struct):
    """Lines of its own fields; None: .msg cannot say it."""
    said = [(ros_definition.type_text(field), field["name"]) for field in struct["members"]]
    return None if any(text is None for text, _ in said) else "\n".join(map(" ".join, said))


def parts(struct, known):
    """All structs in it, each once, those of its own fields first."""
    found = []
    waiting = [struct]
    while waiting:
        for field in waiting.pop(0)["members"]:
            name = ros_definition.struct_in(field)
            if name and name not in found:
                found.append(name)
                waiting.append(known[name])
    return found


def definition(struct, known):
    """The whole text of a message, with those of all structs in it; None: .msg cannot say it."""
    texts = [own_text(struct)]
    for name in parts(struct, known):
        text = own_text(known[name]) if ros_definition.msg_name(name) else None
        texts.append(text and f"MSG: {ros_definition.msg_name(name)}\n{text}")
    return None if None in texts else SEPARATOR.join(texts)


def file_text(stem, text, parsed):
    """<stem>.ts; `text` is the IDL file."""
    known = {scoped_name(one): one for one in parsed["definitions"] if one.get("kind") == STRUCT}
    spaces, values = {}, []
    for one in own_definitions(parsed):
        scoped = scoped_name(one)
        name = ros_definition.msg_name(scoped)
        said = definition(one, known) if one["kind"] == STRUCT and name else None
        if said is None:
            continue
        spaces.setdefault(name.split("/")[0], []).append(
            interface(one, ros_definition.comments(text, one)))
        schema = {"schemaName": scoped.replace("::", "/"), "text": said}
        values.append(f"export const {one['name']} = {json.dumps(schema)};\n")
    inside = "".join(f"  namespace {package} {{\n{''.join(all_)}  }}\n"
                     for package, all_ in spaces.items())
    return f"// Generated from {stem}.idl.\ndeclare global {{\n{inside}}}\n" + ("".join(values) or "export {};\n")
