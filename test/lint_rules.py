#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""House rules that need no compiler; prints file:line: rule, exit code 1 when one is broken."""
import ast
import pathlib
import re
import subprocess
import sys

# How package.xml calls what find_package or pkg-config finds; None is part of every system.
NAMES = {"JPEG": "libjpeg-dev", "libevdev": "libevdev-dev", "liblz4": "liblz4-dev", "libnl-genl-3.0": "libnl-genl-3-dev",
         "libcurl": "libcurl4-openssl-dev", "libmosquitto": "libmosquitto-dev", "libpq": "libpq-dev", "libpcre2-8": "libpcre2-dev", "sqlite3": "libsqlite3-dev", "libzstd": "libzstd-dev", "nlopt_cxx": "libnlopt-cxx-dev", "OpenSSL": "libssl-dev", "tinyxml2": "libtinyxml2-dev", "PkgConfig": None, "Python3": None, "Threads": None, "GTest": None,
         "zlib": "zlib1g-dev"}
# Packages that a LINK list names without `::`.
PLAIN = {"yaml-cpp", "fastdds"}
LONGEST_FUNCTION = 40  # lines; of C++ clang-tidy sees to it
# The first line of a function in TypeScript; describe() of node's test runner holds tests, and does nothing.
TYPESCRIPT_FUNCTION = re.compile(r"^( *)(?!.*\bdescribe\()(?!\}? ?(?:if|for|while|switch|catch|else|do)\b)"
                                 r"(?:.*=> \{|.*\bfunction\b.*\{|(?:[\w#]+ )*[\w#]+(?:<.*>)?\(.*\).*\{)$")
NUMBERS = r"(?:unsigned )?(?:short|long long|long)|octet|float|double|u?int(?:8|16|32|64)"
FIELD = re.compile(rf"^\s*(?:sequence<)?\s*(?:{NUMBERS})\b[^;]*;(.*)$")
# Rooms of packages, the lowest first: a package may depend on its own and on lower ones.
ROOMS = [["idl"], ["framework"], ["libraries"], ["vehicle", "station", "both"], ["simulation"], ["tools"],
         ["examples"]]
ANYWHERE = {"tocsin_cmake"}  # builds all of them
# What is defined once, and where.
ONE_OF_EACH = {r"struct Wall\b(?!;)": "framework/foundation/geometry/include/geometry/wall.hpp",
               r"struct Pose\b(?!;)": "framework/foundation/geometry/include/geometry/pose.hpp",
               r"class Csv(?:Reader|Table)\b(?!;)": "framework/foundation/foundation/include/foundation/csv_table.hpp",
               r'"tocp_reverse",\s*"belief"': "libraries/decision/include/decision/policy_params.hpp"}
NEVER = {r"\bdevices(?:_|\(\))?\s*[=!]=\s*nullptr": "devices are always there; simulated ones are given in simulation",
         r'[=!]=\s*"(?:uxv|gcs|critical|high|low)"|"(?:uxv|gcs|critical|high|low)"\s*[=!]=':
             "compares words; Role and TrafficClass are read by role_of and traffic_class_of"}
broken = []


def tracked(*patterns):
    listed = subprocess.run(["git", "ls-files", *patterns], capture_output=True, text=True)
    return [pathlib.Path(name) for name in listed.stdout.split() if pathlib.Path(name).exists()]


def report(file, line, rule):
    broken.append(f"{file}:{line}: {rule}")


def check_licence():
    for file in tracked("*.cpp", "*.hpp", "*.idl", "*.py", "*.cmake", "*CMakeLists.txt", "*.yaml",
                        "bringup/*", "test/*", ".ci/*"):
        if file.suffix in (".xml", ".md", ".txt", ".service", ".svg", ".png", ".json") and file.name != "CMakeLists.txt" or file.name == "copyright":
            continue
        first = file.read_text(errors="replace").split("\n")[:2]
        wanted = first[1] if first[0].startswith("#!") and len(first) > 1 else first[0]
        if "SPDX-License-Identifier: Apache-2.0" not in wanted:
            report(file, 1, "does not start with its SPDX line")


