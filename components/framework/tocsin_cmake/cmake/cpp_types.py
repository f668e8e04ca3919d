# SPDX-License-Identifier: Apache-2.0
"""The types of an IDL file in C++: <stem>.hpp.

A struct becomes a class with the accessors of the C++ mapping that fastddsgen has: `x()` and `x(value)`. Its fields in
order, and those of its key, are given to any visitor: coding, showing and editing them is idl_support/cdr_type.hpp's.
"""
import pathlib

from idl_dialect import ALIAS, ARRAY, ENUM, SEQUENCE, STRING, STRUCT, own_definitions

NUMBERS = {1: "std::int16_t", 2: "std::int32_t", 3: "std::uint16_t", 4: "std::uint32_t", 5: "float", 6: "double",
           7: "bool", 8: "char", 9: "std::uint8_t", 17: "std::int64_t", 18: "std::uint64_t", 29: "std::int8_t",
           30: "std::uint8_t"}


def array_text(dimensions, content):
    for size in reversed(dimensions):
        content = f"std::array<{content}, {size}>"
    return content


def type_text(type_):
    """`std::vector<::geometry_msgs::msg::Pose>`."""
    kind = type_["kind"]
    if kind == SEQUENCE:
        return f"std::vector<{type_text(type_['content'])}>"
    if kind == ARRAY:
        return array_text(type_["dimensions"], type_text(type_["content"]))
    if kind == STRING:
        return "std::string"
    named = {STRUCT: "struct", ENUM: "enum", ALIAS: "alias"}.get(kind)
    return "::" + type_[named] if named else NUMBERS[kind]


def is_small(type_):
    """Whether it goes by value."""
    if type_["kind"] == ALIAS:
        return is_small(type_["content"])
    return type_["kind"] in NUMBERS or type_["kind"] == ENUM


def start_text(field):
    """What follows its name where it is declared."""
    value = field.get("default")
    if value is None:
        return "{}"
    if field["kind"] == ENUM and "::" not in value:
        value = f"::{field['enum']}::{value}"
    return f" = {value}"


def accessors(field):
    name, type_ = field["name"], type_text(field)
    if is_small(field):
        return (f"  {type_} {name}() const {{ return {name}_; }}\n"
                f"  {type_}& {name}() {{ return {name}_; }}\n"
                f"  void {name}({type_} value) {{ {name}_ = value; }}\n")
    return (f"  const {type_}& {name}() const {{ return {name}_; }}\n"
            f"  {type_}& {name}() {{ return {name}_; }}\n"
            f"  void {name}(const {type_}& value) {{ {name}_ = value; }}\n"
            f"  void {name}({type_}&& value) {{ {name}_ = std::move(value); }}\n")


def visiting(function, fields):
    calls = " &&\n           ".join(f'visit("{field["name"]}", message.{field["name"]}_)' for field in fields)
    return ("  template <class Message, class Visitor>\n"
            f"  static bool {function}(Message& message, Visitor&& visit) {{\n    return {calls};\n  }}\n")


def class_text(struct):
    name, fields = struct["name"], struct["members"]
    keys = [field for field in fields if "key" in field["annotations"]]
    equal = " &&\n           ".join(f"one.{field['name']}_ == other.{field['name']}_" for field in fields)
    text = f"class {name} {{\n public:\n" + "".join(map(accessors, fields))
    text += "  /// Calls visit(name, field) of each field, in order, until it gives false.\n"
    text += visiting("every_field", fields)
    text += f"  static constexpr bool has_key = {'true' if keys else 'false'};\n"
    text += visiting("every_key_field", keys) if keys else ""
    text += (f"  friend bool operator==(const {name}& one, const {name}& other) {{\n    return {equal};\n  }}\n"
             f"  friend bool operator!=(const {name}& one, const {name}& other) {{ return !(one == other); }}\n"
             "\n private:\n")
    text += "".join(f"  {type_text(field)} {field['name']}_{start_text(field)};\n" for field in fields)
    return text + "};\n"


def constant_text(constant):
    value, kind = constant["value"], constant["kind"]
    if kind == STRING:
        return f"inline const std::string {constant['name']} = {value};\n"
    return f"constexpr {type_text(constant)} {constant['name']} = {value};\n"


def definition_text(one):
    if one["is"] == "constant":
        return constant_text(one)
    if one["kind"] == STRUCT:
        return class_text(one)
    if one["kind"] == ENUM:
        names = ", ".join(member["name"] for member in one["members"])
        return f"enum {one['name']} : std::uint32_t {{ {names} }};\n"
    return f"using {one['name']} = {type_text(one['content'])};\n"


def in_namespace(scope, text):
    name = scope.replace("::", " { namespace ")
    return f"namespace {name} {{\n{text}{'}' * (scope.count('::') + 1)}  // namespace {scope}\n" if scope else text


def header(stem, parsed):
    """The text of <stem>.hpp."""
    includes = "".join(f'#include "{pathlib.PurePath(name).name}.hpp"\n' for name in parsed["includes"])
    own = [one for one in parsed["definitions"] if one["own"] and one["is"] in ("type", "constant")]
    types = "\n".join(in_namespace(one["scope"], definition_text(one)) for one in own)
    infos = "".join(f"template <>\nconst TypeInfo& type_info<{type_text(one)}>();\n"
                    for one in own_definitions(parsed) if one["kind"] == STRUCT)
    return (f"// Generated from {stem}.idl.\n#pragma once\n\n#include <array>\n#include <cstdint>\n"
            "#include <string>\n#include <utility>\n#include <vector>\n\n"
            f'#include "idl_support/type_info.hpp"\n{includes}\n{types}\n'
            f"namespace tocsin {{\n{infos}}}  // namespace tocsin\n")
