# SPDX-License-Identifier: Apache-2.0
"""Names that sources of one target keep to themselves and that clash when they are compiled as one.

The sanitizer trees do that (CMAKE_UNITY_BUILD), and would tell it minutes later. No compiler: it
reads what stands in unnamed namespaces, and static functions, at namespace scope.

>>> def of(**texts): return clashes({name + ".cpp": "namespace a {namespace {" + text + "}}" for name, text in texts.items()})
>>> of(x="constexpr int most = 3;", y="int f();\\nconst double most{2};")
[('y.cpp', 2, 'most', 'x.cpp')]
>>> of(x="struct Line { int a; };", y="enum class Line { in, out };")
[('y.cpp', 1, 'Line', 'x.cpp')]
>>> of(x="int f(const A& a, B b = {}) { return 1; }", y="double f(const A& other, B) { return 2; }")
[('y.cpp', 1, 'f', 'x.cpp')]

>>> of(x="int f(A a) { return 1; }", y="int f(B b) { return 1; } int g(C c) { return each(c, f, 1); }")
[('y.cpp', 1, 'f', 'x.cpp')]

Other overloads live together, and so do members, declarations, equal aliases and other namespaces:

>>> of(x="int f(const A& a) { return 1; }", y="int f(const B& a) { return 1; }")
[]
>>> of(x="struct S { int line = 1; }; int S::f() { int most = 1; }", y="struct T { int line = 1; }; int T::f() { int most = 1; }")
[]
>>> of(x="int f(int); using N = int; namespace fs = std;", y="int f(int); using N = int; namespace fs = std;")
[]
>>> of(x="using Name = int;", y="using Name = long;")
[('y.cpp', 1, 'Name', 'x.cpp')]
>>> of(x="namespace type = codes;", y="int type() { return 1; }")
[('y.cpp', 1, 'type', 'x.cpp')]
>>> clashes({"x.cpp": "namespace a {namespace {int n = 1;}}", "y.cpp": "namespace b {namespace {int n = 1;}}"})
[]
>>> clashes({"x.cpp": "namespace a {int n(){}}", "y.cpp": "namespace a {int n(){} /* int m; */}"})
[]
>>> clashes({"x.cpp": "static int n(){}", "y.cpp": "static int n() {}"})
[('y.cpp', 1, 'n', 'x.cpp')]
>>> of(x='const char* a = "}"; int b = 1;', y="int c = 1'000; int b = 2;")
[('y.cpp', 1, 'b', 'x.cpp')]

A type that a header of the package defines is there for all of them:

>>> def beside(header, text): return clashes({"x.cpp": "namespace a {namespace {" + text + "}}"}, {"h.hpp": "namespace a {" + header + "}"})
>>> beside("struct Line { int a; };", "struct Line { int b; };")
[('x.cpp', 1, 'Line', 'h.hpp')]
>>> beside("enum class Line { in, out };", "const int Line = 1;")
[('x.cpp', 1, 'Line', 'h.hpp')]
>>> beside("struct Line; struct Text { struct Word {}; };", "struct Line {}; struct Word {};")
[]
"""
import re

# What may hold braces or names without meaning them. A quote between digits separates them.
IGNORED = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\''
                     r"|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
OPENS_NAMESPACE = re.compile(r"^(?:inline )?namespace\b\s*([\w:]*)$")
TYPE = re.compile(r"^(?:template\s*<.*?>\s*)?(?:struct|class|union|enum(?:\s+class)?)\s+(\w+)\s*(?:final\s*)?(?::[^:].*)?$",
                  re.S)
FUNCTION = re.compile(r"^[^=(]*?(?<![\w:~])(\w+)\s*\(")
VARIABLE = re.compile(r"(\w+)\s*(?:\[[^\]]*\]\s*)*$")
PARAMETER_NAME = re.compile(r"(?<=[\w>&*\]\s])(?<!const)[\s&*]\w+$")


def blanked(text):
    """The text without comments, literals and directives; lines stay where they are."""
    return IGNORED.sub(lambda found: '""' * (found.group(0)[0] in "R\"'") + "\n" * found.group(0).count("\n"), text)


