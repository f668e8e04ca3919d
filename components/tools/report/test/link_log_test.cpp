// SPDX-License-Identifier: Apache-2.0
#include "report/link_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "toy_run.hpp"

namespace tocsin::report {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string first = R"({"elapsed_s":1,"mean_snr_db":20.5,"busy_share":0.5,"late_ms":2,)"
                          R"("uplink":{"airtime_s":0.25,"bytes_pushed":1000},)"
                          R"("downlink":{"airtime_s":0.5,"bytes_pushed":200}})"
                          "\n";
const std::string second = R"({"elapsed_s":2.5,"mean_snr_db":null,"busy_share":1,"late_ms":140,)"
                           R"("uplink":{"airtime_s":0.5,"bytes_pushed":2000},)"
                           R"("downlink":{"airtime_s":0.5,"bytes_pushed":400}})"
                           "\n";

TEST(LinkLog, AddsBothDirectionsUp) {
  ToyRun run;
  run.write("radio.jsonl", first);
  const auto sut = read_link_log(run.path("radio.jsonl"));
  ASSERT_THAT(sut, SizeIs(1));
  EXPECT_EQ(sut[0].mean_snr_db, 20.5);
  EXPECT_EQ(sut[0].airtime_s, 0.75);
  EXPECT_EQ(sut[0].bytes, 1200);
}

TEST(LinkLog, CountsBackFromTheLastChangeOfTheFile) {
  ToyRun run;
  run.write("radio.jsonl", first + second);
  const auto sut = read_link_log(run.path("radio.jsonl"));
  ASSERT_THAT(sut, SizeIs(2));
  EXPECT_NEAR(sut[1].time_s - sut[0].time_s, 1.5, 1e-6);
  EXPECT_GT(sut[1].time_s, 1e9);
  EXPECT_TRUE(std::isnan(sut[1].mean_snr_db));
  EXPECT_EQ(sut[1].late_ms, 140);
}

TEST(LinkLog, LeavesOutALineThatWasCutOff) {
  ToyRun run;
  run.write("radio.jsonl", first + second.substr(0, 30));
  EXPECT_THAT(read_link_log(run.path("radio.jsonl")), SizeIs(1));
}

TEST(LinkLog, IsEmptyWithoutAFile) {
  EXPECT_THAT(read_link_log("/nonexistent/radio.jsonl"), IsEmpty());
}

}  // namespace
}  // namespace tocsin::report
