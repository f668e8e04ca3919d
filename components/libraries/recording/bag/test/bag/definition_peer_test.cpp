// SPDX-License-Identifier: Apache-2.0
// Whether others understand our messages by the definitions that stand in a bag: each type of this
// repository, with something in every field and list, decoded by test/mcap_peer. Skipped where that
// was not installed (npm ci in its folder).
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "bags.hpp"
#include "command_line/run_to_end.hpp"
#include "idl_support/encode.hpp"
#include "idl_support/topic_registry.hpp"
#include "kobuki_idl/kobuki_ros_interfaces.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

namespace tocsin::bag {
namespace {

const std::string peer = TOCSIN_REPOSITORY "/test/mcap_peer";

/// Gives each field a value of its own, and each list three elements.
class Filler final : public FieldEditor {
 public:
  void number(const char*, double& value) override { value = ++count_; }
  void integer(const char*, std::int64_t& value, const IntegerRange&) override {
    value = ++count_ % 100;
  }
  void boolean(const char*, bool& value) override { value = ++count_ % 2 == 0; }
  void text(const char* name, std::string& value) override {
    value = name + std::to_string(++count_);
  }
  void bytes(const char*, std::vector<std::uint8_t>& value) override { value = {1, 2, 3, 4, 5}; }
  void begin_struct(const char*) override {}
  void end_struct() override {}
  std::size_t begin_list(const char*, std::size_t) override { return 3; }
  void end_list() override {}

 private:
  int count_ = 0;
};

TEST(Definitions, LetOthersDecodeEveryTypeOfOurs) {
  if (!std::filesystem::exists(peer + "/node_modules/@mcap/core")) {
    GTEST_SKIP() << "@mcap/core is not installed: npm ci in test/mcap_peer";
  }
  if (run_to_end({"sh", "-c", "command -v node"}).code != 0) GTEST_SKIP() << "there is no node";
  (void)type_info<tocsin_msgs::msg::Goal>();  // so that the libraries are linked
  (void)type_info<kobuki_ros_interfaces::msg::SensorState>();
  std::set<const TypeInfo*> types;
  for (const KnownTopic& known : known_topics()) types.insert(known.type);
  const TemporaryFolder folder;
  {
    BagWriter writer(folder.path("run"), {});
    for (const TypeInfo* type : types) {
      Topic topic = make_topic("rt/", type->name);
      topic.name = "/" + topic.type;
      Filler filler;
      const auto message = type->create();
      type->edit(message.get(), filler);
      const auto bytes = encode(*type, message.get());
      (void)writer.write(writer.add(topic), {1, t0, t0, bytes.data(), bytes.size()});
    }
  }
  const Ended ended = run_to_end({"node", peer + "/read_file.mjs", folder.path("run/run_0.mcap")});
  ASSERT_EQ(ended.code, 0) << ended.output;
  const auto said = nlohmann::json::parse(ended.output);
  EXPECT_GT(types.size(), 20U);
  EXPECT_EQ(said["decoded"], types.size());
  EXPECT_EQ(said["streamed"], types.size());
  EXPECT_EQ(said["profile"], "ros2");
}

}  // namespace
}  // namespace tocsin::bag