def parameters(text):
    """The types between the parentheses that `text` begins with, without names and defaults."""
    parts, depth, part = [], 0, ""
    for letter in text:
        depth += (letter in "(<{[") - (letter in ")>}]")
        if depth == 0:
            break
        if letter == "," and depth == 1:
            parts, part = parts + [part], ""
        elif depth > 1 or letter != "(":
            part += letter
    types = []
    for one in parts + [part]:
        one = re.sub(r"\s+", " ", one.split("=")[0]).strip()
        kept = re.match(r"[\s&*]*", PARAMETER_NAME.search(one).group(0)).group(0) if PARAMETER_NAME.search(one) else ""
        types.append(re.sub(r"\s*([&*])\s*", r"\1", PARAMETER_NAME.sub("", one) + kept).strip())
    return tuple(types)


def described(head, body):
    """(name, what it is) of a declaration that defines something, else None. Two of one name live
    together when both are functions of different parameters, or aliases of the same."""
    head = re.sub(r"\s+", " ", head).strip()
    head = re.sub(r"^(?:\[\[\w+\]\] ?)+", "", head)
    alias = re.match(r"(?:using|namespace) (\w+) = ", head)
    if alias:
        return alias.group(1), ("alias", head)
    if not head or re.match(r"(?:using|namespace|friend|extern|typedef|static_assert|template ?<[^{]*> ?;)\b", head):
        return None
    kind = TYPE.match(head)
    if kind:
        return (kind.group(1), ("type", object())) if body else None
    function = FUNCTION.match(head)
    if function and "operator" not in head and body:
        return function.group(1), ("function", parameters(head[function.end() - 1:]))
    if function and not re.match(r"(?:static |inline )*(?:const|constexpr|thread_local|std::atomic)\b", head):
        return None  # a declaration of a function, or a member's definition
    name = VARIABLE.search(head.split("=")[0].split("(")[0])
    if not name or "::" + name.group(1) in head.split("=")[0] or "(" in head.split("=")[0] and body:
        return None
    return name.group(1), ("variable", object())


def names_in(text, is_header=False):
    """(namespace, name, what it is, line) of all that no other source should see; of a header, of
    all that it defines."""
    text = blanked(text)
    spaces, head, begin, at = [], "", 0, 0
    while at < len(text):
        letter = text[at]
        opened = OPENS_NAMESPACE.match(re.sub(r"\s+", " ", head).strip()) if letter == "{" else None
        is_initializer = False
        if opened:
            spaces.append(opened.group(1))
            head = ""
        elif letter == "{":
            end, depth = at, 0
            while end < len(text):
                depth += (text[end] == "{") - (text[end] == "}")
                end += 1
                if depth == 0:
                    break
            after = text[end:].lstrip()[:1]
            is_initializer = "(" not in head.split("=")[0] and not TYPE.match(re.sub(r"\s+", " ", head).strip())
            at = end - 1
        if (letter == "{" and not opened) or letter == ";":
            counts = is_header or "" in spaces or re.match(r"\s*static\b", head)
            found = described(head, letter == "{" and not is_initializer) if counts else None
            if found:
                line = text.count("\n", 0, begin) + 1
                yield "::".join(space for space in spaces if space), found[0], found[1], line
            if letter == "{" and after == ";":
                at = text.index(";", at)
            head = ""
        elif letter == "}":
            if spaces:
                spaces.pop()
            head = ""
        elif not opened:
            if not head.strip():
                begin = at
            head += letter
        at += 1


def is_passed_on(name, text):
    """Whether a function is an argument: which of its overloads is meant cannot be told then."""
    return re.search(rf"[(,]\s*{name}\s*[,)]", blanked(text)) is not None


def clashes(sources, headers={}):
    """(file, line, name, other file) of each name that clashes; `sources` are the texts of one target by file,
    `headers` those that they include."""
    known, found = {}, []
    for file, text in headers.items():
        for space, name, what, _ in names_in(text, is_header=True):
            if what[0] == "type":
                known.setdefault((space, name), []).append((file, what))
    texts = {**headers, **sources}
    for file, text in sources.items():
        for space, name, what, line in names_in(text):
            for other, its in known.get((space, name), []):
                overloads = its[0] == what[0] == "function" and its[1] != what[1]
                if other == file or (overloads and not any(is_passed_on(name, texts[one]) for one in (file, other))):
                    continue
                if its[0] == what[0] == "alias" and its[1] == what[1]:
                    continue
                found.append((file, line, name, other))
                break
            known.setdefault((space, name), []).append((file, what))
    return found
