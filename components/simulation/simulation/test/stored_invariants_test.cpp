// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "core.hpp"
#include "foundation/temporary_folder.hpp"
#include "sample_log/sample_log.hpp"
#include "simulation/invariants.hpp"

namespace tocsin::simulation {
namespace {

class StoredInvariantsTest : public ::testing::Test {
 protected:
  StoredInvariantsTest() {
    end_.host = "uxv";
    end_.process = "telemetry";
    end_.topic = "battery";
    end_.stored = true;
  }
  void log(std::uint64_t written) { sut_.on_logged({end_, start_time, written, 7}); }
  void give(std::uint64_t written, GivenAs as) {
    sut_.on_given({end_, gcs_, start_time, written, as});
  }
  void end() { sut_.on_logs(folder_.path(), {}); }
  [[nodiscard]] std::size_t broken() const { return sut_.violations().size(); }

  Invariants sut_;
  TopicEnd end_;
  const std::string gcs_ = "gcs";
  TemporaryFolder folder_;
};

TEST_F(StoredInvariantsTest, WhatWasLoggedIsDeliveredLiveOrByBackfill) {
  for (const std::uint64_t written : {1, 2, 3}) log(written);
  give(1, GivenAs::live);
  give(3, GivenAs::live);
  give(2, GivenAs::backfilled);
  end();
  EXPECT_EQ(broken(), 0U);
}

TEST_F(StoredInvariantsTest, OneThatIsNeitherDeliveredNorInTheLogIsLost) {
  log(1);
  log(2);
  give(1, GivenAs::live);
  end();
  ASSERT_EQ(broken(), 1U);
  EXPECT_EQ(sut_.violations()[0].text, "a stored sample is lost: uxv/telemetry battery 2");
}

TEST_F(StoredInvariantsTest, OneThatStillWaitsInTheLogIsNotLost) {
  {
    sample_log::FolderFiles files(folder_.path("uxv/store"));
    sample_log::SampleLog log(files, {}, {start_time, 0});
    log.add({"battery|", "/battery", {}, {}});
    EXPECT_EQ(
        log.append({{{sample_log::stream_key("battery|"), 7, 2}, 0, {1}}}, {start_time, 0})[0],
        sample_log::Logged::kept);
  }
  log(2);
  end();
  EXPECT_EQ(broken(), 0U);
}

TEST_F(StoredInvariantsTest, NoneIsDeliveredTwice) {
  give(1, GivenAs::backfilled);
  give(1, GivenAs::backfilled);
  EXPECT_EQ(broken(), 2U) << "and not in order";
  give(1, GivenAs::live);
  EXPECT_EQ(broken(), 3U);
}

TEST_F(StoredInvariantsTest, ButLateReadersGetAStateAgainAndOfOtherTopicsNothingIsSaid) {
  end_.durable = true;
  give(1, GivenAs::backfilled);
  give(1, GivenAs::live);
  end_.durable = false;
  end_.stored = false;
  give(9, GivenAs::live);
  give(9, GivenAs::live);
  end();
  EXPECT_EQ(broken(), 0U);
}

TEST_F(StoredInvariantsTest, WhatIsBackfilledIsInOrder) {
  give(2, GivenAs::backfilled);
  give(5, GivenAs::live);
  give(3, GivenAs::backfilled);
  EXPECT_EQ(broken(), 0U);
  give(1, GivenAs::backfilled);
  EXPECT_EQ(broken(), 1U);
}

}  // namespace
}  // namespace tocsin::simulation
