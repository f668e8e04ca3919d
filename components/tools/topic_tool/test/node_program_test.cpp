// SPDX-License-Identifier: Apache-2.0
// `tocsin node` as a user runs it, on real DDS, beside a process with two nodes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;

constexpr int domain = 112;

struct Unheard : Receiver {
  void receive(const Sample&) override {}
};

/// A process with a talker and a listener.
class Neighbour {
 public:
  Neighbour() : bus_(make_fast_dds_bus(options())) {
    const TopicInfo chatter{"chatter", "event", Scope::host};
    const TypeInfo& string = type_info<std_msgs::msg::String>();
    talker_ = bus_->advertise({chatter, &string, Writers::needed, "", "talker"});
    listener_ = bus_->subscribe({chatter, &string, Writers::needed, "", "listener"}, unheard_);
    bus_->host_control().update_graph();
  }

 private:
  static BusOptions options() {
    BusOptions options;
    options.name = "neighbour";
    options.host_domain = domain;
    return options;
  }
  Unheard unheard_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Publication> talker_;
  std::unique_ptr<Subscription> listener_;
};

Ended call(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), NODE_PROGRAM);
  arguments.insert(arguments.end(), {"--domain", std::to_string(domain)});
  return run_to_end(arguments);
}

TEST(NodeProgram, ListsNodesAndDescribesOne) {
  const Neighbour neighbour;
  EXPECT_EQ(call({"list"}).output, "/listener\n/talker\n");
  EXPECT_EQ(call({"list", "-c"}).output, "2\n");
  EXPECT_EQ(call({"list", "-a"}).output, "/listener\n/talker\n");
  const Ended listener = call({"info", "listener", "--include-hidden"});
  EXPECT_EQ(listener.code, 0);
  EXPECT_THAT(listener.output, HasSubstr("  Subscribers:\n    /chatter: std_msgs/msg/String\n"));
  const Ended sut = call({"info", "/talker"});
  EXPECT_EQ(sut.code, 0);
  EXPECT_THAT(sut.output, HasSubstr("/talker\n  Subscribers:\n\n  Publishers:\n"
                                    "    /chatter: std_msgs/msg/String\n  Service Servers:\n"));
}

TEST(NodeProgram, SaysInOneLineThatANodeIsNotThere) {
  const Ended sut = call({"info", "nobody", "--spin-time", "0.2"});
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output, HasSubstr("Unable to find node '/nobody'\n"));
  EXPECT_EQ(sut.output.find('\n'), sut.output.size() - 1) << sut.output;
}

}  // namespace
}  // namespace tocsin::topic_tool
