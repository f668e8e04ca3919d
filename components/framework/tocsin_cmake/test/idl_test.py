# SPDX-License-Identifier: Apache-2.0
"""What generate_idl.py makes of small IDL files, by the fastddsgen that is installed."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

CMAKE = pathlib.Path(__file__).parents[1] / "cmake"
sys.path.insert(0, str(CMAKE))

import cpp_types  # noqa: E402
import describe_idl  # noqa: E402
import idl_dialect  # noqa: E402
import idl_parser  # noqa: E402
import ros_definition  # noqa: E402
import ros_typescript  # noqa: E402
import type_hash  # noqa: E402


class IdlFolder:
    """IDL files in a folder that goes with the test."""

    def __init__(self, files):
        self._folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self._folder.name)
        for name, text in files.items():
            (self.path / f"{name}.idl").write_text(text)

    def __del__(self):
        self._folder.cleanup()

    def idl(self, name):
        return self.path / f"{name}.idl"

    def parse(self, *names):
        return idl_parser.parse("fastddsgen", [self.idl(name) for name in names], [self.path])

    def run(self, *names):
        """The program as CMake calls it: exit code and what it printed."""
        done = subprocess.run([sys.executable, "-B", CMAKE / "generate_idl.py", "--package", "toy",
                               "--out", self.path / "out", *map(self.idl, names)],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def made(self):
        out = self.path / "out"
        return sorted(file.name for file in out.iterdir()) if out.exists() else []


ACCEPTED = {
    "one_line": "module a { module msg { @final struct One { long x; }; }; };",
    "two_names": "@final struct Two {\n  long x, z;\n  @default(1.5) double w;\n};",
    "comments": "/* struct No { long a; }; */\n@final struct Yes {  // { long b; }\n  long c;  /* d */\n};",
    "brace_below": "@final\nstruct Below\n{\n  sequence<long>\n    values;\n  float grid[2][3];\n}\n;",
    "same_name": "module a { @final struct S { long x; }; };\nmodule b { @final struct S { a::S y; }; };",
    "enum": "enum E { E_A, E_B };\ntypedef sequence<E> Es;\n@final struct Uses { E e; Es es; };",
    "key": "@final struct Key {\n  @key string name;\n  @key @default(7) long id;\n  double w;\n};",
    "defaults": "module m { enum C { C_A, C_B };\n@final struct D { @default(7) short n; @default(TRUE) boolean b;"
                '@default("a b") string s; @default(C_B) C c; @default(1.5) float f; long grid[2][3]; }; };',
    "constants": "module m { module n { const uint8 A = 200; const double B = -1.5e3;"
                 'const string C = "x, y"; const boolean D = TRUE; }; };',
    "user": '#include "one_line.idl"\n@final struct User { a::msg::One one; };',
}

# name: (text, line of the fault, what is said)
REFUSED = {
    "optional": ("@final struct S {\n  long a;\n  @optional long b;\n};", 3, "field b has @optional"),
    "map": ("@final struct S {\n\n  map<long, long> m;\n};", 3, "field m is a map; allowed are boolean"),
    "not_final": ("// x\nstruct S { long a; };", 2, "S must be @final"),
    "appendable": ("@appendable struct S { long a; };", 1, "S has @appendable"),
    "base": ("@final struct B { long a; };\n@final struct S : B { long b; };", 2, "S inherits"),
    "forward": ("struct S;\n@final struct S { sequence<S> s; };", 1, "S is declared before"),
    "empty": ("\n@final struct S {};", 2, "S has no field"),
    "bounded": ("@final struct S {\n  sequence<long, 3> l;\n};", 2, "field l is a bounded sequence"),
    "short_text": ("@final struct S {\n  string<5> t;\n};", 2, "field t is a bounded string"),
    "wide": ("@final struct S {\n  wstring w;\n};", 2, "field w is a wide string"),
    "inner": ("@final struct S {\n  sequence<wchar> w;\n};", 2, "field w is a wide character"),
    "long_double": ("@final struct S {\n  long double d;\n};", 2, "field d is a long double"),
    "union": ("module m {\n  union U switch (long) { case 1: long a; };\n};", 2, "m::U is a union"),
    "bitmask": ("bitmask B { flag };", 1, "B is a bitmask"),
    "alias": ("typedef map<long, long> M;", 1, "M is a map"),
    "bits": ("@bit_bound(8) enum E { E_A };", 1, "E has @bit_bound"),
    "constant": ("const long N = 3;\n@final struct S {\n  long l[2][N];\n};", 3, "l is an array of N"),
    "nothing": ("@final struct S {\n  long l[0];\n};", 2, "field l is an array of 0"),
    "default": ("@final struct S {\n  @default(1) sequence<long> l;\n};", 2, "l has @default, which"),
    "interface": ("interface I { void f(); };", 1, "I is an interface; allowed are @final"),
    "exception": ("exception E { long x; };", 1, "E is an exception"),
    "annotation": ("@annotation mark { long v; };\n@final struct S {\n  @mark(v=1) long a;\n};", 3,
                   "field a has @mark"),
    "second": ("@final struct S { long a; };\n@final struct T {\n  wstring a;\n};", 3, "T field a is"),
}

class Accepted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = IdlFolder(ACCEPTED)
        cls.parsed = cls.folder.parse(*ACCEPTED)

    def structs_of(self, name):
        path = self.folder.idl(name)
        idl_dialect.check(path, self.parsed[path])
        return idl_dialect.structs(self.parsed[path])

    def header_of(self, name):
        return cpp_types.header(name, self.parsed[self.folder.idl(name)])

    def test_struct_on_one_line(self):
        self.assertEqual(self.structs_of("one_line"), [(["a", "msg"], "One", ["x"])])

    def test_several_names_of_one_type(self):
        self.assertEqual(self.structs_of("two_names"), [([], "Two", ["x", "z", "w"])])

    def test_fields_of_the_key(self):
        self.assertEqual(self.structs_of("key"), [([], "Key", ["name", "id", "w"])])
        text = self.header_of("key")
        self.assertIn("static constexpr bool has_key = true;", text)
        self.assertRegex(text, r'every_key_field\(Message& message, Visitor&& visit\) \{\n\s+'
                               r'return visit\("name", message.name_\) &&\n\s+visit\("id", message.id_\);')
        self.assertNotIn("every_key_field", self.header_of("two_names"))

    def test_comments_hold_no_fields(self):
        self.assertEqual(self.structs_of("comments"), [([], "Yes", ["c"])])

    def test_fields_over_several_lines(self):
        self.assertEqual(self.structs_of("brace_below"), [([], "Below", ["values", "grid"])])

    def hashes_of(self, name):
        return type_hash.Hashes(self.parsed[self.folder.idl(name)], {})

    def test_same_name_in_two_modules(self):
        self.assertEqual(self.structs_of("same_name"), [(["a"], "S", ["x"]), (["b"], "S", ["y"])])
        text = self.header_of("same_name")
        self.assertIn("::a::S y_{};", text)
        self.assertIn("const TypeInfo& type_info<::a::S>();\ntemplate <>\nconst TypeInfo& type_info<::b::S>();",
                      text)

    def test_what_a_hash_is_made_of_is_described(self):
        source = describe_idl.source("toy", "one_line", self.structs_of("one_line"), [],
                                     self.hashes_of("one_line"))
        self.assertIn('{"x", 6, 0, 0, ""},', source)
        hash_ = self.hashes_of("one_line").of("a::msg::One")
        self.assertIn(f'register_ros_description({{"a/msg/One", "{hash_}", fields_a_msg_One,', source)

    def test_what_ros2_cannot_say_is_not_described(self):
        hashes = self.hashes_of("one_line")
        hashes.of = lambda scoped: ""
        source = describe_idl.source("toy", "one_line", self.structs_of("one_line"), [], hashes)
        self.assertNotIn("register_ros_description", source)

    def test_enums_and_their_aliases(self):
        self.assertEqual(self.structs_of("enum"), [([], "Uses", ["e", "es"])])
        text = self.header_of("enum")
        self.assertIn("enum E : std::uint32_t { E_A, E_B };", text)
        self.assertIn("using Es = std::vector<::E>;", text)
        self.assertIn("::Es es_{};", text)

    def test_fields_begin_with_their_default(self):
        text = self.header_of("defaults")
        for line in ("std::int16_t n_ = 7;", "bool b_ = true;", 'std::string s_ = "a b";',
                     "::m::C c_ = ::m::C::C_B;", "float f_ = 1.5;",
                     "std::array<std::array<std::int32_t, 3>, 2> grid_{};"):
            self.assertIn(f"  {line}\n", text)

    def test_constants_have_their_value(self):
        text = self.header_of("constants")
        for line in ("constexpr std::uint8_t A = 200;", "constexpr double B = -1.5e3;",
                     'inline const std::string C = "x, y";', "constexpr bool D = true;"):
            self.assertIn(f"{line}\n", text)
        self.assertIn("namespace m { namespace n {\nconstexpr std::uint8_t A", text)

    def test_included_structs_are_described_where_they_are_defined(self):
        self.assertEqual(self.structs_of("user"), [([], "User", ["one"])])
        self.assertEqual(self.parsed[self.folder.idl("user")]["includes"], ["one_line"])


DEFINED = """
#include "one_line.idl"
module r { module msg {
  enum E { E_A, E_B };
  typedef sequence<long> Row;
  @final struct Numbers {
    boolean b; octet o; char c; int8 i8; uint8 u8; short i16; unsigned short u16;
    long i32;  // [m] of the road
    unsigned long u32; long long i64; unsigned long long u64; float f32; double f64;
    string s; E e;  ///< which one
  };
  @final struct Lists {
    double covariance[36]; float grid[2][3]; sequence<octet> bytes;
    Row row; sequence<a::msg::One> ones; Numbers pair[2]; a::msg::One one;
  };
  @final struct Nested { sequence<Row> rows; };
}; };
@final struct NoMessage { long x; };
"""


class Defined(unittest.TestCase):
    """What others read of our messages: their definitions in ROS 2's syntax."""

    @classmethod
    def setUpClass(cls):
        cls.folder = IdlFolder({"one_line": ACCEPTED["one_line"], "defined": DEFINED})
        path = cls.folder.idl("defined")
        found = ros_definition.definitions(DEFINED, cls.folder.parse("defined")[path])
        cls.definitions = {name: (text.splitlines(), parts) for name, text, parts in found}

    def test_numbers_have_the_names_of_ros(self):
        lines, parts = self.definitions["r::msg::dds_::Numbers_"]
        self.assertEqual(lines, [
            "bool b", "byte o", "char c", "int8 i8", "uint8 u8", "int16 i16", "uint16 u16",
            "int32 i32  # [m] of the road", "uint32 u32", "int64 i64", "uint64 u64", "float32 f32",
            "float64 f64", "string s", "uint32 e  # which one"])
        self.assertEqual(parts, [])

    def test_lists_and_structs_and_their_parts_each_once(self):
        lines, parts = self.definitions["r::msg::dds_::Lists_"]
        self.assertEqual(lines, ["float64[36] covariance", "float32[6] grid", "byte[] bytes", "int32[] row",
                                 "a/One[] ones", "r/Numbers[2] pair", "a/One one"])
        self.assertEqual(parts, ["a::msg::dds_::One_", "r::msg::dds_::Numbers_"])

    def test_what_ros_cannot_say_has_none(self):
        self.assertEqual(sorted(self.definitions),
                         ["r::msg::dds_::Lists_", "r::msg::dds_::Numbers_"])


