// SPDX-License-Identifier: Apache-2.0
#include "bag_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::bag_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What is understood of a command line; throws what the program answers.
Options parsed(std::vector<std::string> words) {
  Options options;
  CLI::App app;
  declare(app, options);
  std::reverse(words.begin(), words.end());
  app.parse(words);
  complete(app.get_subcommands().front()->get_name(), options);
  return options;
}

std::string refusal_of(const std::vector<std::string>& words) {
  try {
    (void)parsed(words);
  } catch (const ConfigError& error) {
    return error.what();
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "none";
}

TEST(BagOptions, RecordTakesNamesAndOptionsOfRos2Bag) {
  std::istringstream line(
      "record /odom tf -e scan -x image -o run -b 1000000 -d 60 --include-hidden-topics "
      "--no-discovery -p 250 --max-cache-size 5000 -s mcap");
  const Options options = parsed({std::istream_iterator<std::string>(line), {}});
  const RecordOrder& record = options.record;
  EXPECT_THAT(record.topics.topics, ElementsAre("/odom", "tf"));
  EXPECT_EQ(record.topics.regex, "scan");
  EXPECT_EQ(record.topics.exclude_regex, "image");
  EXPECT_TRUE(record.topics.hidden);
  EXPECT_EQ(record.output, "run");
  EXPECT_EQ(record.options.max_bytes, 1'000'000U);
  EXPECT_EQ(record.options.max_duration_s, 60);
  EXPECT_EQ(record.options.compression, mcap::Compression::none);
  EXPECT_FALSE(record.discovery);
  EXPECT_EQ(record.polling_interval_s, 0.25);
  EXPECT_EQ(record.cache_bytes, 5000U);
}

TEST(BagOptions, RecordNeedsToKnowWhichTopics) {
  EXPECT_THAT(refusal_of({"record", "-o", "run"}), HasSubstr("say which topics"));
  EXPECT_TRUE(parsed({"record", "-a"}).record.topics.all);
  EXPECT_THAT(parsed({"record", "--topics", "a", "b"}).record.topics.topics, ElementsAre("a", "b"));
}

TEST(BagOptions, RecordNamesItsFolderByTheTime) {
  EXPECT_THAT(parsed({"record", "-a"}).record.output, StartsWith("rosbag2_20"));
}

TEST(BagOptions, CompressionIsThatOfChunks) {
  const auto of = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"record", "-a"});
    return parsed(words).record.options.compression;
  };
  EXPECT_EQ(of({}), mcap::Compression::none);
  EXPECT_EQ(of({"--compression-mode", "chunk"}), mcap::Compression::zstd);
  EXPECT_EQ(of({"--compression-format", "lz4"}), mcap::Compression::lz4);
  EXPECT_EQ(of({"--compression-mode", "chunk", "--compression-format", "lz4"}),
            mcap::Compression::lz4);
  EXPECT_EQ(of({"--compression-mode", "none", "--compression-format", "lz4"}),
            mcap::Compression::none);
}

TEST(BagOptions, RefusesCompressionThatOnlyRosbag2Unpacks) {
  for (const std::string mode : {"file", "message"}) {
    EXPECT_THAT(refusal_of({"record", "-a", "--compression-mode", mode}),
                HasSubstr("'" + mode + "' packs what only rosbag2 unpacks"));
  }
  EXPECT_THAT(refusal_of({"record", "-a", "--compression-mode", "x"}),
              HasSubstr("neither none nor"));
  EXPECT_THAT(refusal_of({"record", "-a", "--compression-format", "gzip"}), HasSubstr("gzip"));
  EXPECT_THAT(refusal_of({"record", "-a", "-s", "sqlite3"}), HasSubstr("sqlite3"));
}

TEST(BagOptions, PlayTakesTheOptionsOfRos2Bag) {
  const Options options =
      parsed({"play", "run", "-r", "2.5", "-l", "--start-offset", "3", "--playback-duration", "4",
              "-d", "1", "--topics", "/a", "/b", "--remap", "/a:=/x", "/b:=/y"});
  const PlayOrder& play = options.play;
  EXPECT_EQ(play.bag, "run");
  EXPECT_EQ(play.rate, 2.5);
  EXPECT_TRUE(play.loop);
  EXPECT_EQ(play.start_offset_s, 3);
  EXPECT_EQ(play.duration_s, 4);
  EXPECT_EQ(play.delay_s, 1);
  EXPECT_THAT(play.topics.topics, ElementsAre("/a", "/b"));
  EXPECT_EQ(play.remap.at("/a"), "/x");
  EXPECT_EQ(play.remap.at("/b"), "/y");
  EXPECT_EQ(play.clock_hz, 0);
}

TEST(BagOptions, PlayWritesTheClock40TimesASecondOrAsOftenAsIsSaid) {
  EXPECT_EQ(parsed({"play", "run", "--clock"}).play.clock_hz, 40);
  EXPECT_EQ(parsed({"play", "run", "--clock", "100"}).play.clock_hz, 100);
  EXPECT_THAT(refusal_of({"play", "run", "--clock", "0"}), HasSubstr("--clock: '0' is outside"));
  EXPECT_THAT(refusal_of({"play", "run", "--clock", "often"}), HasSubstr("'often' is outside"));
}

TEST(BagOptions, PlayRefusesWhatIsNoRateOrRemapping) {
  EXPECT_NE(refusal_of({"play", "run", "-r", "0"}), "none");
  EXPECT_NE(refusal_of({"play", "run", "-r", "-1"}), "none");
  EXPECT_NE(refusal_of({"play", "run", "--start-offset", "-1"}), "none");
  EXPECT_THAT(refusal_of({"play", "run", "--remap", "/a"}), HasSubstr("OLD_TOPIC:=NEW_TOPIC"));
  EXPECT_NE(refusal_of({"play"}), "none");
}

TEST(BagOptions, CopiesTakeSeveralBagsAndMakeOne) {
  const Options options = parsed({"merge", "a", "b", "-o", "c", "--compression-format", "zstd"});
  EXPECT_THAT(options.rewrite.inputs, ElementsAre("a", "b"));
  EXPECT_EQ(options.rewrite.output, "c");
  EXPECT_EQ(options.rewrite.options.compression, mcap::Compression::zstd);
  EXPECT_EQ(options.rewrite.duration_s, HUGE_VAL);
  EXPECT_THAT(parsed({"convert", "-i", "a", "-o", "c"}).rewrite.inputs, ElementsAre("a"));
  EXPECT_EQ(parsed({"filter", "a", "-o", "c", "-e", "odom"}).rewrite.topics.regex, "odom");
  EXPECT_NE(refusal_of({"merge", "a", "b"}), "none");
}

TEST(BagOptions, InfoAndRecoverTakeABag) {
  EXPECT_EQ(parsed({"info", "run"}).bag, "run");
  EXPECT_EQ(parsed({"recover", "run", "-o", "whole"}).output, "whole");
  EXPECT_NE(refusal_of({"info"}), "none");
}

}  // namespace
}  // namespace tocsin::bag_tool
