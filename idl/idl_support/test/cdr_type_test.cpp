// SPDX-License-Identifier: Apache-2.0
// What is shown of a field and given to an editor, by the type of the field; whole messages are in
// test/idl.
#include "idl_support/cdr_type.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace tocsin::cdr {
namespace {

enum Colour { red, green };

/// Which function was called for a value.
class Called : public FieldVisitor {
 public:
  std::string what;
  void number(const char*, double) override { what = "number"; }
  void single(const char*, float) override { what = "single"; }
  void integer(const char*, std::int64_t) override { what = "integer"; }
  void boolean(const char*, bool) override { what = "boolean"; }
  void text(const char*, const std::string&) override { what = "text"; }
  void bytes(const char*, const std::uint8_t*, std::size_t) override { what = "bytes"; }
  void begin_struct(const char*) override {}
  void end_struct() override {}
  void begin_list(const char*, std::size_t) override { what = "list"; }
  void end_list() override {}
};

template <class T>
std::string called_for(const T& value) {
  Called visitor;
  visit_value(visitor, "field", value);
  return visitor.what;
}

TEST(VisitValue, TellsKindsOfNumbersApart) {
  EXPECT_EQ(called_for(1.0), "number");
  EXPECT_EQ(called_for(1.0F), "single");
  EXPECT_EQ(called_for(std::uint8_t{1}), "integer");
  EXPECT_EQ(called_for(green), "integer");
  EXPECT_EQ(called_for(true), "boolean");
  EXPECT_EQ(called_for(std::string()), "text");
  EXPECT_EQ(called_for(std::vector<std::uint8_t>{1}), "bytes");
  EXPECT_EQ(called_for(std::vector<std::int8_t>()), "list");
}

/// Who does not care for the kind gets what there was before.
class Plain : public Called {
  void single(const char* name, float value) override { FieldVisitor::single(name, value); }
  void boolean(const char* name, bool value) override { FieldVisitor::boolean(name, value); }
};

TEST(VisitValue, SinglesAreNumbersAndBooleansIntegersToWhoDoesNotCare) {
  Plain visitor;
  visit_value(visitor, "field", 1.0F);
  EXPECT_EQ(visitor.what, "number");
  visit_value(visitor, "field", true);
  EXPECT_EQ(visitor.what, "integer");
}

TEST(RangeOf, IsWhatTheFieldCanHoldAndSigned64BitsCan) {
  EXPECT_EQ(range_of<std::int8_t>().least, -128);
  EXPECT_EQ(range_of<std::uint32_t>().most, 4294967295);
  EXPECT_EQ(range_of<std::uint64_t>().least, 0);
  EXPECT_EQ(range_of<std::uint64_t>().most, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(range_of<Colour>().least, 0);
}

/// As fastddsgen makes a type with the key fields `id` and `name`.
struct Keyed {
  std::int32_t id = 0;
  std::string name;
  void serializeKey(eprosima::fastcdr::Cdr& encoder) const { encoder << id << name; }
};

/// RTPS 2.2, section 9.6.3.3: big endian, without header.
TEST(SerializeKey, WritesTheKeyFieldsInBigEndian) {
  Keyed message;
  message.id = 0x01020304;
  message.name = "ab";
  std::uint8_t bytes[32] = {};
  ASSERT_EQ(cdr::serialize_key<Keyed>(&message, bytes, sizeof bytes), 11U);
  const std::uint8_t expected[] = {1, 2, 3, 4, 0, 0, 0, 3, 'a', 'b', 0};
  EXPECT_TRUE(std::equal(std::begin(expected), std::end(expected), bytes));
}

TEST(SerializeKey, WritesNothingWhereThereIsNoRoom) {
  Keyed message;
  std::uint8_t bytes[8] = {};
  EXPECT_EQ(cdr::serialize_key<Keyed>(&message, bytes, sizeof bytes), 0U);
}

}  // namespace
}  // namespace tocsin::cdr