class Typed(unittest.TestCase):
    """What pages read of our messages: TypeScript, as decoded from ROS 2's syntax."""

    @classmethod
    def setUpClass(cls):
        folder = IdlFolder({"one_line": ACCEPTED["one_line"], "defined": DEFINED})
        parsed = folder.parse("defined")[folder.idl("defined")]
        cls.text = ros_typescript.file_text("defined", DEFINED, parsed)

    def fields(self, name):
        body = re.search(rf"    interface {name} {{\n(.*?)\n    }}", self.text, re.DOTALL).group(1)
        return re.findall(r"readonly (\w+): (.*);", body)

    def test_numbers_are_numbers_but_for_those_of_64_bits(self):
        other = {"b": "boolean", "i64": "bigint", "u64": "bigint", "s": "string"}
        self.assertEqual(self.fields("Numbers"),
                         [(name, other.get(name, "number")) for name in
                          "b o c i8 u8 i16 u16 i32 u32 i64 u64 f32 f64 s e".split()])

    def test_lists_and_structs_of_other_packages(self):
        self.assertEqual(self.fields("Lists"), [
            ("covariance", "ArrayLike<number>"), ("grid", "ArrayLike<number>"),
            ("bytes", "ArrayLike<number>"), ("row", "ArrayLike<number>"),
            ("ones", "readonly a.One[]"), ("pair", "readonly r.Numbers[]"), ("one", "a.One")])

    def test_a_field_has_the_comment_of_its_line(self):
        self.assertIn("/** [m] of the road */\n      readonly i32: number;", self.text)

    def test_whoever_writes_one_has_its_whole_definition(self):
        schema = json.loads(re.search(r"export const Lists = (.*);", self.text).group(1))
        self.assertEqual(schema["schemaName"], "r/msg/Lists")
        own, *parts = schema["text"].split(ros_typescript.SEPARATOR)
        self.assertEqual(own.splitlines()[-2:], ["r/Numbers[2] pair", "a/One one"])
        self.assertEqual([part.splitlines()[:2] for part in parts],
                         [["MSG: a/One", "int32 x"], ["MSG: r/Numbers", "bool b"]])

    def test_what_ros_cannot_say_is_left_out(self):
        self.assertEqual(re.findall(r"interface (\w+)", self.text), re.findall(r"const (\w+)", self.text))
        self.assertEqual(sorted(re.findall(r"const (\w+)", self.text)), ["Lists", "Numbers"])


