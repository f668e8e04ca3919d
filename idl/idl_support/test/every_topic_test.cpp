// SPDX-License-Identifier: Apache-2.0
// What holds for every topic of a package and its message, seen without its C++ type: compiled into
// each package of messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "idl_support/topic_registry.hpp"
#include "idl_support/type_definition.hpp"
#include "idl_support/type_registry.hpp"

namespace tocsin {
namespace {

std::vector<std::uint8_t> encoded(const TypeInfo& type, const void* message) {
  std::vector<std::uint8_t> bytes(type.serialized_size(message));
  EXPECT_EQ(type.serialize(message, bytes.data(), bytes.size()), bytes.size()) << type.name;
  return bytes;
}

/// Counts structs and lists that begin and end.
class Nesting final : public FieldVisitor {
 public:
  void number(const char* name, double) override { note(name); }
  void integer(const char* name, std::int64_t) override { note(name); }
  void text(const char* name, const std::string&) override { note(name); }
  void bytes(const char* name, const std::uint8_t*, std::size_t) override { note(name); }
  void begin_struct(const char* name) override { note(name), ++depth; }
  void end_struct() override { --depth; }
  void begin_list(const char* name, std::size_t) override { note(name), ++depth; }
  void end_list() override { --depth; }
  int fields = 0;
  int depth = 0;

 private:
  void note(const std::string& name) {
    EXPECT_FALSE(name.empty());
    ++fields;
  }
};

/// Gives each field a random value, and each list up to three elements.
class Shaker final : public FieldEditor {
 public:
  explicit Shaker(unsigned seed) : random_(seed) {}
  void number(const char*, double& value) override { value = below(2'000'001) / 1000.0 - 1000; }
  void integer(const char*, std::int64_t& value, const IntegerRange& range) override {
    const std::int64_t some[] = {range.least, range.most, 0, 1};
    value = some[below(4)];
  }
  void boolean(const char*, bool& value) override { value = below(2) == 1; }
  void text(const char*, std::string& value) override { value.assign(below(9), 'x'); }
  void bytes(const char*, std::vector<std::uint8_t>& value) override { value.assign(below(9), 7); }
  void begin_struct(const char*) override {}
  void end_struct() override {}
  std::size_t begin_list(const char*, std::size_t size) override { return size + below(4); }
  void end_list() override {}

 private:
  unsigned below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
  std::minstd_rand random_;
};

class EveryTopic : public ::testing::TestWithParam<KnownTopic> {
 protected:
  const TypeInfo& type_ = *GetParam().type;
  const std::shared_ptr<void> fresh_ = type_.create();
};

TEST_P(EveryTopic, HasANameAsRos2WantsItAndATypeThatIsFoundByItsName) {
  const std::string name = GetParam().info.name;
  EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_/"), std::string::npos);
  EXPECT_NE(name.front(), '/') << "relative, so that a namespace goes in front";
  EXPECT_NE(name.back(), '/');
  EXPECT_EQ(name.find("//"), std::string::npos);
  EXPECT_EQ(find_type(type_.name), &type_);
  EXPECT_NE(std::string(type_.name).find("::msg::dds_::"), std::string::npos);
}

TEST_P(EveryTopic, AFreshMessageSurvivesTheWay) {
  const auto bytes = encoded(type_, fresh_.get());
  const auto received = type_.create();
  ASSERT_TRUE(type_.deserialize(bytes.data(), bytes.size(), received.get()));
  EXPECT_EQ(encoded(type_, received.get()), bytes);
}

TEST_P(EveryTopic, IsNotWrittenWhereThereIsNoRoom) {
  auto bytes = encoded(type_, fresh_.get());
  EXPECT_EQ(type_.serialize(fresh_.get(), bytes.data(), bytes.size() - 1), 0U);
}

TEST_P(EveryTopic, EveryBeginningOfAMessageIsRefused) {
  const auto bytes = encoded(type_, fresh_.get());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    // A copy of its own, so that a sanitizer sees each byte that is read beyond it.
    const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<long>(size));
    EXPECT_FALSE(type_.deserialize(cut.data(), cut.size(), type_.create().get())) << size;
  }
}

TEST_P(EveryTopic, DamagedBytesAreReadOrRefusedAndWhatWasReadCanBeWritten) {
  std::minstd_rand random(1);
  const auto bytes = encoded(type_, fresh_.get());
  for (int i = 0; i < 300; ++i) {
    auto damaged = bytes;
    for (int j = 0; j < 4; ++j) {
      damaged[4 + random() % (damaged.size() - 4)] = static_cast<std::uint8_t>(random());
    }
    const auto received = type_.create();
    if (!type_.deserialize(damaged.data(), damaged.size(), received.get())) continue;
    EXPECT_GE(encoded(type_, received.get()).size(), 4U);
  }
}

TEST_P(EveryTopic, AMessageOfAnyValuesSurvivesTheWayAndNoBeginningOfIt) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto sent = type_.create();
    Shaker shaker(seed);
    type_.edit(sent.get(), shaker);
    const auto bytes = encoded(type_, sent.get());
    const auto received = type_.create();
    ASSERT_TRUE(type_.deserialize(bytes.data(), bytes.size(), received.get()));
    ASSERT_EQ(encoded(type_, received.get()), bytes);
    const std::vector<std::uint8_t> cut(bytes.begin(), bytes.end() - 1);
    ASSERT_FALSE(type_.deserialize(cut.data(), cut.size(), received.get()));
  }
}

TEST_P(EveryTopic, IsDefinedToWhoReadsABagAndToWhoComparesHashes) {
  const auto definition = ros2msg_definition(type_.name);
  ASSERT_TRUE(definition) << "bags of it could be read by nobody else";
  const auto own = find_definition(type_.name);
  for (const std::string& part : own->parts) {
    EXPECT_NE(definition->find("MSG: " + short_type_name(part) + "\n"), std::string::npos) << part;
  }
  EXPECT_EQ(std::string(type_.ros_hash).size(), 7U + 64U) << "rmw would warn of another type";
}

TEST_P(EveryTopic, ShowsAllItsFields) {
  Nesting seen;
  type_.visit(fresh_.get(), seen);
  EXPECT_GT(seen.fields, 0);
  EXPECT_EQ(seen.depth, 0) << "each struct and list ends";
}

std::string test_name(const ::testing::TestParamInfo<KnownTopic>& info) {
  std::string name = info.param.info.name;
  for (char& c : name) c = c == '/' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Of, EveryTopic, ::testing::ValuesIn(known_topics()), test_name);

/// The names in all `TopicInfo info{"name", ...` of the header.
std::vector<std::string> stated_names() {
  const std::filesystem::path package = TOCSIN_SOURCE_DIR;
  std::ostringstream header;
  header << std::ifstream(package / "include" / package.filename() / "topics.hpp").rdbuf();
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
  std::smatch on_demand;
  ASSERT_TRUE(std::regex_search(classes, on_demand, std::regex(R"(on_demand: \[[^\]]*\])")));
  for (const KnownTopic& topic : known_topics()) {
    const std::regex word("[\\[ ,]" + std::string(topic.info.name) + "[\\],]");
    const bool crosses =
        topic.info.scope == Scope::link || std::regex_search(on_demand.str(), word);
    EXPECT_EQ(std::regex_search(classes, word), crosses) << topic.info.name;
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
