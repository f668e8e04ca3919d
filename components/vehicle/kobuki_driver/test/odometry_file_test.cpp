// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/odometry_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tocsin::kobuki {
namespace {

TEST(OdometryFile, KeepsOdometryForProcessesOfOneParent) {
  const std::string path = ::testing::TempDir() + "kobuki_odometry";
  OdometryFile sut(path);
  OdometrySnapshot snapshot;
  snapshot.pose = {1.25, -2.5, 0.3};
  snapshot.core.left_encoder = 65000;
  snapshot.core.timestamp_ms = 777;
  snapshot.inertia = Inertia{-1500, 0};
  ASSERT_TRUE(sut.save({snapshot, Time(std::chrono::seconds(5))}));
  const auto got = sut.load();
  ASSERT_TRUE(got);
  EXPECT_EQ(got->odometry.pose.y_m, -2.5);
  EXPECT_EQ(got->odometry.core.left_encoder, 65000);
  EXPECT_EQ(got->odometry.inertia->angle_cdeg, -1500);
  EXPECT_EQ(got->taken, Time(std::chrono::seconds(5)));
  ASSERT_TRUE(StateFile(path).save("1 2 3 4 5 6 7 8 9 10 11 12"));  // another parent
  EXPECT_FALSE(sut.load());
  ASSERT_TRUE(StateFile(path).save("garbage"));
  EXPECT_FALSE(sut.load());
  ::unlink(path.c_str());
  EXPECT_FALSE(sut.load());
}

TEST(OdometryFile, KeepsNothingWithoutAPath) {
  OdometryFile sut("");
  EXPECT_TRUE(sut.save({}));
  EXPECT_FALSE(sut.load());
}

}  // namespace
}  // namespace tocsin::kobuki