class Refused(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = IdlFolder({name: text for name, (text, _, _) in REFUSED.items()})
        cls.parsed = cls.folder.parse(*REFUSED)

    def test_with_file_line_and_reason(self):
        for name, (_, line, said) in REFUSED.items():
            with self.subTest(name):
                path = self.folder.idl(name)
                with self.assertRaises(idl_parser.IdlError) as refusal:
                    idl_dialect.check(path, self.parsed[path])
                lines = str(refusal.exception).splitlines()
                self.assertTrue(any(f"{path}:{line}: " in one and said in one for one in lines),
                                str(refusal.exception))


HASHED = {
    "other": "module o { module msg { @final struct Three { sequence<long> x;  // [bound 3]\n}; }; };",
    "bounded": '#include "other.idl"\nmodule p { module msg {\n@final struct B {\n'
               "  string name;  // [bound 256]\n  sequence<o::msg::Three> all;  // [bound 1] [m]\n"
               "  octet raw[2][3];\n};\n}; };",
    "nested": "@final struct S { sequence<sequence<long> > x; };",
    "wire": "enum E { E_A };\ntypedef E Named;\n@final struct S { Named e; char c; uint8 u; };",
}


class Hashes(unittest.TestCase):
    """RIHS01; that it is what ROS 2 publishes is tested where its types are restated, in ros_idl."""

    @classmethod
    def setUpClass(cls):
        cls.folder = IdlFolder(HASHED)
        cls.parsed = cls.folder.parse(*HASHED)

    def of(self, name):
        idl = self.folder.idl(name)
        includes = [f"{one}.idl" for one in self.parsed[idl]["includes"]]
        return type_hash.Hashes(self.parsed[idl], type_hash.bounds_of(idl, includes, []))

    def fields(self, name, scoped):
        return {one["name"]: list(one["type"].values())
                for one in self.of(name).described(scoped)["fields"]}

    def test_count_the_bounds_that_comments_tell(self):
        self.assertEqual(self.fields("bounded", "p::msg::B"), {
            "name": [21, 0, 256, ""], "all": [97, 1, 0, "o/msg/Three"], "raw": [64, 6, 0, ""]})
        self.assertEqual(self.fields("bounded", "o::msg::Three"), {"x": [102, 3, 0, ""]})

    def test_take_an_enum_for_the_number_that_is_sent(self):
        self.assertEqual(self.fields("wire", "S"),
                         {"e": [7, 0, 0, ""], "c": [13, 0, 0, ""], "u": [3, 0, 0, ""]})

    def test_tell_each_type_that_is_referred_to_once(self):
        hashes = self.of("bounded")
        self.assertEqual(hashes.referenced(hashes.described("p::msg::B")), {"o/msg/Three"})
        self.assertRegex(hashes.of("p::msg::B"), "^RIHS01_[0-9a-f]{64}$")

    def test_are_not_there_for_what_ros_2_cannot_say(self):
        self.assertEqual(self.of("nested").of("S"), "")


class Complaints(unittest.TestCase):
    """What fastddsgen prints; the lines are its own."""

    def test_are_placed_in_their_file(self):
        self.assertEqual(idl_parser.complaints(
            "Loading templates...\nProcessing the file /a/b.idl...\n"
            "\x1b[1m/a/b.idl:2:26: \x1b[0m\x1b[1;31merror: \x1b[0mUnexpected input \x1b[1m'}'\x1b[0m\n"
            "Exception in thread \"main\" java.lang.NullPointerException: Cannot invoke\n"
            "\tat com.eprosima.fastdds.fastddsgen.execute(fastddsgen.java:407)\n"),
            ["/a/b.idl:2: Unexpected input '}'"])

    def test_are_also_what_it_only_warns_of(self):
        self.assertEqual(idl_parser.complaints(
            "Processing the file /a/b.idl...\n"
            "WARNING (File b, Line 17): Annotation unit not supported. Ignoring...\n"),
            ["/a/b.idl:17: Annotation unit not supported"])

    def test_are_also_those_of_the_preprocessor(self):
        self.assertEqual(idl_parser.complaints(
            "Processing the file /a/b.idl...\n"
            "/a/b.idl:1:10: fatal error: no.idl: No such file or directory\n"
            "    1 | #include \"no.idl\"\n      |          ^~~~~~~~\ncompilation terminated.\n"),
            ["/a/b.idl:1: no.idl: No such file or directory"])

    def test_are_also_characters_that_it_leaves_out(self):
        folder = IdlFolder({"a": "// $\n\n@final struct S { long x$; };"})
        self.assertEqual(idl_parser.complaints(
            f"Processing the file {folder.idl('a')}...\nline 9:24 token recognition error at: '$'\n"),
            [f"{folder.idl('a')}:3: '$' is no part of IDL"])

    def test_name_no_java_objects(self):
        self.assertEqual(idl_parser.complaints(
            "a.idl:2:16: error: Illegal identifier: A is already defined "
            "(Definition: com.eprosima.idl.parser.tree.TypeDeclaration@1068e947)"),
            ["a.idl:2: Illegal identifier: A is already defined"])


class Program(unittest.TestCase):
    def test_refuses_what_is_no_idl_without_a_stack_trace(self):
        folder = IdlFolder({"a": "@final struct S {\n  float64 x;\n};"})
        self.assertEqual(folder.run("a"), (
            1, f"{folder.idl('a')}:2: 'float64' was not defined previously; IDL calls it double\n"))
        self.assertEqual(folder.made(), [])

    def test_names_the_faults_of_all_files_and_makes_nothing(self):
        folder = IdlFolder({"a": ACCEPTED["enum"], "b": REFUSED["map"][0], "c": REFUSED["optional"][0]})
        code, printed = folder.run("a", "b", "c")
        self.assertEqual(code, 1)
        self.assertEqual([line.split(":")[0] for line in printed.splitlines()],
                         [str(folder.idl("b")), str(folder.idl("c"))])
        self.assertEqual(folder.made(), [])

    def test_makes_the_same_of_the_same(self):
        folder = IdlFolder({"enum": ACCEPTED["enum"]})
        self.assertEqual(folder.run("enum"), (0, ""))
        self.assertEqual(folder.made(), ["enum.hpp", "enum.ts", "enum_type_info.cpp"])
        files = sorted((folder.path / "out").iterdir())
        before = [(file.stat().st_mtime_ns, file.read_text()) for file in files]
        self.assertEqual(folder.run("enum")[0], 0)
        self.assertEqual([(file.stat().st_mtime_ns, file.read_text()) for file in files], before)

    def test_says_when_there_is_no_generator(self):
        with self.assertRaises(OSError):
            idl_parser.parse("/nowhere/fastddsgen", [pathlib.Path("a.idl")], [])


if __name__ == "__main__":
    unittest.main()