def check_once():
    for file in tracked("*.hpp"):
        if "#pragma once" not in file.read_text():
            report(file, 1, "has no #pragma once")


def check_fast_dds_version():
    """Which Fast DDS there is, is known in one folder, and to the module of CMake that finds it."""
    homes = ("components/framework/runtime/include/runtime/fast_dds/",
             "components/framework/tocsin_cmake/cmake/Findfastdds.cmake", "test/lint_rules.py")
    version = re.compile(r"eprosima::fastrtps|<fastrtps/|find_package\(fastrtps|FAST(?:DDS|RTPS)_VERSION_|TOCSIN_FAST_DDS"
                         r"|\bgetSerializedSizeProvider\b|\bcalculate_serialized_size\b")
    for file in tracked("*.cpp", "*.hpp", "*.cmake", "*CMakeLists.txt", "*.py"):
        if str(file).startswith(homes):
            continue
        for number, line in enumerate(file.read_text().split("\n"), 1):
            if version.search(line):
                report(file, number, "knows a version of Fast DDS; runtime/fast_dds/ alone does")


def check_failure_rows():
    """A row of a table whose last column is `test` names tests that exist, `Suite.*` for all of one."""
    macro = re.compile(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+), (\w+)\)", re.M)
    tests = {found for file in tracked("*_test.cpp") for found in macro.findall(file.read_text())}
    suites = {suite for suite, _ in tests}
    names = {name for _, name in tests}
    described = re.compile(r"^describe\(\"(\w+)", re.M)
    names |= {name for file in tracked("components/*.test.ts") for name in described.findall(file.read_text())}
    for file in tracked("*.md"):
        in_table = False
        for number, line in enumerate(file.read_text().split("\n"), 1):
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")] if line.startswith("|") else []
            in_table = bool(cells) and (in_table or cells[-1] == "test")
            suite = None
            named = cells[-1] if in_table else ""
            for stated, name in re.findall(r"`([A-Z]\w+)?\.(\w+|\*)`", named):
                suite = stated or suite
                if suite not in suites or name != "*" and (suite, name) not in tests:
                    report(file, number, f"there is no test {suite}.{name}")
            for name in re.findall(r"`([A-Z][a-z]\w+[A-Z]\w+)`", named):
                if name not in suites | names:
                    report(file, number, f"there is no test {name}")


def check_dependencies():
    for cmake in tracked("idl/*CMakeLists.txt", "components/*CMakeLists.txt"):
        xml = cmake.with_name("package.xml")
        if not xml.exists():
            continue  # a part of a package
        text = "\n".join(file.read_text() for file in sorted(cmake.parent.rglob("CMakeLists.txt")))
        found = set(re.findall(r"^find_package\((\S+)", text, re.M))
        # What stands under a condition is no dependency of every build.
        linked = re.sub(r"^ *#.*?$|\$<.*?>|^if\(.*?^endif", "", text, flags=re.M | re.S)
        found |= set(re.findall(r"([\w-]+)::[\w-]", linked)) - {re.search(r"project\(([\w-]+)", text)[1]}
        found |= PLAIN & set(re.split(r"[\s()]+", linked))
        if re.search(r"tocsin_component\(", text):
            found.add("runtime")
        if re.search(r"tocsin_idl_library\(", text):
            found.add("idl_support")
        found |= set(re.findall(r"pkg_check_modules\(\w+ REQUIRED(?: IMPORTED_TARGET)? ([^\s)]+)", text))
        found = {NAMES.get(name, name) for name in found} - {None}
        stated = set(re.findall(r"<(?!test_)\w*depend>(\S+)</", xml.read_text()))
        for_tests = set(re.findall(r"<test_depend>(\S+)</", xml.read_text()))
        for name in sorted((found - for_tests) ^ (stated - for_tests)):
            where = "CMakeLists.txt" if name in found else "package.xml"
            report(xml, 1, f"{name} is only in {where}")


