// SPDX-License-Identifier: Apache-2.0
// The watchdog beside real Fast DDS on loopback.
#include "watch/process_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

#include "fast_dds/bus_fixture.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using String = std_msgs::msg::String;

constexpr TopicInfo topic{"text", "sensor", Scope::host};
const char* const qos = "sensor: {reliability: reliable, depth: 200}\n";
constexpr std::uint64_t plenty = std::uint64_t{1} << 40U;

std::promise<void> let_go;

/// Reads a text; the text "keep" keeps the thread which receives it.
bool read_or_keep(const std::uint8_t* bytes, std::size_t size, void* message) {
  if (!type_info<String>().deserialize(bytes, size, message)) return false;
  if (static_cast<const String*>(message)->data() == "keep") let_go.get_future().wait();
  return true;
}

std::shared_ptr<const String> text(const char* words) {
  auto made = std::make_shared<String>();
  made->data(words);
  return made;
}

/// What the watchdog has told.
class Told {
 public:
  void operator()(const WatchFinding& finding) {
    const std::lock_guard<std::mutex> lock(mutex_);
    findings_.push_back(finding);
  }
  [[nodiscard]] std::vector<WatchFinding> all() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return findings_;
  }

 private:
  std::mutex mutex_;
  std::vector<WatchFinding> findings_;
};

TEST(ProcessWatch, AMessageThatKeepsItsReceptionIsAFindingUntilItLetsGo) {
  TypeInfo holding = type_info<String>();
  holding.deserialize = &read_or_keep;
  const auto writing = make_test_bus(151, qos);
  const auto reading = make_test_bus(151, qos);
  Told told;
  ProcessWatch sut({seconds(2), plenty}, [&](const WatchFinding& finding) { told(finding); });
  Samples samples;
  const auto reader = reading->subscribe({topic, &holding}, samples);
  const auto writer = writing->advertise({topic, &type_info<String>()});
  ASSERT_TRUE(eventually([&] { return health_of(*writing, "text", true).matched == 1; }));
  EXPECT_FALSE(sut.finding());
  ASSERT_EQ(writer->write(text("keep")), Status::ok);
  ASSERT_TRUE(eventually([&] { return sut.finding().has_value(); }));
  EXPECT_THAT(*sut.finding(), AllOf(HasSubstr("reception at UDP "), HasSubstr("stuck")));
  let_go.set_value();
  EXPECT_TRUE(eventually([&] { return !sut.finding(); }));
  ASSERT_EQ(told.all().size(), 1U) << "once, and it did not last";
  EXPECT_FALSE(told.all().front().is_final);
}

TEST(ProcessWatch, ParticipantsAtRestAreFine) {
  const auto one = make_test_bus(152, qos);
  const auto other = make_test_bus(152, qos);
  Told told;
  const ProcessWatch sut({seconds(1), plenty}, [&](const WatchFinding& finding) { told(finding); });
  Samples samples;
  const auto reader = one->subscribe({topic, &type_info<String>()}, samples);
  const auto writer = other->advertise({topic, &type_info<String>()});
  ASSERT_TRUE(eventually([&] { return health_of(*other, "text", true).matched == 1; }));
  const auto have_announced_for_three_seconds = [] {
    std::size_t timers = 0;
    for (const auto& activity : watched_activities()) {
      if (activity->duty() == Duty::announcements && activity->begun() >= 16)
        ++timers;  // ten at the start
    }
    return timers == 2;
  };
  ASSERT_EQ(writer->write(text("hello")), Status::ok);
  ASSERT_TRUE(samples.wait_for(1));
  ASSERT_TRUE(eventually(have_announced_for_three_seconds));
  EXPECT_TRUE(told.all().empty()) << told.all().front().text;
}

TEST(ProcessWatch, TooMuchMemoryIsToldOnce) {
  Told told;
  const ProcessWatch sut({seconds(1), 1}, [&](const WatchFinding& finding) { told(finding); });
  ASSERT_TRUE(eventually([&] { return !told.all().empty(); }));
  EXPECT_TRUE(told.all().front().is_final);
}

}  // namespace
}  // namespace tocsin
