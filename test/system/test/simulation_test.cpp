// SPDX-License-Identifier: Apache-2.0
// The main job in simulated time: done, repeatable, with every policy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "bag/bag_reader.hpp"
#include "foundation/csv_table.hpp"
#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

struct Simulated : Ended {
  std::vector<std::string> digests;
};

std::vector<std::string> digests_in(const std::string& text) {
  const std::string word = "digest ";
  std::vector<std::string> digests;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    digests.push_back(text.substr(at + word.size(), 16));
  }
  return digests;
}

class SimulationTest : public ::testing::Test {
 protected:
  /// Runs `tocsin sim` with a run folder of its own; what it logs is left out.
  Simulated sim(const std::string& arguments) {
    return run(arguments + " --run-dir " + folder_ + "/" + std::to_string(++runs_));
  }
  [[nodiscard]] Simulated run(const std::string& arguments) const {
    Ended ended = execute("simulation", "tocsin-sim", arguments);
    auto digests = digests_in(ended.output);
    return {std::move(ended), std::move(digests)};
  }
  /// What `tocsin decide` says of a recorded file, in JSON.
  [[nodiscard]] nlohmann::json decide(const std::string& file, const std::string& arguments) const {
    const Ended ended =
        execute("decision_tools", "tocsin-decide", folder_ + "/" + file + " --json " + arguments);
    EXPECT_EQ(ended.code, 0) << read("errors");
    return nlohmann::json::parse(ended.output, nullptr, false);
  }
  [[nodiscard]] Ended execute(const std::string& package, const std::string& name,
                              const std::string& arguments) const {
    const std::string quiet = "sh -c '\"$0\" \"$@\" 2>" + folder_ + "/errors' ";
    return run_to_end(quiet + Stack::program(package, name), arguments);
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(folder_ + "/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_.path();
  int runs_ = 0;
};

TEST_F(SimulationTest, MissionAIsDoneAndRecordedOnBothSides) {
  const Simulated run = sim("mission.yaml --seed 1");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("exit code 0"));
  EXPECT_THAT(read("errors"), HasSubstr("mission mission_a: done"));
  for (const char* file : {"1/uxv/location.csv", "1/gcs/location.csv", "1/gcs/network_quality.csv",
                           "1/gcs/camera.image_raw.compressed.csv", "1/uxv/goal.csv"}) {
    EXPECT_GT(read(file).size(), 200U) << file;
  }
}

TEST_F(SimulationTest, TheBagOfEachSideHoldsEveryMessageOfItsCsvFiles) {
  const Simulated run = sim("mission.yaml --seed 1");
  ASSERT_EQ(run.code, 0) << run.output;
  for (const std::string side : {"uxv", "gcs"}) {
    const CsvTable rows = CsvTable::load(folder_ + "/1/" + side + "/messages.csv");
    std::map<std::string, std::uint64_t> in_csv;
    for (std::size_t i = 0; i < rows.rows(); ++i) ++in_csv["/" + rows.text(i, "topic")];
    const bag::BagReader bag(folder_ + "/1/" + side + "/bag");
    std::map<std::string, std::uint64_t> in_bag;
    for (const auto& [topic, count] : bag.topics()) {
      EXPECT_EQ(topic.definition_encoding, "ros2msg") << topic.name;
      if (count > 0) in_bag[topic.name] = count;
    }
    EXPECT_EQ(in_bag, in_csv) << side;
    EXPECT_GT(in_bag["/camera/image_raw/compressed"], 100U) << side;
    EXPECT_TRUE(bag.damaged().empty());
  }
}

TEST_F(SimulationTest, LogLinesCarryTheSimulatedTime) {
  const Simulated run = sim("mission.yaml --seed 1 --without uxv/payload");
  ASSERT_EQ(run.code, 0) << run.output;
  const int s = std::atoi(run.output.c_str());  // "91.196 s simulated"
  char time[40];
  std::snprintf(time, sizeof time, "00:%02d:%02d.", s / 60, s % 60);
  const std::string log = read("errors");
  const auto line = log.rfind('\n', log.find("mission mission_a: done")) + 1;
  EXPECT_EQ(log.substr(line, 9), time) << log.substr(line, 80);
  EXPECT_EQ(log.substr(0, 6), "00:00:");
}

TEST_F(SimulationTest, TheRecorderRecordsTheTopicsThatItIsToldByNameAndByPattern) {
  const Simulated run =
      sim("mission.yaml --duration 5 --set 'recorder.topics=[odom, sensors/core, \"events/*\"]'");
  ASSERT_EQ(run.code, 0) << read("errors");
  EXPECT_THAT(read("1/uxv/odom.csv"), HasSubstr(",odom,base_footprint,"));
  EXPECT_GT(read("1/uxv/sensors.core.csv").size(), 1000U);
  EXPECT_FALSE(read("1/uxv/events.robot_state.csv").empty());
  EXPECT_TRUE(read("1/uxv/imu_data.csv").empty()) << "nobody asked for it";
}

TEST_F(SimulationTest, ARunOfTheMainJobLosesNothingOfClassCritical) {
  ASSERT_EQ(sim("mission.yaml --seed 7").code, 0) << read("errors");
  const std::string state = read("1/gcs/link_state.csv");
  const auto last = state.rfind("\"traffic_class\"\":\"\"critical\"\"");
  ASSERT_NE(last, std::string::npos);
  const auto number = [&](const std::string& key) {
    return std::atoi(state.c_str() + state.find(key + "\"\":", last) + key.size() + 3);
  };
  EXPECT_GT(number("delivered"), 200);
  EXPECT_LE(number("lost"), number("delivered") / 100);
}

TEST_F(SimulationTest, DecidingARecordedRunAgainGivesItsOwnDecisionsSampleBySample) {
  // Either side's recording, of a run whose parameters are not the defaults and that pauses twice.
  ASSERT_EQ(sim("mission.yaml --seed 7 --without uxv/payload "
                "--set transmission_controller.policy=tocp_dsp")
                .code,
            0)
      << read("errors");
  for (const char* role : {"uxv", "gcs"}) {
    const auto decided =
        decide("1/" + std::string(role) + "/transmission_state.csv", "--host " + std::string(role));
    EXPECT_EQ(decided["recorded"]["pauses"], 2) << role;
    EXPECT_EQ(decided["pauses"], 2) << role;
    EXPECT_GT(decided["recorded"]["decisions"], 50) << role;
    EXPECT_EQ(decided["recorded"]["same"], decided["recorded"]["decisions"]) << role;
  }
  EXPECT_EQ(
      execute("decision_tools", "tocsin-decide", folder_ + "/1/uxv/transmission_state.csv").code,
      2);
  EXPECT_THAT(read("errors"), HasSubstr("of the roles uxv and gcs; choose one by --host"));
}

TEST_F(SimulationTest, SameSeedGivesTheSameSamplesOnTwoThreadsAndInAnotherProcess) {
  const std::string arguments = "mission.yaml --seed 3 --duration 60";
  const Simulated twice = sim(arguments + " --verify");
  EXPECT_EQ(twice.code, 0) << twice.output;
  const Simulated other = sim(arguments);
  ASSERT_EQ(twice.digests.size(), 2U);
  ASSERT_EQ(other.digests.size(), 1U);
  EXPECT_EQ(twice.digests[0], twice.digests[1]);
  EXPECT_EQ(twice.digests[0], other.digests[0]);
  for (const char* file : {"uxv/messages.csv", "gcs/messages.csv", "gcs/location.csv"}) {
    EXPECT_EQ(read(std::string("1/first/") + file), read(std::string("2/") + file)) << file;
  }
}

/// A recorder reads there what the operator's page reads, from the station's own copies.
TEST_F(SimulationTest, WhoeverReadsAtTheStationCostsTheRadioNotAByte) {
  const std::string mission = "mission.yaml --seed 3 --duration 60";
  const Simulated without = sim(mission);
  const Simulated with = sim(mission + " --set operator_recorder.recording=true");
  ASSERT_EQ(without.digests.size(), 1U) << without.output;
  EXPECT_EQ(with.digests, without.digests);
  for (const char* side : {"uxv", "gcs"}) {  // with the bytes of each class that left the router
    const std::string told = read("1/" + std::string(side) + "/link_state.csv");
    EXPECT_GT(told.size(), 1000U);
    EXPECT_EQ(read("2/" + std::string(side) + "/link_state.csv"), told) << side;
  }
  EXPECT_TRUE(fs::exists(folder_ + "/2/gcs/operator/bag")) << "it has read";
}

TEST_F(SimulationTest, EverySeedGivesARunOfItsOwn) {
  std::set<std::string> digests;
  for (const char* seed : {"1", "2", "3", "4"}) {
    const Simulated run =
        sim(std::string("mission.yaml --without uxv/payload --duration 20 --seed ") + seed);
    ASSERT_EQ(run.digests.size(), 1U) << read("errors");
    digests.insert(run.digests[0]);
  }
  EXPECT_EQ(digests.size(), 4U);
}

TEST_F(SimulationTest, MissionAIsDoneWithEveryPolicy) {
  for (const char* policy : {"none", "threshold", "tocp", "tocp_dsp"}) {
    const Simulated run =
        sim(std::string("mission.yaml --without uxv/payload --duration 600 --set ") +
            "transmission_controller.policy=" + policy);
    EXPECT_EQ(run.code, 0) << policy << "\n" << read("errors");
    EXPECT_THAT(run.output, HasSubstr("exit code 0")) << policy;
  }
}

TEST_F(SimulationTest, EndsAtTheDurationWhenTheMissionIsNotOver) {
  const Simulated run = sim("mission.yaml --without uxv/payload --duration 5");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.output, HasSubstr("5.000 s simulated (not over)"));
}

