// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it, on real DDS, beside a talker and a listener.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bag/bag_reader.hpp"
#include "command_line/run_to_end.hpp"
#include "foundation/child_process.hpp"
#include "foundation/temporary_folder.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin::bag_tool {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using String = std_msgs::msg::String;

constexpr int domain = 97;
const Endpoint chatter{{"chatter", "event", Scope::host}, &type_info<String>()};
const Endpoint mode{{"mode", "state", Scope::host}, &type_info<String>()};
const Endpoint again{{"again", "event", Scope::host}, &type_info<String>()};

bool eventually(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

BusOptions options() {
  BusOptions options;
  options.name = "neighbour";
  options.qos_file = TOCSIN_REPOSITORY "/config/qos.yaml";
  options.host_domain = domain;
  return options;
}

/// Said the mode once, and counts aloud a hundred times a second.
class Talker {
 public:
  Talker() : bus_(make_fast_dds_bus(options())), thread_([this] { talk(); }) {}
  ~Talker() {
    ended_ = true;
    thread_.join();
  }
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;
  [[nodiscard]] int said() const { return said_; }

 private:
  void talk() {
    const auto texts = bus_->advertise(chatter);
    const auto modes = bus_->advertise(mode);
    auto text = std::make_shared<String>();
    text->data("driving");
    (void)modes->write(text);
    while (!ended_) {
      auto number = std::make_shared<String>();
      number->data("number " + std::to_string(said_ + 1));
      (void)texts->write(number);
      ++said_;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  std::unique_ptr<Bus> bus_;
  std::atomic<bool> ended_{false};
  std::atomic<int> said_{0};
  std::thread thread_;
};

/// Keeps what it hears on a topic.
class Listener : private Receiver {
 public:
  explicit Listener(const Endpoint& topic)
      : bus_(make_fast_dds_bus(options())), subscription_(bus_->subscribe(topic, *this)) {}
  [[nodiscard]] std::vector<std::string> heard() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return heard_;
  }

 private:
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.push_back(std::static_pointer_cast<const String>(sample.message)->data());
  }
  std::mutex mutex_;
  std::vector<std::string> heard_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Subscription> subscription_;
};

std::vector<std::string> command(std::vector<std::string> arguments, bool on_domain) {
  arguments.insert(arguments.begin(), BAG_PROGRAM);
  if (on_domain) arguments.insert(arguments.end(), {"--domain", std::to_string(domain)});
  return arguments;
}

Ended call(const std::vector<std::string>& arguments, bool on_domain = false) {
  return run_to_end(command(arguments, on_domain));
}

std::uint64_t count_in(const std::string& folder, const std::string& topic) {
  const bag::BagReader reader(folder);
  for (const auto& one : reader.topics()) {
    if (one.topic.name == topic) return one.count;
  }
  return 0;
}

/// How many messages a bag holds of [from, to], and [s] from there to the last.
std::pair<std::size_t, double> part(bag::BagReader& reader, std::int64_t from_ns,
                                    std::int64_t to_ns) {
  bag::Selection selection;
  selection.from_ns = from_ns;
  selection.to_ns = to_ns;
  std::pair<std::size_t, double> found{0, 0};
  const auto stream = reader.messages(selection);
  while (const auto one = stream->next()) {
    found = {found.first + 1, static_cast<double>(one->message.log_time_ns - from_ns) / 1e9};
  }
  return found;
}

/// A recording that runs; ends it by `signal`.
class Recorder {
 public:
  explicit Recorder(const std::vector<std::string>& arguments) {
    ChildSetup setup;
    setup.command = command(arguments, true);
    setup.streams = ChildSetup::Streams::errors_piped;
    setup.death_signal = SIGKILL;
    child_ = start_child(setup);
  }
  int end(int signal) {
    (void)::kill(child_.pid, signal);
    return wait_for_child(child_.pid);
  }

 private:
  Child child_;
};

class BagProgram : public ::testing::Test {
 protected:
  /// Records /chatter and /mode until `messages` of /chatter are safe on the disk.
  void record(const std::vector<std::string>& more, std::uint64_t messages, int signal, int code) {
    const Talker talker;
    std::vector<std::string> arguments{"record", "-o", run};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Recorder recorder(arguments);
    EXPECT_TRUE(eventually([&] {
      return fs::exists(run + "/metadata.yaml") && count_in(run, "/chatter") >= messages;
    }));
    EXPECT_EQ(recorder.end(signal), code);
  }

  const TemporaryFolder folder;
  const std::string run = folder.path("run");
};

TEST_F(BagProgram, RecordsWhatIsSaidAndPlaysItAgain) {
  record({"-a"}, 30, SIGINT, 0);
  bag::BagReader reader(run);
  EXPECT_TRUE(reader.damaged().empty());
  EXPECT_EQ(count_in(run, "/mode"), 1U) << "the last sample of a state that was said before";
  const auto& topics = reader.topics();
  for (const auto& one : topics) {
    EXPECT_EQ(one.topic.definition, "string data\n") << one.topic.name;
    ASSERT_EQ(one.topic.offered_qos.size(), 1U);
    EXPECT_EQ(one.topic.offered_qos[0].reliability, bag::OfferedQos::Reliability::reliable);
  }
  const std::uint64_t recorded = count_in(run, "/chatter");

  Listener listener(again);
  Listener modes(mode);
  const Ended played = call({"play", run, "-r", "5", "--remap", "chatter:=again"}, true);
  EXPECT_EQ(played.code, 0) << played.output;
  EXPECT_THAT(played.output,
              HasSubstr("Played " + std::to_string(reader.about().count) + " messages\n"));
  EXPECT_TRUE(eventually([&] { return listener.heard().size() == recorded; }));
  EXPECT_EQ(modes.heard(), std::vector<std::string>{"driving"});
  const auto heard = listener.heard();
  const int first = std::stoi(heard.front().substr(7));
  for (std::size_t i = 0; i < heard.size(); ++i) {
    ASSERT_EQ(heard[i], "number " + std::to_string(first + static_cast<int>(i)));
  }
}

TEST_F(BagProgram, PlaysThePartThatIsWantedWithTheClockOfTheRecording) {
  record({"/chatter"}, 150, SIGINT, 0);
  bag::BagReader reader(run);
  const std::int64_t start_ns = reader.about().start_ns;
  const auto [count, span_s] = part(reader, start_ns + 500'000'000, start_ns + 1'000'000'000);
  const auto graph = make_host_graph(options());
  std::mutex mutex;
  std::vector<std::int64_t> clock_s;
  const auto reading = graph->read({"rt/clock", "rosgraph_msgs::msg::dds_::Clock_", false, false},
                                   [&](RawSample&& sample) {
                                     const std::lock_guard<std::mutex> lock(mutex);
                                     ASSERT_EQ(sample.bytes->size(), 12U);
                                     std::int64_t s = 0;
                                     for (unsigned i = 0; i < 4; ++i)
                                       s |= std::int64_t{(*sample.bytes)[4 + i]} << (8 * i);
                                     clock_s.push_back(s);
                                   });
  const Ended played = call(
      {"play", run, "--start-offset", "0.5", "--playback-duration", "0.5", "--clock", "100"}, true);
  EXPECT_EQ(played.code, 0) << played.output;
  EXPECT_THAT(played.output, HasSubstr("Played " + std::to_string(count) + " messages\n"));
  const std::lock_guard<std::mutex> lock(mutex);
  EXPECT_GE(static_cast<double>(clock_s.size()), 0.4 * 100 * span_s) << "the clock until the last";
  for (const std::int64_t s : clock_s)
    EXPECT_NEAR(static_cast<double>(s), static_cast<double>(start_ns) / 1e9, 3);
}

TEST_F(BagProgram, AKillOfTheRecorderLeavesABagThatRecoverMends) {
  record({"/chatter", "--compression-format", "zstd"}, 30, SIGKILL, 128 + SIGKILL);
  const std::uint64_t safe = count_in(run, "/chatter");
  EXPECT_GE(safe, 30U);
  EXPECT_THAT(call({"info", run}).output, HasSubstr("run_0.mcap has no summary"));
  const Ended recovered = call({"recover", run});
  EXPECT_EQ(recovered.code, 0) << recovered.output;
  EXPECT_THAT(recovered.output,
              HasSubstr("run_0.mcap: " + std::to_string(safe) + " messages; it has no summary"));
  const bag::BagReader mended(run + "_recovered");
  EXPECT_TRUE(mended.damaged().empty());
  EXPECT_EQ(mended.about().count, safe);
}

TEST_F(BagProgram, CopiesBags) {
  record({"-a"}, 10, SIGINT, 0);
  const std::string modes = folder.path("modes");
  const Ended filtered = call({"filter", run, "-o", modes, "--topics", "mode"});
  EXPECT_EQ(filtered.code, 0) << filtered.output;
  EXPECT_THAT(filtered.output, HasSubstr("Wrote 1 messages into " + modes));
  const Ended merged = call({"merge", run, modes, "-o", folder.path("both")});
  EXPECT_EQ(merged.code, 0) << merged.output;
  EXPECT_EQ(count_in(folder.path("both"), "/mode"), 2U);
  const Ended packed =
      call({"convert", run, "-o", folder.path("packed"), "--compression-format", "lz4"});
  EXPECT_EQ(packed.code, 0) << packed.output;
  EXPECT_EQ(count_in(folder.path("packed"), "/chatter"), count_in(run, "/chatter"));
}

TEST_F(BagProgram, RefusesInOneLineWhatCannotBe) {
  for (const auto& [arguments, text] :
       std::vector<std::pair<std::vector<std::string>, const char*>>{
           {{"info", folder.path("absent")}, "absent: cannot be read"},
           {{"recover", folder.path("absent")}, "absent: cannot be read"},
           {{"record", "-o", folder.path()}, "say which topics"},
           {{"record", "-a", "-o", folder.path()}, "is there already"},
           {{"record", "-e", "(", "-o", run}, "'(' is no regular expression"}}) {
    const Ended sut = call(arguments, arguments.front() == "record");
    EXPECT_EQ(sut.code, 2) << sut.output;
    EXPECT_THAT(sut.output, HasSubstr(text));
    EXPECT_EQ(sut.output.find('\n'), sut.output.size() - 1) << sut.output;
  }
}

}  // namespace
}  // namespace tocsin::bag_tool
