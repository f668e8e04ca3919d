// SPDX-License-Identifier: Apache-2.0
// The main job in simulated time: done, repeatable, with every policy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bag/bag_reader.hpp"
#include "foundation/temporary_folder.hpp"
#include "recorded.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

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

/// [m/s] of the vehicle over the two locations before each press of a bumper.
std::vector<double> speeds_at_presses(const std::string& bumper, const std::string& location) {
  const auto numbers = [](const std::string& csv, const std::string& name) {
    std::vector<double> all;
    for (const std::string& word : column(csv, name)) all.push_back(std::stod(word));
    return all;
  };
  const auto at = numbers(location, "receive_s");
  const auto x = numbers(location, "pose.pose.position.x");
  const auto y = numbers(location, "pose.pose.position.y");
  const auto pressed = numbers(bumper, "state");
  const auto pressed_at = numbers(bumper, "receive_s");
  std::vector<double> speeds;
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    if (pressed[i] == 0) continue;
    const auto after = std::upper_bound(at.begin(), at.end(), pressed_at[i]) - at.begin();
    const auto last = static_cast<std::size_t>(after) - 1;
    speeds.push_back(std::hypot(x.at(last) - x.at(last - 1), y.at(last) - y.at(last - 1)) /
                     (at[last] - at[last - 1]));
  }
  return speeds;
}

