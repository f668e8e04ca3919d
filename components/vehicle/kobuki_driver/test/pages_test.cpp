// SPDX-License-Identifier: Apache-2.0
#include "pages.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "model_rig.hpp"

namespace tocsin::kobuki {
namespace {

using ::testing::HasSubstr;

TEST(InfoPage, TellsVersionsIdBatteryAndGains) {
  ModelRig rig;
  rig.run(1);
  const std::string sut = info_page(rig.driver, rig.last);
  EXPECT_THAT(sut, HasSubstr("hardware  1.0.4"));
  EXPECT_THAT(sut, HasSubstr("firmware  1.2.0 (recommended)"));
  EXPECT_THAT(sut, HasSubstr("gains     P 100, I 0.1, D 2 (of the firmware)"));
  EXPECT_THAT(sut, HasSubstr(" V, "));
}

TEST(InfoPage, SaysWhatAnOldBaseDoesNotTell) {
  ModelParams base = exact_model();
  base.firmware = "1.1.0";
  base.old_versions = true;
  ModelRig rig({}, base);
  rig.run(1);
  const std::string sut = info_page(rig.driver, rig.last);
  EXPECT_THAT(sut, HasSubstr("firmware  1.1.0 (should be replaced"));
  EXPECT_THAT(sut, HasSubstr("gains     unknown"));
}

TEST(WatchPage, ShowsWhatIsTouched) {
  ModelRig rig;
  rig.model.inputs().bumper = left_bit;
  rig.model.inputs().buttons = 2;
  rig.model.inputs().wheel_drop = right_bit;
  rig.run(0.5);
  const std::string sut = watch_page(rig.driver, rig.last);
  EXPECT_THAT(sut, HasSubstr("bumper      LEFT   .      .  "));
  EXPECT_THAT(sut, HasSubstr("B1"));
  EXPECT_THAT(sut, HasSubstr("wheel drop    .   RIGHT"));
  EXPECT_THAT(sut, HasSubstr("online"));
}

TEST(WatchPage, FitsIntoEightyColumns) {
  ModelRig rig;
  rig.run(0.5, geometry::Twist{-0.3, -1});
  std::istringstream page(watch_page(rig.driver, rig.last));
  for (std::string line; std::getline(page, line);) EXPECT_LE(line.size(), 80U) << line;
}

}  // namespace
}  // namespace tocsin::kobuki
