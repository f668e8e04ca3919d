// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/channel_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "geometry/wall_file.hpp"

namespace tocsin::radio {
namespace {

using ::testing::HasSubstr;

std::string written(const std::string& text) {
  const std::string path = ::testing::TempDir() + "channel_files_test_" +
                           ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::ofstream(path) << text;
  return path;
}

template <class Load>
std::string error_of(const Load& load, const std::string& text) {
  try {
    (void)load(written(text));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(TraceFile, IsReadByTheNamesOfItsColumns) {
  const std::string trace = written("time_s,x_m,ping_delay_ms,rssi_dbm\n0,1,20,-40\n2,1,,-60\n");
  const Trace sut = load_trace(trace);
  EXPECT_DOUBLE_EQ(sut.rssi_dbm(1), -50);
  EXPECT_DOUBLE_EQ(sut.one_way_s(0), 0.01);
}

TEST(TraceFile, NamesTheColumnThatIsMissing) {
  EXPECT_THAT(error_of(load_trace, "time_s,rssi_dbm\n0,-40\n"), HasSubstr("ping_delay_ms"));
}

TEST(TraceFile, NamesTheFileOfABadTrace) {
  EXPECT_THAT(error_of(load_trace, "time_s,rssi_dbm,ping_delay_ms\n0,-40,\n1,x,\n"),
              HasSubstr("channel_files_test_NamesTheFileOfABadTrace"));
}

TEST(ChannelFile, LoadsItsTraceFromBesideIt) {
  std::ofstream(::testing::TempDir() + "beside.csv")
      << "time_s,rssi_dbm,ping_delay_ms\n0,-40,1\n2,-60,1\n";
  const auto sut = load_channel(written("radio_channel: {trace_file: beside.csv}"));
  ASSERT_TRUE(sut.trace);
  EXPECT_DOUBLE_EQ(sut.trace->length_s(), 2);
  EXPECT_THAT(error_of(load_channel, "radio_channel: {trace_file: nowhere.csv}"),
              HasSubstr("nowhere.csv"));
}

/// As files of a finished edit are: FileCache reads younger ones each time.
std::string settled(const std::string& path) {
  std::filesystem::last_write_time(
      path, std::filesystem::file_time_type::clock::now() - std::chrono::minutes(1));
  return path;
}

TEST(ChannelFile, SharesATraceUntilTheTraceItselfChanges) {
  const std::string trace = ::testing::TempDir() + "shared.csv";
  std::ofstream(trace) << "time_s,rssi_dbm,ping_delay_ms\n0,-40,1\n2,-60,1\n";
  settled(trace);
  const std::string path = settled(written("radio_channel: {trace_file: shared.csv}"));
  const auto first = load_channel(path).trace;
  EXPECT_EQ(load_channel(path).trace, first);
  std::ofstream(trace) << "time_s,rssi_dbm,ping_delay_ms\n0,-40,1\n30,-60,1\n";
  EXPECT_DOUBLE_EQ(load_channel(path).trace->length_s(), 30);
}

TEST(ChannelFile, IsReadAgainWhenItHasChanged) {
  const std::string path = settled(written("radio_channel: {loss: 0.25}"));
  EXPECT_EQ(load_channel(path).loss, 0.25);
  EXPECT_EQ(load_channel(path).loss, 0.25);
  EXPECT_EQ(load_channel(written("radio_channel: {loss: 0.75}")).loss, 0.75);
}

TEST(ChannelFile, KeepsDefaultsAndReadsWhatItNames) {
  const auto sut = load_channel(written("radio_channel: {mode: bernoulli, loss: 0.25}"));
  EXPECT_EQ(sut.mode, "bernoulli");
  EXPECT_EQ(sut.loss, 0.25);
  EXPECT_EQ(sut.attempts, 7);
}

TEST(ChannelFile, MayExtendAnotherBesideIt) {
  const std::string base = ::testing::TempDir() + "extended_base.yaml";
  std::ofstream(base) << "radio_channel: {attempts: 4, tx_dbm: 3}\n";
  const std::string own =
      written("extends: extended_base.yaml\nradio_channel: {access_categories: true, tx_dbm: 5}\n");
  const auto sut = load_channel(own);
  EXPECT_TRUE(sut.access_categories);
  EXPECT_EQ(sut.attempts, 4);
  EXPECT_EQ(sut.tx_dbm, 5);
  EXPECT_THAT(channel_sources(own), ::testing::UnorderedElementsAre(own, base));
}

TEST(ChannelFile, HasTheTraceOfItsBaseFromBesideTheBase) {
  const std::string folder = ::testing::TempDir() + "traced";
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "/link.csv") << "time_s,rssi_dbm,ping_delay_ms\n0,-40,1\n2,-60,1\n";
  std::ofstream(folder + "/base.yaml") << "radio_channel: {trace_file: link.csv}\n";
  const auto sut = load_channel(written("extends: traced/base.yaml\n"));
  ASSERT_TRUE(sut.trace);
  EXPECT_DOUBLE_EQ(sut.trace->length_s(), 2);
}

TEST(ChannelFile, NamesTheFileOfAMistakeInItsBase) {
  std::ofstream(::testing::TempDir() + "wrong_base.yaml") << "radio_channel: {loss: 2}\n";
  EXPECT_THAT(error_of(load_channel, "extends: wrong_base.yaml\n"),
              HasSubstr("wrong_base.yaml:1)"));
  EXPECT_THAT(error_of(load_channel, "extends: nowhere.yaml\n"), HasSubstr("nowhere.yaml"));
}

TEST(ChannelFile, NamesKeyValueAndRange) {
  EXPECT_THAT(error_of(load_channel, "radio_channel:\n  loss: 1.5"),
              HasSubstr("radio_channel.loss: 1.5 is outside [0, 1]"));
  EXPECT_THAT(error_of(load_channel, "radio_channel: {lost: 1}"), HasSubstr("unknown key"));
  EXPECT_THAT(error_of(load_channel, "radio_channel: {mode: magic}"), HasSubstr("not one of"));
  EXPECT_THAT(error_of(load_channel, "radio_channel: {outages_s: [1]}"), HasSubstr("pairs"));
  EXPECT_THAT(error_of(load_channel, "loss: 0.1"), HasSubstr("radio_channel"));
  EXPECT_THAT(error_of(load_channel, "{radio_channel: {}, loss: 0.1}"), HasSubstr("one key"));
  EXPECT_THROW((void)load_channel("/does/not/exist.yaml"), ConfigError);
}

TEST(Readme, ShowsTheParametersAsTheyAre) {
  std::ostringstream readme;
  readme << std::ifstream(TOCSIN_SOURCE_DIR "/README.md").rdbuf();
  EXPECT_THAT(readme.str(), HasSubstr(default_yaml<ChannelParams>()));
}

TEST(ShippedFiles, AllLoad) {
  const std::string config = std::string(TOCSIN_REPOSITORY) + "/config/";
  for (const char* name :
       {"classroom", "classroom_mission_b", "open", "bernoulli", "thesis_a", "thesis_b",
        "thesis_a_categories", "thesis_b_categories", "weak_a", "weak_b", "replay"}) {
    EXPECT_NO_THROW((void)load_channel(config + "radio/" + name + ".yaml")) << name;
  }
  EXPECT_GT(geometry::load_walls(config + "maps/classroom.walls.yaml").size(), 5u);
}

}  // namespace
}  // namespace tocsin::radio