class SimulationTest : public ::testing::Test {
 protected:
  /// Runs `tocsin sim` with a run folder of its own; what it logs is left out.
  Simulated sim(const std::string& arguments) {
    return run(arguments + " --run-dir " + folder_ + "/" + std::to_string(++runs_));
  }
  [[nodiscard]] Simulated run(const std::string& arguments) const {
    Ended ended = execute("tocsin-sim", arguments);
    auto digests = digests_in(ended.output);
    return {std::move(ended), std::move(digests)};
  }
  /// What `tocsin decide` says of a recorded file, in JSON.
  [[nodiscard]] nlohmann::json decide(const std::string& file, const std::string& arguments) const {
    const Ended ended = execute("tocsin-decide", folder_ + "/" + file + " --json " + arguments);
    EXPECT_EQ(ended.code, 0) << read("errors");
    return nlohmann::json::parse(ended.output, nullptr, false);
  }
  [[nodiscard]] Ended execute(const std::string& name, const std::string& arguments) const {
    const std::string quiet = "sh -c '\"$0\" \"$@\" 2>" + folder_ + "/errors' ";
    return run_to_end(quiet + Stack::program(name), arguments);
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(folder_ + "/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// The fields of a topic that a side of the nth run has recorded.
  [[nodiscard]] std::string recorded(int run, const std::string& side,
                                     const std::string& topic) const {
    return recorded_fields(folder_ + "/" + std::to_string(run) + "/" + side, topic);
  }

  const TemporaryFolder temporary_;
  const std::string folder_ = temporary_.path();
  int runs_ = 0;
};

TEST_F(SimulationTest, FiveVehiclesDriveTheirMissionsOnOneChannel) {
  const Simulated run = sim("fleet.yaml --seed 1 --without camera");
  EXPECT_EQ(run.code, 0) << run.output;
  for (const char* vehicle : {"uxv1", "uxv2", "uxv3", "uxv4", "uxv5"}) {
    const std::string side = vehicle + std::string("/gcs");
    EXPECT_THAT(recorded(1, side, "location"), Not(IsEmpty())) << vehicle;
    const auto states = column(recorded(1, side, "mission_status"), "state");
    EXPECT_EQ(states.empty() ? "none" : states.back(), "done") << vehicle;
    // Which comes from what serves all of them, over the link and back.
    EXPECT_GT(column(recorded(1, side, "airtime_use"), "share").size(), 50U) << vehicle;
  }
}

TEST_F(SimulationTest, MissionAIsDoneAndRecordedOnBothSides) {
  const Simulated run = sim("mission.yaml --seed 1");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("exit code 0"));
  EXPECT_THAT(read("errors"), HasSubstr("mission mission_a: done"));
  for (const auto& [side, topic] : {std::pair("uxv", "location"),
                                    {"gcs", "location"},
                                    {"gcs", "network_quality"},
                                    {"gcs", "camera/image_raw/compressed"},
                                    {"uxv", "goal"}}) {
    EXPECT_GT(recorded(1, side, topic).size(), 200U) << side << topic;
  }
}

TEST_F(SimulationTest, TheVehicleDrivesPastWhatNoMapShowsAndKnowsWhereItIs) {
  const Simulated run = sim("obstacles.yaml --seed 1 --set 'recorder.topics=[\"events/*\"]'");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(read("errors"), HasSubstr("mission mission_a: done"));
  EXPECT_THAT(read("errors"), HasSubstr("[localiser] tracked"));
  EXPECT_THAT(read("errors"), Not(HasSubstr("[localiser] lost")));
  const std::string messages = recorded_messages(folder_ + "/1/uxv");
  EXPECT_NE(messages.find(",events/robot_state,"), std::string::npos);
  const auto speeds =
      speeds_at_presses(recorded(1, "uxv", "events/bumper"), recorded(1, "uxv", "location"));
  for (const double speed_mps : speeds) {
    EXPECT_LT(speed_mps, 0.05) << "it bumps into nobody, whoever walks into it while it stands";
  }
}

TEST(SpeedsAtPresses, AreThoseOfTheTwoLocationsBefore) {
  const std::string bumper = "receive_s,state\n11,1\n11.5,0\n13.1,1\n";
  const std::string location =
      "receive_s,pose.pose.position.x,pose.pose.position.y\n9,0,0\n10,3,4\n12,3,4\n13,3,4.5\n14,9,"
      "9\n";
  EXPECT_THAT(speeds_at_presses(bumper, location), ::testing::ElementsAre(5, 0.5));
  EXPECT_THAT(speeds_at_presses("", location), ::testing::IsEmpty());
}

TEST_F(SimulationTest, TheVehicleOutlivesFaultsOfItsLaserItsWheelsAndAHandThatCarriesItOff) {
  const Simulated five =
      run("obstacles.yaml --faults random --seeds 1..5 --check --without uxv/recorder --without "
          "gcs/recorder");
  EXPECT_EQ(five.code, 0) << five.output;
}

TEST_F(SimulationTest, TheVehicleLearnsWhereItsLinkIsLostAndTakesOtherWays) {
  const Simulated run = sim("foresight.yaml --seed 1 --set 'recorder.topics=[\"plan/*\"]'");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(read("errors"), HasSubstr("mission mission_c: done"));
  const std::string choices = recorded(1, "uxv", "plan/choice");
  const auto silent_s = column(choices, "silence_s");
  const auto shortest_s = column(choices, "shortest_silence_s");
  ASSERT_EQ(silent_s.size(), shortest_s.size());
  bool has_saved = false;
  for (std::size_t i = 0; i < silent_s.size(); ++i) {
    has_saved = has_saved || std::stod(silent_s[i]) < 0.5 * std::stod(shortest_s[i]);
  }
  EXPECT_TRUE(has_saved) << choices;
}

/// [s] The longest wait for a heartbeat of the vehicle.
double longest_silence_s(const std::string& heartbeats) {
  const auto roles = column(heartbeats, "role");
  const auto received = column(heartbeats, "receive_s");
  double longest_s = 0;
  std::optional<double> last_s;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != "uxv") continue;
    const double at_s = std::stod(received[i]);
    longest_s = std::max(longest_s, at_s - last_s.value_or(at_s));
    last_s = at_s;
  }
  return longest_s;
}

TEST_F(SimulationTest, ASecondPathCarriesTheMissionWhenTheFirstIsDeadForHalfAMinute) {
  const std::string channel =
      temporary_.write("dies.yaml", "extends: " + Stack::share("config/radio/classroom.yaml") +
                                        "\nradio_channel: {outages_s: [20, 30]}\n");
  const std::string words =
      " --seed 1 --channel " + channel + " --set 'recorder.topics=[heartbeat]'";
  ASSERT_EQ(sim("two_paths.yaml" + words).code, 0);
  EXPECT_THAT(read("errors"), HasSubstr("mission mission_a: done"));
  ASSERT_EQ(sim("mission.yaml" + words).code, 0);
  EXPECT_LT(longest_silence_s(recorded(1, "gcs", "heartbeat")), 1.5) << "one comes each second";
  EXPECT_GT(longest_silence_s(recorded(2, "gcs", "heartbeat")), 25);
}

