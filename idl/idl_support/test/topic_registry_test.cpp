// SPDX-License-Identifier: Apache-2.0
#include "idl_support/topic_registry.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

const TypeInfo first{"first", nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};
const TypeInfo second{"second", nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};

TEST(TopicRegistry, KeepsTheFirstOfANameInTheOrderOfTheirRegistration) {
  register_topic({"scan", "sensor", Scope::host}, first);
  register_topic({"map", "state", Scope::link}, second);
  register_topic({"scan", "event", Scope::link}, second);
  const auto topics = known_topics();
  ASSERT_EQ(topics.size(), 2U);
  EXPECT_STREQ(topics[0].info.name, "scan");
  EXPECT_STREQ(topics[0].info.qos, "sensor");
  EXPECT_EQ(topics[0].type, &first);
  EXPECT_STREQ(topics[1].info.name, "map");
}

TEST(TopicRegistry, WordsMadeAtRunTimeStay) {
  TopicInfo info{};
  {
    std::string name = "a/topic/whose/name/is/longer/than/what/a/string/holds/itself";
    info = make_topic_info(name, "sensor", Scope::link);
    name.assign(name.size(), 'x');
  }
  EXPECT_STREQ(info.name, "a/topic/whose/name/is/longer/than/what/a/string/holds/itself");
  EXPECT_STREQ(info.qos, "sensor");
  EXPECT_EQ(info.scope, Scope::link);
  EXPECT_EQ(make_topic_info(info.name, "event", Scope::host).name, info.name) << "kept once";
}

}  // namespace
}  // namespace tocsin
