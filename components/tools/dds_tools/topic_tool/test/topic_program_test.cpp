// SPDX-License-Identifier: Apache-2.0
// The program on real DDS, beside a talker and a listener, where its page does not play it
// (test/system).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using String = std_msgs::msg::String;
using Stamped = geometry_msgs::msg::PoseStamped;

constexpr int domain = 94;
const Endpoint chatter{{"chatter", "event", Scope::host}, &type_info<String>()};
const Endpoint pose{{"uxv/pose", "sensor", Scope::host}, &type_info<Stamped>()};
const Endpoint orders{{"orders", "event", Scope::host}, &type_info<String>()};

/// Talks twenty times a second and keeps what it hears on `orders`.
class Neighbour : private Receiver {
 public:
  Neighbour()
      : bus_(make_fast_dds_bus(options())),
        listener_(bus_->subscribe(orders, *this)),
        thread_([this] { talk(); }) {}
  ~Neighbour() override {
    ended_ = true;
    thread_.join();
  }
  Neighbour(const Neighbour&) = delete;
  Neighbour& operator=(const Neighbour&) = delete;
  [[nodiscard]] std::vector<std::string> heard() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return heard_;
  }

 private:
  static BusOptions options() {
    BusOptions options;
    options.name = "neighbour";
    options.qos_file = TOCSIN_REPOSITORY "/config/qos.yaml";
    options.host_domain = domain;
    return options;
  }
  void talk() {
    const auto texts = bus_->advertise(chatter);
    const auto poses = bus_->advertise(pose);
    while (!ended_) {
      auto text = std::make_shared<String>();
      text->data("hello");
      (void)texts->write(text);
      auto stamped = std::make_shared<Stamped>();
      stamped->header().stamp().sec(
          static_cast<int>(bus_->wall_ns(bus_->now()) / 1'000'000'000 - 5));
      (void)poses->write(stamped);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.push_back(std::static_pointer_cast<const String>(sample.message)->data());
  }
  std::mutex mutex_;
  std::vector<std::string> heard_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Subscription> listener_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

/// `seconds`: after them Ctrl-C is pressed; 0: it ends by itself.
Ended call(std::vector<std::string> arguments, int seconds = 0) {
  std::vector<std::string> command;
  if (seconds > 0) command = {"/usr/bin/timeout", "-s", "INT", std::to_string(seconds)};
  command.emplace_back(TOPIC_PROGRAM);
  command.insert(command.end(), arguments.begin(), arguments.end());
  command.insert(command.end(), {"--domain", std::to_string(domain)});
  return run_to_end(command);
}

class TopicProgram : public ::testing::Test {
 protected:
  Neighbour neighbour_;
};

TEST_F(TopicProgram, MeasuresRateBytesAndDelay) {
  EXPECT_THAT(call({"hz", "/chatter"}, 3).output, HasSubstr("average rate: "));
  EXPECT_THAT(call({"bw", "/chatter"}, 3).output,
              AllOf(HasSubstr("Subscribed to [/chatter]\n"), HasSubstr("mean: 16 B")));
  EXPECT_THAT(call({"delay", "/uxv/pose"}, 3).output, HasSubstr("average delay: 5."));
}

TEST_F(TopicProgram, ListsInOtherFormsAndHidesNothingWhenAsked) {
  EXPECT_EQ(call({"list"}).output, "/chatter\n/orders\n/uxv/pose\n");
  EXPECT_EQ(call({"list", "-c"}).output, "3\n");
  EXPECT_EQ(call({"type", "/uxv/pose"}).output, "geometry_msgs/msg/PoseStamped\n");
  EXPECT_THAT(call({"info", "chatter", "-v"}).output,
              AllOf(HasSubstr("Participant name: neighbour\n"), HasSubstr("RELIABLE\n")));
  EXPECT_THAT(
      call({"list", "-v"}).output,
      AllOf(HasSubstr("Published topics:\n * /chatter [std_msgs/msg/String] 1 publisher\n"),
            HasSubstr("Subscribed topics:\n * /orders [std_msgs/msg/String] 1 subscriber")));
}

TEST_F(TopicProgram, CutsAndLeavesOutWhatItShall) {
  EXPECT_EQ(call({"echo", "/chatter", "--once", "-l", "3"}).output, "data: hel...\n---\n");
  EXPECT_EQ(call({"echo", "/chatter", "--once", "-l", "3", "-f"}).output, "data: hello\n---\n");
  EXPECT_THAT(call({"echo", "/uxv/pose", "--once", "--no-str"}).output,
              HasSubstr("frame_id: '<string length: <0>>'\n"));
}

TEST_F(TopicProgram, WritesUntilCtrlC) {
  const Ended sut = call({"pub", "-r", "20", "-w", "1", "/orders", "std_msgs/msg/String"}, 3);
  EXPECT_THAT(sut.output, HasSubstr("publishing #5:\ndata: ''\n"));
  EXPECT_GE(neighbour_.heard().size(), 5U);
}

TEST_F(TopicProgram, RefusesInOneLineWhatCannotBe) {
  for (const auto& [arguments, code, text] :
       std::vector<std::tuple<std::vector<std::string>, int, const char*>>{
           {{"echo", "/nothing", "--spin-time", "0.3"}, 1, "topic /nothing does not appear"},
           {{"echo", "/chattre", "--spin-time", "0.5"}, 1, "; did you mean '/chatter'?"},
           {{"hz", "/chattre", "--spin-time", "0.5"}, 1, "; did you mean '/chatter'?"},
           {{"info", "/chattre", "--spin-time", "0.5"}, 1, "; did you mean '/chatter'?"},
           {{"echo", "/chatter", "--field", "date"}, 2, "has no field 'date'"},
           {{"delay", "/chatter"}, 2, "has no header with a stamp"},
           {{"pub", "/x", "no_msgs/msg/Thing"}, 2, "'no_msgs/msg/Thing' is not known here"},
           {{"pub", "/x", "Thing"}, 2, "'Thing' is no message type"},
           {{"pub", "/x", "std_msgs/msg/String", "{dat: 1}"}, 2, "no field 'dat'"},
           {{"find", "a b"}, 2, "is no message type"}}) {
    const Ended sut = call(arguments);
    EXPECT_EQ(sut.code, code) << sut.output;
    EXPECT_THAT(sut.output, HasSubstr(text));
    EXPECT_EQ(sut.output.find('\n'), sut.output.size() - 1) << sut.output;
  }
}

}  // namespace
}  // namespace tocsin::topic_tool