TEST_F(SimulationTest, ASecondSiteCarriesTheMissionWhileTheRouterOfTheFirstIsFrozen) {
  const std::string faults = temporary_.write(
      "faults.yaml", "faults: [{kind: freeze, at_s: 20, for_s: 30, target: gcs/link}]\n");
  ASSERT_EQ(
      sim("two_sites.yaml --seed 1 --faults " + faults + " --set 'recorder.topics=[heartbeat]'")
          .code,
      0);
  const std::string said = read("errors");
  EXPECT_THAT(said, HasSubstr("south is the site from now on"));
  EXPECT_THAT(said, HasSubstr("gcs is the site from now on"));
  EXPECT_THAT(said, HasSubstr("mission mission_a: done"));
  EXPECT_GT(longest_silence_s(recorded(1, "gcs", "heartbeat")), 25);
  const auto at_south = column(recorded(1, "south/gcs", "heartbeat"), "role");
  EXPECT_GE(std::count(at_south.begin(), at_south.end(), "uxv"), 25) << "one comes each second";
}

TEST_F(SimulationTest, ASurveyIsDoneWithAModelOfTheLocaliser) {
  const Simulated run = sim("survey.yaml --seed 1 --set modelled_localiser.lost_every_s=60");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(read("errors"), HasSubstr("mission mission_c: done"));
}

TEST_F(SimulationTest, TheBagOfEachSideSaysWhatItsTypesAre) {
  const Simulated run = sim("mission.yaml --seed 1");
  ASSERT_EQ(run.code, 0) << run.output;
  for (const std::string side : {"uxv", "gcs"}) {
    const bag::BagReader bag(folder_ + "/1/" + side + "/bag");
    std::map<std::string, std::uint64_t> counts;
    for (const auto& [topic, count] : bag.topics()) {
      EXPECT_EQ(topic.definition_encoding, "ros2msg") << topic.name;
      counts[topic.name] = count;
    }
    EXPECT_GT(counts["/camera/image_raw/compressed"], 100U) << side;
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
  EXPECT_THAT(recorded(1, "uxv", "odom"), HasSubstr(",odom,base_footprint,"));
  const std::string messages = recorded_messages(folder_ + "/1/uxv");
  EXPECT_THAT(messages, HasSubstr(",sensors/core,"));
  EXPECT_THAT(messages, HasSubstr(",events/robot_state,"));
  EXPECT_THAT(messages, Not(HasSubstr(",imu_data,"))) << "nobody asked for it";
}

TEST_F(SimulationTest, ARunOfTheMainJobLosesNothingOfClassCritical) {
  ASSERT_EQ(sim("mission.yaml --seed 7").code, 0) << read("errors");
  const std::string state = recorded(1, "gcs", "link_state");
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
    const auto decided = decide("1/" + std::string(role), "--host " + std::string(role));
    EXPECT_EQ(decided["recorded"]["pauses"], 2) << role;
    EXPECT_EQ(decided["pauses"], 2) << role;
    EXPECT_GT(decided["recorded"]["decisions"], 50) << role;
    EXPECT_EQ(decided["recorded"]["same"], decided["recorded"]["decisions"]) << role;
  }
  EXPECT_EQ(execute("tocsin-decide", folder_ + "/1/uxv").code, 2);
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
  for (const char* side : {"uxv", "gcs"}) {
    const std::string first = recorded_messages(folder_ + "/1/first/" + side);
    EXPECT_GT(first.size(), 1000U);
    EXPECT_EQ(first, recorded_messages(folder_ + "/2/" + side)) << side;
  }
  EXPECT_EQ(recorded_fields(folder_ + "/1/first/gcs", "location"), recorded(2, "gcs", "location"));
}

/// A recorder reads there what the operator's page reads, from the station's own copies.
TEST_F(SimulationTest, WhoeverReadsAtTheStationCostsTheRadioNotAByte) {
  const std::string mission = "mission.yaml --seed 3 --duration 60";
  const Simulated without = sim(mission);
  const Simulated with = sim(mission + " --set operator_recorder.recording=true");
  ASSERT_EQ(without.digests.size(), 1U) << without.output;
  EXPECT_EQ(with.digests, without.digests);
  for (const char* side : {"uxv", "gcs"}) {  // with the bytes of each class that left the router
    const std::string told = recorded(1, side, "link_state");
    EXPECT_GT(told.size(), 1000U);
    EXPECT_EQ(recorded(2, side, "link_state"), told) << side;
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
  std::ofstream(folder_ + "/1/summary.txt") << "old\n";
  EXPECT_EQ(sim("mission.yaml --duration 1").code, 2);
  EXPECT_THAT(read("errors"), HasSubstr("is not empty"));
}

}  // namespace
}  // namespace tocsin
