// SPDX-License-Identifier: Apache-2.0
#include "tocsin_idl/topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idl_support/topic_registry.hpp"

namespace tocsin {
namespace {

TEST(Topics, AreKnownWithTheirType) {
  for (const KnownTopic& topic : known_topics()) {
    if (topic.info.name == std::string(topic::Location::info.name)) {
      EXPECT_EQ(topic.type, &type_info<topic::Location::Message>());
      EXPECT_EQ(topic.info.scope, topic::Location::info.scope);
      EXPECT_STREQ(topic.info.qos, topic::Location::info.qos);
      return;
    }
  }
  FAIL() << "not known";
}

TEST(Topics, TheStateOfTheLinkCrossesItAndItsBudgetDoesNot) {
  EXPECT_EQ(topic::LinkState::info.scope, Scope::link);
  EXPECT_EQ(topic::LinkBudget::info.scope, Scope::host);
}

TEST(Topics, OfTheMapKeepsItsUnknownCells) {
  topic::Map::Message map;
  map.info().width(3);
  map.data({0, 100, -1});
  const TypeInfo& type = type_info<topic::Map::Message>();
  std::vector<std::uint8_t> bytes(type.serialized_size(&map));
  ASSERT_EQ(type.serialize(&map, bytes.data(), bytes.size()), bytes.size());
  topic::Map::Message back;
  ASSERT_TRUE(type.deserialize(bytes.data(), bytes.size(), &back));
  EXPECT_EQ(back.info().width(), 3U);
  EXPECT_EQ(back.data(), (std::vector<std::int8_t>{0, 100, -1}));
}

TEST(Topics, WhoDrivesIsToldByTheVehicleAndTheWheelIsAskedForOverTheLink) {
  EXPECT_EQ(topic::DriverState::info.scope, Scope::link);
  EXPECT_STREQ(topic::DriverState::info.qos, "state") << "who comes late must know it, too";
  EXPECT_EQ(topic::DriverRequest::info.scope, Scope::link);
  EXPECT_STREQ(topic::DriverRequest::info.qos, "command") << "an old request is worth nothing";
}

}  // namespace
}  // namespace tocsin
