// SPDX-License-Identifier: Apache-2.0
#include "pages.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "session_rig.hpp"

namespace tocsin::kobuki {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// What a page says of a base that a session has run with for a second.
template <class Page>
std::string shown(SessionRig& rig, Page page) {
  const auto session = rig.open();
  session->run_for(seconds(1));
  return page(session->driver(), *session->last());
}

TEST(InfoPage, TellsVersionsIdBatteryAndGains) {
  SessionRig rig;
  EXPECT_THAT(shown(rig, info_page),
              AllOf(HasSubstr("hardware  1.0.4"), HasSubstr("firmware  1.2.0 (recommended)"),
                    HasSubstr("gains     P 100, I 0.1, D 2 (of the firmware)"), HasSubstr(" V, ")));
}

TEST(InfoPage, SaysWhatAnOldBaseDoesNotTell) {
  ModelParams base;
  base.firmware = "1.1.0";
  base.old_versions = true;
  SessionRig rig(base);
  EXPECT_THAT(shown(rig, info_page), AllOf(HasSubstr("firmware  1.1.0 (should be replaced"),
                                           HasSubstr("gains     unknown")));
}

TEST(WatchPage, ShowsWhatIsTouchedInEightyColumns) {
  SessionRig rig;
  rig.model().inputs().bumper = left_bit;
  rig.model().inputs().buttons = 2;
  rig.model().inputs().wheel_drop = right_bit;
  const std::string sut = shown(rig, watch_page);
  EXPECT_THAT(sut, AllOf(HasSubstr("bumper      LEFT   .      .  "), HasSubstr("B1"),
                         HasSubstr("wheel drop    .   RIGHT"), HasSubstr("online")));
  std::istringstream page(sut);
  for (std::string line; std::getline(page, line);) EXPECT_LE(line.size(), 80U) << line;
}

}  // namespace
}  // namespace tocsin::kobuki