def check_demo():
    """bringup/build demo builds what bringup/package.xml names."""
    xml = pathlib.Path("bringup/package.xml")
    there = {file.parent.name for file in tracked("components/*package.xml")}
    for name in sorted(set(re.findall(r"<exec_depend>(\S+)</", xml.read_text())) - there):
        report(xml, 1, f"there is no package {name}")


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.lineno, node.end_lineno


def typescript_functions(text):
    """By the indentation: the first line that closes what this one opens."""
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        head = TYPESCRIPT_FUNCTION.match(line)
        if head:
            yield number, next((end for end in range(number + 1, len(lines) + 1)
                                if lines[end - 1].startswith(head[1] + "}")), number)


def check_function_size():
    python = [file for file in tracked("*.py", "test/*", "bringup/*")
              if file.suffix == ".py" or file.read_bytes()[:30].startswith(b"#!/usr/bin/env python3")]
    kinds = [(python_functions, python), (typescript_functions, tracked("components/*.ts", "components/*.tsx", "components/*.mjs"))]
    for functions, files in kinds:
        for file in files:
            for first, last in functions(file.read_text()):
                if last - first + 1 > LONGEST_FUNCTION:
                    report(file, first, f"a function of {last - first + 1} lines; {LONGEST_FUNCTION} are allowed")


def check_rooms():
    rank = {name: number for number, names in enumerate(ROOMS) for name in names}
    files = tracked("idl/*/package.xml", "components/*/package.xml")
    room_of = {xml.parent.name: xml.parts[0] if xml.parts[0] == "idl" else xml.parts[1] for xml in files}
    for xml in files:
        own = room_of[xml.parent.name]
        if own not in rank:
            report(xml, 1, f"lies in no room; rooms are {sum(ROOMS, [])}")
            continue
        stated = re.findall(r"<\w*depend>(\S+)</", xml.read_text())
        for name in sorted(set(stated) & room_of.keys() - ANYWHERE):
            upward = rank[room_of[name]] > rank[own]
            beside = rank[room_of[name]] == rank[own] and own in ROOMS[3]
            if upward or beside:
                report(xml, 1, f"{own} may not depend on {name} of {room_of[name]}")


def check_one_of_each():
    for file in tracked("components/*.cpp", "components/*.hpp", "idl/*.cpp", "idl/*.hpp"):
        if "/test/" in str(file):
            continue
        text = file.read_text()
        found = {pattern: f"is defined in {home}" for pattern, home in ONE_OF_EACH.items()
                 if str(file) != f"components/{home}"} | NEVER
        for pattern, rule in found.items():
            for match in re.finditer(pattern, text):
                report(file, text.count("\n", 0, match.start()) + 1, f"'{match[0]}' {rule}")


def check_units():
    for file in tracked("idl/tocsin_idl/*.idl", "components/examples/*.idl"):
        for number, line in enumerate(file.read_text().split("\n"), 1):
            field = FIELD.match(line)
            if field and not re.search(r"//.*\[[^\]]+\]", field.group(1)):
                report(file, number, "a number without its [unit]")


def check_versions():
    stated = {}
    for xml in tracked("*package.xml"):
        stated[xml] = re.search(r"<version>(.*)</version>", xml.read_text()).group(1)
    newest = re.search(r"^## (\S+)", pathlib.Path("CHANGELOG.md").read_text(), re.M).group(1)
    for xml, version in stated.items():
        if version != newest:
            report(xml, 1, f"version {version} is not {newest}, the newest of CHANGELOG.md")


