// SPDX-License-Identifier: Apache-2.0
// The program as a user runs it, on real DDS, beside something that reports its health.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::top {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int domain = 93;
using LinkMessage = topic::LinkState::Message;

std::unique_ptr<Bus> make_bus() {
  BusOptions options;
  options.name = "top_program_test";
  options.role = Role::uxv;
  options.qos_file = TOCSIN_REPOSITORY "/config/qos.yaml";
  options.traffic_file = TOCSIN_REPOSITORY "/config/traffic.yaml";
  options.host_domain = domain;
  return make_fast_dds_bus(options);
}

diagnostic_msgs::msg::DiagnosticArray report_of(const std::string& name, std::uint8_t level,
                                                const std::string& message) {
  diagnostic_msgs::msg::DiagnosticArray array;
  auto& status = array.status().emplace_back();
  status.name(name);
  status.hardware_id("uxv");
  status.level(level);
  status.message(message);
  status.values().emplace_back().key("rate_hz");
  status.values().back().value("50.00");
  return array;
}

/// Reports two components and a way over the link ten times a second, as long as it lives.
class Reporter {
 public:
  Reporter()
      : bus_(make_bus()),
        publication_(
            bus_->advertise({topic::Diagnostics::info, &type_info<topic::Diagnostics::Message>()})),
        thread_([this] { run(); }) {}
  ~Reporter() {
    ended_ = true;
    thread_.join();
  }
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

 private:
  void run() {
    const auto link = bus_->advertise({topic::LinkState::info, &type_info<LinkMessage>()});
    while (!ended_) {
      LinkMessage state;
      state.role("uxv");
      state.live_peers(1);
      state.capacity_bytes_per_s(180000);
      state.capacity_measured(true);
      (void)link->write(std::make_shared<const LinkMessage>(state));
      for (const auto& one : {report_of("drive/navigator", 0, "active"),
                              report_of("drive/camera", 2, "blocks since 7 s")}) {
        (void)publication_->write(std::make_shared<const topic::Diagnostics::Message>(one));
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  std::atomic<bool> ended_{false};
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Publication> publication_;
  std::thread thread_;
};

Ended top(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), TOP_PROGRAM);
  return run_to_end(arguments);
}

TEST(TopProgram, PrintsOnceWhatReportsTheGravestFirst) {
  const Reporter reporter;
  const Ended ended = top({"--once", "--domain", std::to_string(domain)});
  EXPECT_EQ(ended.code, 0) << ended.output;
  const std::size_t camera = ended.output.find("ERROR drive/camera");
  const std::size_t navigator = ended.output.find("OK    drive/navigator");
  EXPECT_NE(camera, std::string::npos) << ended.output;
  EXPECT_NE(navigator, std::string::npos) << ended.output;
  EXPECT_LT(camera, navigator);
  EXPECT_THAT(ended.output, AllOf(HasSubstr("blocks since 7 s"), HasSubstr("RATE/Hz")));
  EXPECT_LT(ended.output.find("Uplink    180 kB/s"), camera) << "the link stands above all";
  EXPECT_THAT(ended.output, Not(HasSubstr("\x1b"))) << "no colours into a file";
}

TEST(TopProgram, PrintsJsonThatAProgramCanRead) {
  const Reporter reporter;
  const Ended ended = top({"--once", "--json", "--domain", std::to_string(domain)});
  ASSERT_EQ(ended.code, 0) << ended.output;
  const auto rows = nlohmann::json::parse(ended.output);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["name"], "drive/camera");
  EXPECT_EQ(rows[0]["level"], "ERROR");
  EXPECT_EQ(rows[1]["rate_hz"], "50.00");
  EXPECT_LT(rows[1]["report_age_s"].get<double>(), 2.5);
}

TEST(TopProgram, SaysThatNothingReports) {
  const Ended ended = top({"--once", "--domain", std::to_string(domain + 1)});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.output, "tocsin top: nothing reports its health on this host\n");
}

TEST(TopProgram, EndsWithCodeTwoForAWrongCommandLine) {
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--period", "0"}, {"--domain", "300"}}) {
    const Ended ended = top(wrong);
    EXPECT_EQ(ended.code, 2) << wrong[0];
    EXPECT_THAT(ended.output, HasSubstr(wrong[1])) << wrong[0];
  }
}

}  // namespace
}  // namespace tocsin::top
