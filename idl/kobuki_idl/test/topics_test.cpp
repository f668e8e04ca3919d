// SPDX-License-Identifier: Apache-2.0
// Every topic that the header states is known by its name.
#include "kobuki_idl/topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "idl_support/topic_registry.hpp"

namespace tocsin {
namespace {

/// The names in all `TopicInfo info{"name", ...` of the header.
std::vector<std::string> stated_names() {
  std::ostringstream header;
  header << std::ifstream(TOCSIN_SOURCE_DIR "/include/kobuki_idl/topics.hpp").rdbuf();
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
    if (topic.info.name == std::string(topic::SensorsCore::info.name)) {
      EXPECT_EQ(topic.type, &type_info<topic::SensorsCore::Message>());
      EXPECT_EQ(topic.info.scope, topic::SensorsCore::info.scope);
      EXPECT_STREQ(topic.info.qos, topic::SensorsCore::info.qos);
      return;
    }
  }
  FAIL() << "not known";
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

}  // namespace
}  // namespace tocsin
