// SPDX-License-Identifier: Apache-2.0
// The parameters in the README are those of the code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "foundation/parameters.hpp"
#include "plan/experiment_file.hpp"
#include "plan/toy.hpp"

namespace tocsin::experiment {
namespace {

TEST(Readme, ShowsTheParametersAsTheyAre) {
  std::ostringstream readme;
  readme << std::ifstream(std::string(TOCSIN_SOURCE_DIR) + "/README.md").rdbuf();
  EXPECT_THAT(readme.str(), ::testing::HasSubstr(default_yaml<Timing>()));
  EXPECT_THAT(readme.str(), ::testing::HasSubstr(default_yaml<RunSet>()));
  EXPECT_THAT(readme.str(), ::testing::HasSubstr(default_yaml<CostWeights>()));
}

}  // namespace
}  // namespace tocsin::experiment
