// SPDX-License-Identifier: Apache-2.0
// What is shown of a field and given to an editor, by the type of the field; whole messages are in
// test/interop/dialect.
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
  // NOLINTBEGIN(bugprone-parent-virtual-call): of the grandparent, as a visitor without them has
  // it.
  void single(const char* name, float value) override { FieldVisitor::single(name, value); }
  void boolean(const char* name, bool value) override { FieldVisitor::boolean(name, value); }
  // NOLINTEND(bugprone-parent-virtual-call)
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

/// As a generated type with the key fields `id` and `name`.
struct Keyed {
  std::int32_t id = 0;
  double value = 0;
  std::string name;
  static constexpr bool has_key = true;
  template <class Message, class Visitor>
  static bool every_field(Message& message, Visitor&& visit) {
    return visit("id", message.id) && visit("value", message.value) && visit("name", message.name);
  }
  template <class Message, class Visitor>
  static bool every_key_field(Message& message, Visitor&& visit) {
    return visit("id", message.id) && visit("name", message.name);
  }
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

using Bytes = std::vector<std::uint8_t>;

Bytes key_only(std::uint8_t option = key_only_options[1]) {
  return {0, 1, key_only_options[0], option, 4, 3, 2, 1, 3, 0, 0, 0, 'a', 'b', 0, 0};
}

TEST(Deserialize, ReadsAKeyThatIsMarkedAsAlone) {
  Keyed message;
  const Bytes bytes = key_only();
  ASSERT_TRUE(deserialize<Keyed>(bytes.data(), bytes.size(), &message));
  EXPECT_EQ(message.id, 0x01020304);
  EXPECT_EQ(message.name, "ab");
}

TEST(Deserialize, TakesAKeyOnlyWithoutItsMarkForAMessageThatIsCutOff) {
  Keyed message;
  const Bytes bytes = key_only(0);
  EXPECT_FALSE(deserialize<Keyed>(bytes.data(), bytes.size(), &message));
}

TEST(Deserialize, RefusesAKeyOnlyThatIsCutOff) {
  Keyed message;
  for (std::size_t size = 0; size < 15; ++size) {
    Bytes cut = key_only();
    cut.resize(size);
    EXPECT_FALSE(deserialize<Keyed>(cut.data(), size, &message)) << size;
  }
}

TEST(ReadValue, AnEnumeratorIsANumberOf32Bits) {
  const Bytes bytes{0, 1, 0, 0, 1, 0, 0, 0};
  WireCursor cursor(bytes.data(), bytes.size());
  Colour colour = red;
  ASSERT_TRUE(read_value(cursor, colour));
  EXPECT_EQ(colour, green);
}

TEST(ReadValue, ABooleanIsZeroOrOne) {
  for (const std::uint8_t byte : Bytes{0, 1, 2, 255}) {
    const Bytes bytes{0, 1, 0, 0, byte};
    WireCursor cursor(bytes.data(), bytes.size());
    bool value = false;
    EXPECT_EQ(read_value(cursor, value), byte < 2) << int{byte};
    EXPECT_EQ(value, byte == 1);
  }
}

TEST(ReadValue, ATextEndsBeforeItsZeroAndMayHaveNone) {
  const auto text_of = [](const Bytes& content) {
    Bytes bytes{0, 1, 0, 0};
    bytes.insert(bytes.end(), content.begin(), content.end());
    WireCursor cursor(bytes.data(), bytes.size());
    std::string text = "before";
    return read_value(cursor, text) ? text : "refused";
  };
  EXPECT_EQ(text_of({3, 0, 0, 0, 'a', 'b', 0}), "ab");
  EXPECT_EQ(text_of({2, 0, 0, 0, 'a', 'b'}), "ab");
  EXPECT_EQ(text_of({0, 0, 0, 0}), "");
  EXPECT_EQ(text_of({4, 0, 0, 0, 'a', 'b', 0}), "refused");
}

/// Nothing is made of what the bytes only claim.
TEST(ReadValue, ASequenceThatClaimsGigabytesIsRefusedBeforeItTakesMemory) {
  const Bytes bytes{0, 1, 0, 0, 0xff, 0xff, 0xff, 0x7f, 1, 0, 0, 0};
  const auto capacity_after = [&](auto list) {
    WireCursor cursor(bytes.data(), bytes.size());
    EXPECT_FALSE(read_value(cursor, list));
    return list.capacity();
  };
  EXPECT_EQ(capacity_after(std::vector<double>()), 0U);
  EXPECT_LE(capacity_after(std::vector<std::string>()), 4U);
  EXPECT_LE(capacity_after(std::vector<Keyed>()), 4U);
  EXPECT_LE(capacity_after(std::vector<bool>()), 64U);
}

/// XCDR1 alone: parameter lists and XCDR2 are other encodings of the same message.
TEST(Deserialize, RefusesAnotherEncapsulation) {
  Keyed written;
  written.id = 5;
  Bytes bytes(serialized_size<Keyed>(&written));
  ASSERT_EQ(serialize<Keyed>(&written, bytes.data(), bytes.size()), bytes.size());
  Keyed message;
  EXPECT_TRUE(deserialize<Keyed>(bytes.data(), bytes.size(), &message));
  EXPECT_EQ(message.id, 5);
  for (const std::uint8_t kind : Bytes{2, 3, 6, 7, 8, 9, 255}) {
    bytes[1] = kind;
    EXPECT_FALSE(deserialize<Keyed>(bytes.data(), bytes.size(), &message)) << int{kind};
  }
}

struct Numbered : Keyed {
  std::array<std::int16_t, 3> numbers{};
  template <class Message, class Visitor>
  static bool every_key_field(Message& message, Visitor&& visit) {
    return visit("numbers", message.numbers) && visit("id", message.id);
  }
};

TEST(LongestKey, IsWhatFixedFieldsTakeAndMoreThanAHashWithAText) {
  EXPECT_EQ(longest_key<Numbered>(), 12U) << "6 bytes, 2 of padding, 4";
  EXPECT_GT(longest_key<Keyed>(), 16U);
}

}  // namespace
}  // namespace tocsin::cdr
