# SPDX-License-Identifier: Apache-2.0
"""The IDL that this workspace takes: what the runtime sends and shows as it is declared.

The rest is refused with file and line, so that no field, key or bound is lost without a word.
"""
import re

from idl_parser import IdlError

PLAIN = {1: "short", 2: "long", 3: "unsigned short", 4: "unsigned long", 5: "float", 6: "double",
         7: "boolean", 8: "char", 9: "octet", 12: "enum", 17: "long long", 18: "unsigned long long",
         29: "int8", 30: "uint8"}
STRUCT, ENUM, STRING, SEQUENCE, ARRAY, ALIAS = 10, 12, 13, 14, 15, 16
REFUSED = {11: "a union", 19: "a long double", 20: "a wide character", 21: "a wide string",
           22: "a value type", 24: "a set", 25: "a map", 26: "a bitset", 27: "a bitmask"}
FIELDS = ("allowed are boolean, octet, char, short, long, long long (also unsigned, and as int8 to "
          "uint64), float, double, string, enums, structs, and sequences and arrays of these")
DEFINITIONS = "allowed are @final structs, enums, typedefs and constants, in modules"


class Source:
    """Where in an IDL file a definition stands. They are asked for in their order."""

    def __init__(self, path):
        text = path.read_text(errors="replace")
        self.text = re.sub(r"//[^\n]*|/\*.*?\*/", lambda c: re.sub(r"[^\n]", " ", c[0]), text,
                           flags=re.DOTALL)
        self.at = 0

    def go_to(self, name):
        found = re.compile(rf"\b(?:struct|union|enum|bitmask|bitset|typedef|exception|interface|"
                           rf"annotation|const)\b[^;{{}}]*?\b{name}\b").search(self.text, self.at)
        self.at = found.end() if found else self.at
        return self.line(self.at)

    def line_of_member(self, name):
        found = re.compile(rf"\b{name}\b").search(self.text, self.at)
        return self.line(found.start() if found else self.at)

    def forwards(self, struct):
        return re.search(rf"\bstruct\s+{struct}\s*;", self.text) is not None

    def goes_on_with(self, sign):
        return self.text[self.at:].lstrip().startswith(sign)

    def line(self, at):
        return self.text.count("\n", 0, at) + 1


def type_fault(type_):
    """Why a field cannot have this type; None when it can."""
    kind = type_["kind"]
    if kind in PLAIN or kind == STRUCT:
        return None
    if kind in (STRING, SEQUENCE) and type_["bounded"]:
        return f"is a bounded {'string' if kind == STRING else 'sequence'}; its bound would be ignored"
    for size in type_.get("dimensions", []):
        if not size.isdigit() or int(size) == 0:
            return f"is an array of {size}; allowed is a number above 0"
    if kind in (SEQUENCE, ARRAY, ALIAS):
        return type_fault(type_["content"])
    return None if kind == STRING else f"is {REFUSED.get(kind, 'of an unknown type')}; {FIELDS}"


def field_faults(field):
    fault = type_fault(field)
    if fault:
        yield fault
    takes_default = field["kind"] in PLAIN or field["kind"] == STRING
    for name in field["annotations"]:
        if name == "key":
            continue  # its values are the instances of a topic
        if name != "default":
            yield f"has @{name}, which would be ignored; allowed are @default and @key"
        elif not takes_default:
            yield "has @default, which only a number, boolean, char, string or enum takes"


def struct_faults(struct, source):
    if "final" not in struct["annotations"]:
        yield source.line(source.at), "must be @final: its fields are sent one after the other"
    for name in struct["annotations"]:
        if name != "final":
            yield source.line(source.at), f"has @{name}, which would be ignored; allowed is @final"
    if source.goes_on_with(":"):
        yield source.line(source.at), "inherits from another; name its fields instead"
    if source.forwards(struct["name"]):
        yield source.line(source.at), "is declared before it is defined; define it once"
    if not struct["members"]:
        yield source.line(source.at), ("has no field; ROS 2 gives such a message one: "
                                       "octet structure_needs_at_least_one_member")
    for field in struct["members"]:
        for fault in field_faults(field):
            yield source.line_of_member(field["name"]), f"field {field['name']} {fault}"


def enum_faults(enum, source):
    for owner in [enum, *enum["members"]]:
        for name in owner["annotations"]:
            yield source.line_of_member(owner["name"]), f"{owner['name']} has @{name}; allowed is none"


def definition_faults(definition, source):
    """(line, fault) of everything in it that is refused."""
    line = source.go_to(definition["name"])
    kind = definition.get("kind")
    if definition["is"] != "type":
        yield line, f"is an {definition['is']}; {DEFINITIONS}"
    elif kind == STRUCT:
        yield from struct_faults(definition, source)
    elif kind == ENUM:
        yield from enum_faults(definition, source)
    elif kind == ALIAS:
        fault = type_fault(definition["content"])
        if fault:
            yield line, fault
    else:
        yield line, f"is {REFUSED.get(kind, 'of an unknown kind')}; {DEFINITIONS}"


def own_definitions(parsed):
    return [one for one in parsed["definitions"]
            if one["own"] and one["is"] not in ("module", "constant")]


def check(path, parsed):
    """Throws IdlError, a line per fault, unless all that `path` declares is of the dialect."""
    source, faults = Source(path), []
    for one in own_definitions(parsed):
        name = "::".join(filter(None, [one["scope"], one["name"]]))
        faults += [f"{path}:{line}: {name} {fault}" for line, fault in definition_faults(one, source)]
    if faults:
        raise IdlError("\n".join(dict.fromkeys(faults)))


def structs(parsed):
    """(module path, name, [field names]) of the file's own structs, in their order."""
    return [(one["scope"].split("::") if one["scope"] else [], one["name"],
             [field["name"] for field in one["members"]])
            for one in own_definitions(parsed) if one["kind"] == STRUCT]
