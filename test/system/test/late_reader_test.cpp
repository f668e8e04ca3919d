// SPDX-License-Identifier: Apache-2.0
// Consumers of the station's log that come late, are killed and come back, over an outage of the
// emulated radio in which the station's router is killed, too.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "ros_idl/std_msgs.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::HasSubstr;
using Message = std_msgs::msg::String;

constexpr TopicInfo history{"history", "history", Scope::host};
constexpr auto period = milliseconds(50);
constexpr std::size_t at_once = 100;  ///< samples between two commits of `topic echo`

class LateReaderTest : public ::testing::Test {
 protected:
  LateReaderTest() {
    bringup_ = standing(folder_.path(),
                        "extends: traffic.yaml\n"
                        "uxv: {normal: {topics: [history], store: [history], keep: [history]}}\n");
    qos_ = folder_.write(
        "qos.yaml", "history: {reliability: reliable, durability: transient_local, depth: 400}\n");
  }
  /// Somebody on the vehicle who counts, until it is killed.
  void start_counting(const Stack& stack) {
    BusOptions options;
    options.qos_file = qos_;
    options.name = "history";
    options.host_domain = standing_domain;
    counting_ = std::make_unique<Peer>(stack.running("uxv/link"), options, [](Bus& bus) {
      const auto writer = bus.advertise({history, &type_info<Message>()});
      auto next = std::chrono::steady_clock::now();
      for (int count = 1;; ++count, next += period) {
        std::this_thread::sleep_until(next);
        Message message;
        message.data(std::to_string(count));
        (void)writer->write(std::make_shared<const Message>(message));
      }
    });
  }
  /// What `topic echo` prints on the station until the signal comes.
  static std::vector<int> echo(const Stack& stack, const std::string& signal, double s,
                               const std::string& arguments) {
    const Ended ended =
        run_to_end("/usr/bin/timeout",
                   fmt::format("-s {} {} {} echo /history --run-dir {} --host gcs {}", signal, s,
                               Stack::program("tocsin-topic"), stack.folder(), arguments));
    std::vector<int> numbers;
    std::istringstream lines(ended.output);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = line.find_first_of("0123456789");
      if (line.rfind("data:", 0) == 0) numbers.push_back(std::stoi(line.substr(begin)));
    }
    return numbers;
  }
  TemporaryFolder folder_;
  std::string bringup_;
  std::string qos_;
  std::unique_ptr<Peer> counting_;
};

/// `first` was read by a consumer that was killed, `rest` by those that ended well.
void expect_each_once(const std::vector<int>& first, std::vector<int> rest) {
  std::sort(rest.begin(), rest.end());
  EXPECT_EQ(std::adjacent_find(rest.begin(), rest.end()), rest.end())
      << "who ends well has none twice";
  const auto twice = std::count_if(rest.begin(), rest.end(), [&](int one) {
    return std::count(first.begin(), first.end(), one) != 0;
  });
  EXPECT_LE(twice, static_cast<std::ptrdiff_t>(at_once))
      << "read, and not committed, when it was killed";
}

TEST_F(LateReaderTest, AConsumerThatIsKilledGetsEachSampleOverAnOutageAndAKilledRouter) {
  const Stack stack({bringup_, "--seed", "1"});
  ASSERT_TRUE(routers_run(stack)) << stack.output();
  start_counting(stack);
  std::vector<int> first;
  const auto reads = [&] {  // killed in the middle of reading
    const auto more = echo(stack, "KILL", 1.5, "--from-start --consumer plot");
    first.insert(first.end(), more.begin(), more.end());
    return first.size() > 60;
  };
  ASSERT_TRUE(Stack::eventually(seconds(60), reads)) << stack.output();

  stack.control("radio.sock", "set outage 4");
  std::this_thread::sleep_for(seconds(2));
  ASSERT_EQ(kill(stack.pid("gcs/link"), SIGKILL), 0);
  std::this_thread::sleep_for(seconds(2));
  const int until = first.back() + 120;
  std::vector<int> rest;
  const auto complete = [&] {
    const auto more = echo(stack, "INT", 3, "--consumer plot");
    rest.insert(rest.end(), more.begin(), more.end());
    std::set<int> all(first.begin(), first.end());
    all.insert(rest.begin(), rest.end());
    return *all.rbegin() >= until &&
           all.size() == static_cast<std::size_t>(*all.rbegin() - *all.begin() + 1);
  };
  EXPECT_TRUE(Stack::eventually(seconds(120), complete))
      << ::testing::PrintToString(rest) << stack.output();

  expect_each_once(first, rest);
  const auto fresh = echo(stack, "INT", 3, "--from-start");
  std::set<int> each(fresh.begin(), fresh.end());
  EXPECT_EQ(each.size(), fresh.size()) << "none is in the log twice";
  EXPECT_EQ(*each.begin(), std::min(*std::min_element(rest.begin(), rest.end()),
                                    *std::min_element(first.begin(), first.end())));
}

TEST_F(LateReaderTest, ATopicThatIsInNoLogIsNamedWithThoseThatAre) {
  const Ended nobody =
      run_to_end(Stack::program("tocsin-topic"),
                 fmt::format("echo /camera --last 3 --log {} --spin-time 0.1", folder_.path()));
  EXPECT_EQ(nobody.code, 2);
  EXPECT_THAT(nobody.output, HasSubstr("has nothing of /camera"));
}

}  // namespace
}  // namespace tocsin
