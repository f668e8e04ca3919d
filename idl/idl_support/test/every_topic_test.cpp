// SPDX-License-Identifier: Apache-2.0
// What holds for every topic of a package and its message, seen without its C++ type: compiled into
// each package of messages.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "idl_support/topic_registry.hpp"
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

}  // namespace
}  // namespace tocsin
