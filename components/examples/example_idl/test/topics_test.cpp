// SPDX-License-Identifier: Apache-2.0
#include "example_idl/topics.hpp"

#include <gtest/gtest.h>

#include <string>

#include "idl_support/topic_registry.hpp"

namespace example {
namespace {

TEST(Topics, AreKnownByTheirNamesWithTheirTypes) {
  const auto known = tocsin::known_topics();
  ASSERT_EQ(known.size(), 2U);
  EXPECT_EQ(known[0].info.name, std::string("greetings"));
  EXPECT_EQ(known[0].type, &tocsin::type_info<Greetings::Message>());
  EXPECT_EQ(known[1].info.name, std::string("distance_driven"));
  EXPECT_EQ(known[1].info.scope, tocsin::Scope::link);
}

TEST(Topics, AMessageSurvivesTheWay) {
  Greetings::Message sent;
  sent.text("hello");
  sent.number(4'000'000'000);
  const auto& type = tocsin::type_info<Greetings::Message>();
  std::vector<std::uint8_t> bytes(type.serialized_size(&sent));
  ASSERT_EQ(type.serialize(&sent, bytes.data(), bytes.size()), bytes.size());
  Greetings::Message received;
  ASSERT_TRUE(type.deserialize(bytes.data(), bytes.size(), &received));
  EXPECT_EQ(received.text(), "hello");
  EXPECT_EQ(received.number(), 4'000'000'000);
}

}  // namespace
}  // namespace example
