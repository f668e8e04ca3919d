// SPDX-License-Identifier: Apache-2.0
// The installed program with --real: half a minute of the whole stack in network namespaces.
#include <gmock/gmock.h>

#include "engine/program.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::HasSubstr;

class RealTest : public ExperimentTest {
 protected:
  void SetUp() override {
    ExperimentTest::SetUp();
    const fs::path own = TOCSIN_INSTALL;
    const bool launcher = fs::exists(own / "bin/tocsin-launch") ||
                          fs::exists(own.parent_path() / "tocsin_cli/bin/tocsin-launch");
    if (!launcher) GTEST_SKIP() << "tocsin-launch is not installed";
    if (!fs::exists("/dev/net/tun") || !succeeds("unshare -n true")) {
      GTEST_SKIP() << "no network namespaces and tunnels are permitted here";
    }
  }
};

TEST_F(RealTest, DrivesTheRealStackWithoutCameraAndReportsItBesideTheSimulation) {
  Slice slice;
  slice.kind = "real";
  slice.policies = "  - {name: none}\n";
  slice.duration_s = 30;
  const std::string file = folder_.write("experiment.yaml", text_of(slice));
  const std::string out = folder_.path("out");
  const Ended real = call("run " + file + " --real --jobs 1 --out " + out);
  ASSERT_EQ(real.code, 0) << real.output;
  const auto row = table("out/real.csv");
  ASSERT_EQ(row.rows(), 1U);
  EXPECT_EQ(row.text(0, "failure"), "");
  EXPECT_GT(row.number(0, "seconds"), 20);
  EXPECT_GT(row.number(0, "qni_mean"), 30);
  EXPECT_GT(row.number(0, "high_delivered"), 50);
  EXPECT_EQ(row.text(0, "camera_age_mean"), "") << "payload plain has no camera";

  EXPECT_EQ(call("report " + out).code, 0);
  EXPECT_THAT(folder_.read("out/report.html"), HasSubstr("no simulated runs of these seeds yet"));
  ASSERT_EQ(call("run " + file + " --jobs 1 --out " + out).code, 0);
  EXPECT_EQ(call("report " + out).code, 0);
  EXPECT_THAT(folder_.read("out/report.html"), HasSubstr("Of 1 pairs left out: none 1."));
}

}  // namespace
}  // namespace tocsin::experiment
