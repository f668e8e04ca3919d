// SPDX-License-Identifier: Apache-2.0
#include "container/settings.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(SettingsText, IsAMapInYaml) {
  EXPECT_EQ(settings_text({}), "");
  EXPECT_EQ(settings_text({"rate=5", "name=a=b"}), "rate: 5\nname: a=b\n");
}

TEST(SettingsText, TakesNoValueForAnEmptyText) {
  EXPECT_EQ(settings_text({"name="}), "name: ''\n");
}

TEST(SettingsText, RejectsWhatHasNoKey) {
  EXPECT_THROW((void)settings_text({"=5"}), ConfigError);
  EXPECT_THROW((void)settings_text({"rate"}), ConfigError);
}

}  // namespace
}  // namespace tocsin
