// SPDX-License-Identifier: Apache-2.0
// tocsin map link, on a drive past an access point.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::map_tool {
namespace {

class LinkProgram : public ::testing::Test {
 protected:
  /// Along y = 2 past (5, 0), by `separator`, with these names.
  std::string drive(const std::string& names, char separator) {
    std::string text = names + "\n";
    for (int i = 0; i < 200; ++i) {
      const double x_m = 0.1 * i;
      const double signal_dbm = -40 - 30 * std::log10(std::hypot(x_m - 5, 2)) + 2 * std::sin(x_m);
      text +=
          std::to_string(x_m) + separator + "2.0" + separator + std::to_string(signal_dbm) + "\n";
    }
    return text;
  }
  Ended link(const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{MAP_PROGRAM, "link", file};
    command.insert(command.end(), more.begin(), more.end());
    return run_to_end(command);
  }
  TemporaryFolder folder_;
};

TEST_F(LinkProgram, ForetellsWhatItWasNotTold) {
  const std::string file = folder_.write("a.csv", drive("x_m,y_m,rssi_dbm", ','));
  const Ended ended = link(file, {"--json"});
  ASSERT_EQ(ended.code, 0) << ended.output;
  const auto json = nlohmann::json::parse(ended.output);
  EXPECT_LT(json["error_db"], 1);
  EXPECT_LT(json["error_db"], json["nearest_error_db"]);
  EXPECT_GT(json["within_95"], 0.9);
  EXPECT_EQ(json["left_out"], 17);
  EXPECT_EQ(link(file, {"--json"}).output, ended.output) << "the same seed leaves out the same";
  EXPECT_NE(link(file, {"--json", "--seed", "2"}).output, ended.output);
  EXPECT_NE(link(file, {"--after", "0.6"}).output.find("map"), std::string::npos);
}

TEST_F(LinkProgram, TakesSpacesSemicolonsOtherNamesAndMoreColumnsThanNames) {
  EXPECT_EQ(link(folder_.write("a.txt", drive("robot_pos_x robot_pos_y C_level_a", ' '))).code, 0);
  std::string text = drive("a;b;c", ';');
  for (std::size_t at = text.find('\n', 8); at != std::string::npos; at = text.find('\n', at + 3)) {
    text.insert(at, ";7");
  }
  EXPECT_EQ(link(folder_.write("b.csv", text), {"--columns", "a,b,c"}).code, 0);
}

TEST_F(LinkProgram, SaysAtWhichSignalHalfIsLostWhereLossIsTold) {
  std::string text = "x_m,y_m,signal_dbm,loss_percent\n";
  for (int i = 0; i < 200; ++i) {
    const double signal_dbm = -50 - 0.25 * i;
    text += std::to_string(0.1 * i) + ",2," + std::to_string(signal_dbm) +
            (signal_dbm < -75 ? ",100\n" : ",0\n");
  }
  const std::string file = folder_.write("l.csv", text);
  const auto json = nlohmann::json::parse(link(file, {"--json"}).output);
  EXPECT_NEAR(json["half_lost_dbm"], -75, 1);
  EXPECT_NE(link(file).output.find("half of the packets are lost at -7"), std::string::npos);
  EXPECT_EQ(link(folder_.write("a.csv", drive("x_m,y_m,rssi_dbm", ','))).output.find("half of"),
            std::string::npos);
}

TEST_F(LinkProgram, HasOneLineForEveryBadInput) {
  const std::string good = drive("x,y,rssi", ',');
  const std::string named = folder_.write("n.csv", good);
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "is empty"},
      {"a,b,c\n1,2,3\n", "line 1 names no column x_m or x"},
      {"x,y,rssi\n1,2\n", ":2: has 2 columns, but rssi is the 3th"},
      {"x,y,rssi\n1,2,strong\n", ":2: rssi: 'strong' is no number"},
      {"x,y,rssi\n1,2,-50\n", "1 places of 0.3 m"},
      {"x,y,rssi\n1,2,102\n", "0 places of 0.3 m"},
  };
  for (const auto& [text, error] : table) {
    const Ended ended = link(folder_.write("b.csv", text));
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_NE(ended.output.find(error), std::string::npos) << ended.output;
  }
  for (const std::vector<std::string>& bad : {std::vector<std::string>{"--leave-out", "1"},
                                              {"--after", "nan"},
                                              {"--leave-out", "nan"},
                                              {"--columns", "x,y"}}) {
    EXPECT_EQ(link(named, bad).code, 2);
  }
  EXPECT_EQ(link(folder_.path("none.csv")).code, 2);
}

/// The drives through an office hall, where they are there.
TEST_F(LinkProgram, ForetellsARealHall) {
  const std::string folder = std::string(TOCSIN_REPOSITORY) + "/../shared/data/rssi/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const char* name : {"Dataset1.datalog", "Dataset3.datalog"}) {
    const auto json = nlohmann::json::parse(link(folder + name, {"--json"}).output);
    EXPECT_LT(json["error_db"], 4.2) << name;
    EXPECT_GT(json["within_95"], 0.85) << name;
  }
}

}  // namespace
}  // namespace tocsin::map_tool
