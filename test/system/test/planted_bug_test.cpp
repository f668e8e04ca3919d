// SPDX-License-Identifier: Apache-2.0
// A bug in a component of the main job is found by trying seeds, and its seed replays it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "foundation/temporary_folder.hpp"
#include "simulation/campaign.hpp"

namespace tocsin::simulation {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// The whole main job but for pictures and recordings, with another mission control.
class PlantedBugTest : public ::testing::Test {
 protected:
  /// The other components are those of the installation, as after its setup.bash.
  static void SetUpTestSuite() { ::setenv("COLCON_PREFIX_PATH", install().c_str(), 1); }
  static fs::path install() {
    const fs::path own = TOCSIN_INSTALL;
    return fs::exists(own / "share/tocsin") ? own : own.parent_path();
  }
  static fs::path share() {
    const fs::path together = install() / "share/tocsin";
    return fs::exists(together) ? together : install() / "bringup/share/tocsin";
  }
  static SeedOutcome run(std::uint64_t seed, bool repeats) {
    const TemporaryFolder folder;
    deployment::Overrides overrides;
    overrides.run_dir = folder.path();
    overrides.share = share().string();
    overrides.seed = static_cast<int>(seed);
    overrides.without = {"uxv/recorder", "gcs/recorder", "uxv/payload"};
    auto deployment =
        deployment::load_deployment((share() / "bringup/mission.yaml").string(), overrides);
    plant(deployment, repeats);
    WorldOptions world;
    world.faults = random_faults(seed, deployment);
    return run_checked(std::move(deployment), world);
  }
  static const SearchResult& found_by_search() {
    static const SearchResult result =
        search({1, 100, 1, true}, [](std::uint64_t seed) { return run(seed, false); });
    return result;
  }
  static void plant(deployment::Deployment& deployment, bool repeats) {
    for (deployment::Container& container : deployment.hosts.at(1).containers) {
      for (deployment::ComponentInstance& one : container.components) {
        if (one.component != "mission_control") continue;
        YAML::Node parameters;
        parameters["mission_file"] = (share() / "config/missions/mission_a.yaml").string();
        parameters["repeats"] = repeats;
        one.component = "planted_mission";
        one.parameters = std::make_shared<const YAML::Node>(parameters);
      }
    }
  }
};

TEST_F(PlantedBugTest, IsFoundByItsFirstSeedWhichReplaysIt) {
  const SearchResult& result = found_by_search();
  ASSERT_EQ(result.broken.size(), 1U) << result.runs << " seeds kept every promise";
  const SeedOutcome& found = result.broken.front();
  EXPECT_THAT(to_text(found), HasSubstr("the mission was not over in time"));
  const SeedOutcome again = run(found.seed, false);
  EXPECT_EQ(to_text(again), to_text(found));
  EXPECT_EQ(again.outcome.digest, found.outcome.digest);
  EXPECT_NE(again.outcome.digest, 0U);
  EXPECT_EQ(to_yaml(again.faults), to_yaml(found.faults));
  std::printf("seed %llu of %llu:\n%s%s", static_cast<unsigned long long>(found.seed),
              static_cast<unsigned long long>(result.runs), to_text(found).c_str(),
              to_yaml(found.faults).c_str());
}

TEST_F(PlantedBugTest, WithoutItTheSameSeedsKeepEveryPromise) {
  ASSERT_FALSE(found_by_search().broken.empty());
  const Search same{1, found_by_search().broken.front().seed, 1, false};
  const auto result = search(same, [](std::uint64_t seed) { return run(seed, true); });
  for (const SeedOutcome& checked : result.broken)
    ADD_FAILURE() << checked.seed << to_text(checked);
}

}  // namespace
}  // namespace tocsin::simulation