def check_yaml():
    for file in tracked("components/*/src/*.cpp", "components/*/include/*.hpp"):
        for number, line in enumerate(file.read_text().split("\n"), 1):
            if "YAML::Load" in line and file.name != "yaml_sources.cpp":
                report(file, number, "reads YAML without limits; use foundation's yaml_sources.hpp")

# Private words of the past; the field's are in STYLE.md's table.
NOT_OURS = (r"\bfill(?:s|ed)?[ -]in\b|\bgiven (?:to (?:its|the) host|twice|on)\b|\b(?:next|former) life\b|\blives of\b|\btells?\b|\btold\b"
            r"|\b(?:came|crossed)\b|\breceipts?\b|\bother makers?\b|\blone keys?\b|\b(?:tak\w+|took|g[ai]ves?|has) the (?:wheel|seat)\b"
            r"|\bhea(?:rd?|rs)\b|\bclose[sd]? the gate\b|\bgate (?:is closed|closes)\b|\bwanted\b|\bends of\b|\bissues? \d+")
FIGURES = "test/bench/figures/"
PROSE_WORDS, SENTENCE_WORDS = 250, 40


def prose_of(text):
    """Markdown without code, tables, headings, link targets and what is printed between markers."""
    text = re.sub(r"<!-- begin.*?<!-- end.*?-->", "", text, flags=re.S)
    text = re.sub(r"^ *```.*?^ *```", "", text, flags=re.S | re.M)
    text = re.sub(r"^(?: {4,}\S| *\||#).*$", "", text, flags=re.M)
    return re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"`[^`]*`", "CODE", text))


def words_of(file):
    """Of a page: words that are not the field's, prose words beyond the limit, long sentences."""
    text = file.read_text()
    shown = re.sub(r"^ *```.*?^ *```|`[^`]*`|\]\([^)]*\)", "", text, flags=re.S | re.M)
    prose = prose_of(text)
    foreign = [match[0] for match in re.finditer(NOT_OURS, shown, re.I)]
    sentences = re.split(r"(?<=[.!?:;])\s+(?=[A-Z`*\[])|\n\s*\n|\n\s*(?:[-*]|\d+\.) ", prose)
    long = [sentence for sentence in sentences if len(sentence.split()) > SENTENCE_WORDS]
    counted = str(file).startswith("components/") and file.name == "README.md" and file.parts[1] != "examples"
    return foreign, max(0, len(prose.split()) - PROSE_WORDS) if counted else 0, long


def broken_links(file):
    """Links of a page to files and headings that are not there."""
    text = re.sub(r"^ *```.*?^ *```", "", file.read_text(), flags=re.S | re.M)
    for target, anchor in re.findall(r"\]\((?!https?:)([^)#\s]*)#?([^)\s]*)\)", text):
        path = file.parent / target if target else file
        headings = re.findall(r"^#+ (.*)$", path.read_text(), re.M) if anchor and path.is_file() else []
        known = {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}
        if not path.exists() or anchor and path.suffix == ".md" and anchor not in known:
            yield target + ("#" + anchor if anchor else "")


def warn_of_words():
    """What lint --words prints; breaks nothing."""
    for file in tracked("*.md"):
        for link in broken_links(file):
            print(f"{file}: no such link {link}")
        if str(file).startswith(FIGURES):
            continue
        foreign, above, long = words_of(file)
        if foreign or above or long:
            print(f"{file}: {len(foreign)} foreign words {sorted(set(word.lower() for word in foreign))[:6]}, "
                  f"{above} words above {PROSE_WORDS}, {len(long)} long sentences")


if sys.argv[1:] == ["--words"]:
    warn_of_words()
    sys.exit(0)
check_licence()
check_versions()
check_once()
check_fast_dds_version()
check_failure_rows()
check_dependencies()
check_demo()
check_function_size()
check_rooms()
check_one_of_each()
check_units()
check_yaml()
print("\n".join(broken) or "house rules: kept")
sys.exit(1 if broken else 0)
