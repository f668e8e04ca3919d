// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "dialect/dialect.hpp"
#include "idl_support/encode.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using Bytes = std::vector<std::uint8_t>;

/// What a message shows, a word per event: `x=1`, `list[2`, `]`.
class Shown : public FieldVisitor {
 public:
  std::vector<std::string> words;
  void number(const char* name, double value) override { add(name, std::to_string(value)); }
  void integer(const char* name, std::int64_t value) override { add(name, std::to_string(value)); }
  void text(const char* name, const std::string& value) override { add(name, "'" + value + "'"); }
  void bytes(const char* name, const std::uint8_t*, std::size_t size) override {
    add(name, std::to_string(size) + " bytes");
  }
  void begin_struct(const char* name) override { words.push_back(std::string(name) + "{"); }
  void end_struct() override { words.emplace_back("}"); }
  void begin_list(const char* name, std::size_t size) override {
    words.push_back(std::string(name) + "[" + std::to_string(size));
  }
  void end_list() override { words.emplace_back("]"); }

 private:
  void add(const char* name, const std::string& value) {
    words.push_back(std::string(name) + "=" + value);
  }
};

template <class T>
std::vector<std::string> shown(const T& message) {
  Shown visitor;
  type_info<T>().visit(&message, visitor);
  return visitor.words;
}

template <class T>
Bytes encode(const T& message) {
  return tocsin::encode(type_info<T>(), &message);
}

/// Whether the bytes decode to a message that is equal, and none of their beginnings decodes.
template <class T>
void expect_round_trip(const T& message) {
  const Bytes bytes = encode(message);
  T got;
  ASSERT_TRUE(type_info<T>().deserialize(bytes.data(), bytes.size(), &got));
  EXPECT_EQ(got, message);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(type_info<T>().deserialize(bytes.data(), size, &got)) << size;
  }
}

TEST(EveryType, SendsEachNameOfOneDeclaration) {
  dialect::msg::Pair sut;
  sut.x(1);
  sut.z(2);
  EXPECT_EQ(encode(sut), (Bytes{0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}));
  EXPECT_THAT(shown(sut), ElementsAre("x=1", "z=2"));
}

TEST(EveryType, HonoursDefaults) {
  EXPECT_THAT(shown(dialect::msg::Defaults()),
              ElementsAre("number=7", "flag=1", "text='abc'", "colour=1", "share=1.500000"));
}

TEST(EveryType, SendsAndShowsNumbers) {
  dialect::msg::Numbers sut;
  sut.i8(-8);
  sut.u8(200);
  sut.i16(-16);
  sut.u64(1);
  sut.i64_too(-64);
  sut.f64(0.5);
  expect_round_trip(sut);
  EXPECT_THAT(shown(sut), ElementsAre("b=0", "o=0", "c=0", "i8=-8", "u8=200", "i16=-16", "u16=0",
                                      "i32=0", "u32=0", "i64=0", "u64=1", "i64_too=-64",
                                      "f32=0.000000", "f64=0.500000"));
}

TEST(EveryType, SendsAndShowsLists) {
  dialect::msg::Lists sut;
  sut.bytes({1, 2});
  sut.flags({true, false});
  sut.texts({"a"});
  sut.colours({dialect::msg::COLOUR_GREEN});
  sut.pairs().resize(1);
  sut.row({3});
  sut.rows({{4}, {}});
  sut.nested({{0.5F}});
  sut.poses({{1, 2, 3}});
  sut.grid({{{1, 2, 3}, {4, 5, 6}}});
  expect_round_trip(sut);
  EXPECT_THAT(
      shown(sut),
      ElementsAre("bytes=2 bytes", "flags[2", "flags=1", "flags=0", "]", "texts[1", "texts='a'",
                  "]", "colours[1", "colours=1", "]", "pairs[1", "pairs{", "x=0", "z=0", "}", "]",
                  "row[1", "row=3", "]", "rows[2", "rows[1", "rows=4", "]", "rows[0", "]", "]",
                  "nested[1", "nested[1", "nested=0.500000", "]", "]", "poses[1", "poses[3",
                  "poses=1.000000", "poses=2.000000", "poses=3.000000", "]", "]", "grid[2",
                  "grid[3", "grid=1", "grid=2", "grid=3", "]", "grid[3", "grid=4", "grid=5",
                  "grid=6", "]", "]", "both[2", "both{", "x=0", "z=0", "}", "both{", "x=0", "z=0",
                  "}", "]", "two[2", "two=0", "two=0", "]"));
}

TEST(EveryType, HoldsStructsOfOtherFilesAndModules) {
  dialect::msg::Outer sut;
  sut.header().frame_id("map");
  sut.pair().z(2);
  expect_round_trip(sut);
  EXPECT_STREQ(type_info<dialect::msg::Pair>().name, "dialect::msg::dds_::Pair_");
  EXPECT_STREQ(type_info<other::msg::Pair>().name, "other::msg::dds_::Pair_");
  EXPECT_THAT(shown(other::msg::Pair()), ElementsAre("inner{", "x=0", "z=0", "}"));
}

/// Gives each field another value and each sequence two elements, and notes what it is asked.
class Numbering : public FieldEditor {
 public:
  void number(const char*, double& value) override { value = ++count_; }
  void integer(const char* name, std::int64_t& value, const IntegerRange& range) override {
    ranges[name] = {range.least, range.most};
    value = ++count_ % 2;  // what an enum, too, can hold
  }
  void boolean(const char*, bool& value) override { value = true; }
  void text(const char*, std::string& value) override { value = std::to_string(++count_); }
  void bytes(const char*, std::vector<std::uint8_t>& value) override { value = {1, 2, 3}; }
  void begin_struct(const char*) override { ++depth; }
  void end_struct() override { --depth; }
  std::size_t begin_list(const char*, std::size_t size) override {
    ++depth;
    return size == 0 ? 2 : size;
  }
  void end_list() override { --depth; }
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> ranges;
  int depth = 0;

 private:
  int count_ = 0;
};

TEST(EveryType, GivesEachFieldToAnEditorWithWhatItCanHold) {
  dialect::msg::Numbers sut;
  Numbering editor;
  type_info<dialect::msg::Numbers>().edit(&sut, editor);
  EXPECT_TRUE(sut.b());
  EXPECT_EQ(sut.f64(), sut.f32() + 1);
  EXPECT_EQ(editor.ranges.at("i8"), std::make_pair(std::int64_t{-128}, std::int64_t{127}));
  EXPECT_EQ(editor.ranges.at("u16"), std::make_pair(std::int64_t{0}, std::int64_t{65535}));
  EXPECT_EQ(editor.ranges.at("u64").first, 0);
  EXPECT_EQ(editor.ranges.at("i64").first, std::numeric_limits<std::int64_t>::min());
  expect_round_trip(sut);
}

TEST(EveryType, GivesListsTheLengthThatTheEditorSays) {
  dialect::msg::Lists sut;
  Numbering editor;
  type_info<dialect::msg::Lists>().edit(&sut, editor);
  EXPECT_EQ(editor.depth, 0);
  EXPECT_EQ(sut.bytes(), (Bytes{1, 2, 3}));
  EXPECT_EQ(sut.flags(), (std::vector<bool>{true, true}));
  EXPECT_EQ(sut.texts(), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(sut.pairs().size(), 2U);
  EXPECT_EQ(sut.rows().size(), 2U);
  EXPECT_EQ(sut.rows()[1].size(), 2U);
  EXPECT_NE(sut.poses()[0], sut.poses()[1]) << "an array keeps its length and gets values";
  expect_round_trip(sut);
}

}  // namespace
}  // namespace tocsin
