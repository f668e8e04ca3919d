// SPDX-License-Identifier: Apache-2.0
#include "kobuki_protocol/version.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace tocsin::kobuki {
namespace {

Version v(int major, int minor, int patch) {
  return {static_cast<std::uint8_t>(major),
          static_cast<std::uint8_t>(minor),
          static_cast<std::uint8_t>(patch),
          {}};
}

TEST(Version, ReadsOldCodes) {
  EXPECT_EQ(to_text(hardware_from_old_code(104)), "1.0.4");
  for (const auto& [code, text] : {std::pair<std::uint16_t, const char*>(123, "1.0.0"),
                                   {110, "1.1.0"},
                                   {10100, "1.1.0"},
                                   {111, "1.1.1"},
                                   {10101, "1.1.1"}}) {
    EXPECT_EQ(to_text(firmware_from_old_code(code)), text);
  }
}

TEST(Version, JudgesFirmware) {
  const std::pair<Version, FirmwareSupport> rows[] = {
      {v(0, 9, 0), FirmwareSupport::refused},        {v(2, 0, 0), FirmwareSupport::refused},
      {v(1, 1, 3), FirmwareSupport::replace},        {v(1, 1, 4), FirmwareSupport::recommended},
      {v(1, 1, 5), FirmwareSupport::replace},        {v(1, 2, 0), FirmwareSupport::recommended},
      {v(1, 2, 1), FirmwareSupport::software_behind}};
  for (const auto& [version, support] : rows) {
    EXPECT_EQ(judge_firmware(version), support) << to_text(version);
  }
  EXPECT_FALSE(has_gains(v(1, 1, 4)));
  EXPECT_TRUE(has_gains(v(1, 2, 0)));
  EXPECT_EQ(feature_bits(v(1, 0, 0)), 0U);
  EXPECT_EQ(feature_bits(v(1, 1, 0)), 3U);
  EXPECT_TRUE(v(1, 1, 9) < v(1, 2, 0));
  EXPECT_FALSE(v(1, 2, 0) < v(1, 2, 0));
}

}  // namespace
}  // namespace tocsin::kobuki
