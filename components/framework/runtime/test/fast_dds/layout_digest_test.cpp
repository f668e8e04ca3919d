// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/layout_digest.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "idl_support/wire_cursor.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

/// A type made of one number of `Number`'s width in front of a text, by hand.
template <class Number>
struct Pair {
  Number number{};
  std::uint32_t length = 0;

  static std::shared_ptr<void> create() { return std::make_shared<Pair>(); }
  static bool skip(WireCursor& cursor) {
    std::uint32_t length = 0;
    return cursor.skip(1, sizeof(Number)) && cursor.read_length(length) && cursor.skip(length, 1);
  }
  static bool deserialize(const std::uint8_t* bytes, std::size_t size, void* message) {
    WireCursor cursor(bytes, size);
    if (!cursor.has_header() || !skip(cursor)) return false;
    std::memcpy(&static_cast<Pair*>(message)->number, bytes + 4, sizeof(Number));
    return true;
  }
  static void visit(const void* message, FieldVisitor& visitor) {
    const auto& pair = *static_cast<const Pair*>(message);
    if constexpr (std::is_floating_point_v<Number>) {
      visitor.number("number", pair.number);
    } else {
      visitor.integer("number", static_cast<std::int64_t>(pair.number));
    }
    visitor.text("text", "x");
  }
  static TypeInfo info() { return {"pair", create, nullptr, nullptr, deserialize, visit, nullptr}; }
};

template <class Number>
std::string digest_of_pair() {
  return layout_digest(Pair<Number>::info());
}

TEST(LayoutDigest, IsTheSameEachTime) {
  EXPECT_EQ(digest_of_pair<float>(), digest_of_pair<float>());
  EXPECT_EQ(digest_of_pair<float>().size(), 16U);
}

TEST(LayoutDigest, DiffersWhenANumberHasAnotherWidthBehindTheSamePadding) {
  EXPECT_NE(digest_of_pair<std::uint8_t>(), digest_of_pair<std::uint16_t>());
  EXPECT_NE(digest_of_pair<std::uint16_t>(), digest_of_pair<std::uint32_t>());
  EXPECT_NE(digest_of_pair<std::uint32_t>(), digest_of_pair<std::uint64_t>());
}

TEST(LayoutDigest, DiffersWhenANumberOfTheSameWidthIsOfAnotherKind) {
  EXPECT_NE(digest_of_pair<float>(), digest_of_pair<std::uint32_t>());
  EXPECT_NE(digest_of_pair<double>(), digest_of_pair<std::uint64_t>());
}

// Recorded: another value means that processes of two builds no longer know each other's types.
TEST(LayoutDigest, IsTheSameInEveryBuild) {
  EXPECT_EQ(layout_digest(type_info<geometry_msgs::msg::Vector3>()), "19a9ce78a22d8fba");
}

template <class... Topics>
std::vector<const TypeInfo*> types_of(topic::List<Topics...>) {
  return {&type_info<typename Topics::Message>()...};
}

TEST(LayoutDigest, TellsTheTypesOfTheStackApart) {
  std::map<std::string, std::string> name_of;
  auto types = types_of(topic::AllLinkTopics{});
  for (const TypeInfo* type :
       types_of(topic::List<topic::Odom, topic::Diagnostics, topic::ContainerState>{})) {
    types.push_back(type);
  }
  for (const TypeInfo* type : types) {
    const std::string digest = layout_digest(*type);
    EXPECT_EQ(digest.size(), 16U) << type->name;
    EXPECT_EQ(name_of.emplace(digest, type->name).first->second, type->name);
  }
  EXPECT_GT(name_of.size(), 15U);
}

}  // namespace
}  // namespace tocsin
