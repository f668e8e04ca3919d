# SPDX-License-Identifier: Apache-2.0
"""The TypeInfo of every struct of an IDL file: <stem>_type_info.cpp.

`types` is what idl_dialect.structs() gives, `definitions` what ros_definition.definitions() gives,
`hashes` tells each one's RIHS01 and what it is made of.
"""


def scoped(scope, name):
    return "_".join(scope + [name])


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


def source(package, stem, types, definitions, hashes):
    text = [f'// Generated from {stem}.idl.\n#include "{package}/{stem}.hpp"\n\n']
    text.append('#include "idl_support/cdr_type.hpp"\n')
    text.append('#include "idl_support/ros_description.hpp"\n')
    text.append('#include "idl_support/type_definition.hpp"\n')
    text.append('#include "idl_support/type_registry.hpp"\n\n')
    text.append("namespace tocsin {\n")
    for scope, name, _ in types:
        qualified = "::".join(scope + [name])
        wire = "::".join(scope + ["dds_", name + "_"])
        text.append(f"template <>\nconst TypeInfo& type_info<{qualified}>() {{\n"
                    f"  static const TypeInfo info = cdr::make_type_info<{qualified}>(\n"
                    f'      "{wire}", "{hashes.of(qualified)}");\n'
                    "  return info;\n}\n")
    tables, calls = descriptions(types, hashes)
    text += ["namespace {\n", *tables, f"const bool registered_{stem} = [] {{\n"]
    text += [f"  register_type(type_info<{'::'.join(scope + [name])}>());\n"
             for scope, name, _ in types]
    text += [definition_call(*one) for one in definitions] + calls
    text.append("  return true;\n}();\n}  // namespace\n}  // namespace tocsin\n")
    return "".join(text)
