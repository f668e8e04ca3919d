# SPDX-License-Identifier: Apache-2.0
"""The TypeInfo of every struct of an IDL file: <stem>.hpp and <stem>_type_info.cpp.

`types` is what idl_dialect.structs() gives, `keys` what its keys() gives, `definitions` what
ros_definition.definitions() gives, `hashes` tells each one's RIHS01 and what it is made of.
"""


def scoped(scope, name):
    return "_".join(scope + [name])


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


def edit_function(scope, name, fields):
    body = "".join(f'  cdr::edit_value(e, "{field}", m.{field}());\n' for field in fields)
    return f"void edit_fields(FieldEditor& e, {'::'.join(scope + [name])}& m) {{\n{body}}}\n"


def skip_function(scope, name, fields):
    body = " &&\n         ".join(
        f"cdr::skip_field<decltype(std::declval<const M&>().{field}())>(c)" for field in fields)
    return (f"bool skip_{scoped(scope, name)}(WireCursor& c) {{\n"
            f"  using M = {'::'.join(scope + [name])};\n  return {body};\n}}\n")


def key_template(qualified, fields):
    skip = " &&\n           ".join(
        f"cdr::skip_field<decltype(std::declval<const M&>().{field}())>(c)" for field in fields)
    read = "".join(f"    cdr::read_value(d, m.{field}());\n" for field in fields)
    return (f"template <>\nstruct cdr::Key<{qualified}> {{\n  using M = {qualified};\n"
            f"  static bool skip(WireCursor& c) {{\n    return {skip};\n  }}\n"
            f"  static void read(eprosima::fastcdr::Cdr& d, M& m) {{\n{read}  }}\n}};\n")


def definition_call(name, text, parts):
    listed = ", ".join(f'"{part}"' for part in parts)
    return f'  register_definition({{"{name}", R"ros2msg({text})ros2msg", {{{listed}}}}});\n'


def description_table(name, description):
    """The fields of a type as RosField of idl_support/ros_description.hpp."""
    rows = "".join(
        '    {{"{}", {type_id}, {capacity}, {string_capacity}, "{nested_type_name}"}},\n'.format(
            field["name"], **field["type"]) for field in description["fields"])
    return f"const RosField fields_{name}[] = {{\n{rows}}};\n"


def description_call(name, hash_, description):
    return (f'  register_ros_description({{"{description["type_name"]}", "{hash_}", fields_{name},\n'
            f'                            {len(description["fields"])}}});\n')


def descriptions(types, hashes):
    """(tables, calls) of those types that ROS 2 can say."""
    tables, calls = [], []
    for scope, name, _ in types:
        hash_ = hashes.of("::".join(scope + [name]))
        if hash_:
            description = hashes.described("::".join(scope + [name]))
            tables.append(description_table(scoped(scope, name), description))
            calls.append(description_call(scoped(scope, name), hash_, description))
    return tables, calls


def source(package, stem, types, keys, definitions, hashes):
    text = [f'// Generated from {stem}.idl.\n#include "{package}/{stem}.hpp"\n\n']
    text.append('#include <utility>\n\n#include "idl_support/cdr_type.hpp"\n')
    text.append('#include "idl_support/ros_description.hpp"\n')
    text.append('#include "idl_support/type_definition.hpp"\n')
    text.append('#include "idl_support/type_registry.hpp"\n\n')
    text.append("namespace tocsin {\n")
    text += [key_template(*one) for one in keys.items()]
    text.append("namespace {\n")
    text += [visit_function(*item) + edit_function(*item) + skip_function(*item) for item in types]
    text.append("}  // namespace\n")
    for scope, name, _ in types:
        qualified = "::".join(scope + [name])
        wire = "::".join(scope + ["dds_", name + "_"])
        text.append(f"template <>\nconst TypeInfo& type_info<{qualified}>() {{\n"
                    f'  static const TypeInfo info = cdr::make_type_info<{qualified}>(\n'
                    f'      "{wire}", [](const void* m, FieldVisitor& v) {{\n'
                    f"        visit_fields(v, *static_cast<const {qualified}*>(m));\n      }},\n"
                    f"      [](void* m, FieldEditor& e) {{\n"
                    f"        edit_fields(e, *static_cast<{qualified}*>(m));\n      }},\n"
                    f'      skip_{scoped(scope, name)}, "{hashes.of(qualified)}");\n'
                    "  return info;\n}\n")
    tables, calls = descriptions(types, hashes)
    text += ["namespace {\n", *tables, f"const bool registered_{stem} = [] {{\n"]
    text += [f"  register_type(type_info<{'::'.join(scope + [name])}>());\n"
             for scope, name, _ in types]
    text += [definition_call(*one) for one in definitions] + calls
    text.append("  return true;\n}();\n}  // namespace\n}  // namespace tocsin\n")
    return "".join(text)