TEST_F(SimulationTest, TenSeedsOfRandomFaultsBreakNoPromise) {
  const Simulated ten = run("mission.yaml --faults random --seeds 1..10 --jobs 2");
  EXPECT_EQ(ten.code, 0) << ten.output;
  EXPECT_THAT(ten.output, HasSubstr("10 runs, "));
  EXPECT_THAT(ten.output, HasSubstr("0 runs broke a promise"));
}

TEST_F(SimulationTest, SeedsOfRandomFaultsLoseNothingOfStoredTopics) {
  std::ofstream(folder_ + "/local.yaml") << "extends: traffic_store.yaml\n";
  std::ofstream(folder_ + "/store.yaml") << "extends: mission.yaml\ntraffic: local.yaml\n";
  const Simulated some = run(folder_ + "/store.yaml --faults random --seeds 1..8 --jobs 2");
  EXPECT_EQ(some.code, 0) << some.output;
  EXPECT_THAT(some.output, HasSubstr("0 runs broke a promise"));
}

TEST_F(SimulationTest, SeedsOfRandomFaultsBreakNoPromiseWhileTopicsAreLoggedAndStopsAreFetched) {
  std::ofstream(folder_ + "/local.yaml") << "extends: traffic_log.yaml\nuxv:\n  fetch:\n"
                                            "    - {when: safety_status, field: emergency_stop, "
                                            "topics: ['*'], before_s: 10, after_s: 10}\n";
  std::ofstream(folder_ + "/log.yaml") << "extends: mission.yaml\ntraffic: local.yaml\n";
  const Simulated some = run(folder_ + "/log.yaml --faults random --seeds 1..2 --jobs 2");
  EXPECT_EQ(some.code, 0) << some.output;
  EXPECT_THAT(some.output, HasSubstr("0 runs broke a promise"));
}

TEST_F(SimulationTest, RefusesAnUnknownParameter) {
  const Simulated run = sim("mission.yaml --set navigator.speeed=1");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(read("errors"), HasSubstr("navigator.speeed"));
}

TEST_F(SimulationTest, RefusesAFolderThatHoldsAnotherRun) {
  fs::create_directories(folder_ + "/1");
  std::ofstream(folder_ + "/1/messages.csv") << "old\n";
  EXPECT_EQ(sim("mission.yaml --duration 1").code, 2);
  EXPECT_THAT(read("errors"), HasSubstr("is not empty"));
}

}  // namespace
}  // namespace tocsin
