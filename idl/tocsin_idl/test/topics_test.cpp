// SPDX-License-Identifier: Apache-2.0
// Every topic that the header states is known by its name.
#include "tocsin_idl/topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "idl_support/topic_registry.hpp"

namespace tocsin {
namespace {

/// The names in all `TopicInfo info{"name", ...` of the header.
std::vector<std::string> stated_names() {
  std::ostringstream header;
  header << std::ifstream(TOCSIN_SOURCE_DIR "/include/tocsin_idl/topics.hpp").rdbuf();
  const std::string text = header.str();
  const std::regex statement(R"(TopicInfo info\{\s*"([^"]+)\")");
  std::vector<std::string> names;
  for (std::sregex_iterator found(text.begin(), text.end(), statement), end; found != end;
       ++found) {
    names.push_back((*found)[1]);
  }
  return names;
}

TEST(Topics, AreAllKnownByName) {
  std::vector<std::string> known;
  for (const KnownTopic& topic : known_topics()) known.emplace_back(topic.info.name);
  EXPECT_GT(stated_names().size(), 20U);
  EXPECT_THAT(known, ::testing::UnorderedElementsAreArray(stated_names()));
}

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

TEST(Messages, AStateOfTheLinkComesBackFromItsBytes) {
  tocsin_msgs::msg::LinkState state;
  state.role("uxv");
  state.scale(0.5F);
  state.classes().resize(2);
  state.classes()[1].traffic_class("high");
  state.classes()[1].dropped_expired(7);
  const TypeInfo& type = type_info<tocsin_msgs::msg::LinkState>();
  std::vector<std::uint8_t> bytes(type.serialized_size(&state));
  ASSERT_EQ(type.serialize(&state, bytes.data(), bytes.size()), bytes.size());
  tocsin_msgs::msg::LinkState back;
  ASSERT_TRUE(type.deserialize(bytes.data(), bytes.size(), &back));
  EXPECT_EQ(back.role(), "uxv");
  EXPECT_EQ(back.scale(), 0.5F);
  EXPECT_EQ(back.classes().at(1).dropped_expired(), 7U);
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

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(TOCSIN_REPOSITORY "/config/" + file).rdbuf();
  return text.str();
}

TEST(Topics, HaveAProfileOfTheShippedQosFile) {
  const std::string profiles = "\n" + text_of("qos.yaml");
  for (const KnownTopic& topic : known_topics()) {
    EXPECT_NE(profiles.find("\n" + std::string(topic.info.qos) + ": "), std::string::npos)
        << topic.info.name << ": " << topic.info.qos;
  }
}

TEST(Topics, ThatCrossTheLinkHaveATrafficClassAndNoOthers) {
  const std::string classes = std::regex_replace(text_of("traffic.yaml"), std::regex("#.*"), "");
  for (const KnownTopic& topic : known_topics()) {
    const std::regex word("[\\[ ,]" + std::string(topic.info.name) + "[\\],]");
    EXPECT_EQ(std::regex_search(classes, word), topic.info.scope == Scope::link) << topic.info.name;
  }
}

TEST(Topics, HaveNamesOfTheirOwnAlsoAsFilesOfARecording) {
  const auto all = known_topics();
  for (const KnownTopic& one : all) {
    for (const KnownTopic& other : all) {
      // A file of a recording is named like its topic with '.' for '/': one name for each.
      EXPECT_TRUE(&one == &other || std::string(one.info.name) != other.info.name);
      EXPECT_EQ(std::string(one.info.name).find('.'), std::string::npos) << one.info.name;
    }
  }
}

TEST(Topics, WhoDrivesIsToldByTheVehicleAndTheWheelIsAskedForOverTheLink) {
  EXPECT_EQ(topic::DriverState::info.scope, Scope::link);
  EXPECT_STREQ(topic::DriverState::info.qos, "state") << "who comes late must know it, too";
  EXPECT_EQ(topic::DriverRequest::info.scope, Scope::link);
  EXPECT_STREQ(topic::DriverRequest::info.qos, "command") << "an old request is worth nothing";
}

TEST(Messages, ARequestForTheWheelComesBackFromItsBytes) {
  tocsin_msgs::msg::DriverRequest request;
  request.name("anna");
  request.verb("ask");
  const TypeInfo& type = type_info<tocsin_msgs::msg::DriverRequest>();
  const auto back = decode(type, encode(type, &request));
  ASSERT_TRUE(back);
  EXPECT_EQ(*std::static_pointer_cast<const tocsin_msgs::msg::DriverRequest>(back), request);
}

}  // namespace
}  // namespace tocsin
