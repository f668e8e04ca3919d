// SPDX-License-Identifier: Apache-2.0
#include "simulation/faults.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "foundation/error.hpp"

namespace tocsin::simulation {
namespace {

deployment::Deployment two_hosts() {
  deployment::Deployment deployment;
  for (const char* name : {"uxv", "gcs"}) {
    deployment::Host host;
    host.name = name;
    host.role = role_of(name).value();
    deployment::Container link;
    link.name = "link";
    deployment::Container view;
    view.name = "view";
    view.terminal = true;
    host.containers = {link, view};
    deployment.hosts.push_back(host);
  }
  return deployment;
}

deployment::Deployment two_hosts_with_routers() {
  auto deployment = two_hosts();
  for (deployment::Host& host : deployment.hosts) {
    deployment::ComponentInstance router;
    router.name = router.component = "link_router";
    host.containers.front().components.push_back(std::move(router));
  }
  return deployment;
}

FaultPlan load(const std::string& text) {
  const std::string path =
      ::testing::TempDir() + "faults_test_" + std::to_string(::getpid()) + ".yaml";
  std::ofstream(path) << text;
  try {
    FaultPlan plan = load_faults(path);
    std::remove(path.c_str());
    return plan;
  } catch (...) {
    std::remove(path.c_str());
    throw;
  }
}

TEST(RandomFaults, AreTheSameForTheSameSeedOnly) {
  const auto deployment = two_hosts();
  EXPECT_EQ(to_yaml(random_faults(7, deployment)), to_yaml(random_faults(7, deployment)));
  EXPECT_NE(to_yaml(random_faults(7, deployment)), to_yaml(random_faults(8, deployment)));
}

bool is_drawn_apart(const Fault& fault) { return fault.kind >= FaultKind::stop; }

TEST(RandomFaults, AreOneToSixInOrderAndOverInTime) {
  const auto deployment = two_hosts();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const FaultPlan plan = random_faults(seed, deployment);
    const auto apart = std::count_if(plan.begin(), plan.end(), is_drawn_apart);
    const auto together = static_cast<std::ptrdiff_t>(plan.size()) - apart;
    EXPECT_GE(together, 1);
    EXPECT_LE(together, 6);
    EXPECT_LE(end_of(plan), 75);
    for (std::size_t i = 1; i < plan.size(); ++i) EXPECT_LE(plan[i - 1].at_s, plan[i].at_s);
    for (const Fault& fault : plan) {
      EXPECT_GE(fault.at_s, 2);
      EXPECT_GT(fault.for_s, 0);
      EXPECT_EQ(fault.target.find("view"), std::string::npos);
    }
  }
}

// So that a seed of an older version replays.
TEST(RandomFaults, OfTheFirstEightKindsAreWhatTheyWereBeforeOthersWereAdded) {
  FaultPlan plan = random_faults(8, two_hosts());
  plan.erase(std::remove_if(plan.begin(), plan.end(), is_drawn_apart), plan.end());
  EXPECT_EQ(to_yaml(plan),
            "faults:\n"
            "  - {kind: crash, at_s: 4.056, for_s: 0.895, target: \"gcs/link\", amount: 0}\n"
            "  - {kind: crash, at_s: 24.861, for_s: 3.429, target: \"uxv/link\", amount: 0}\n"
            "  - {kind: crash, at_s: 52.551, for_s: 1.683, target: \"gcs/link\", amount: 0}\n");
}

TEST(RandomFaults, PressAStopInEverySecondRunAndHaveARogueDuringHalfOfThem) {
  int stops = 0;
  int rogues = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const FaultPlan plan = random_faults(seed, two_hosts());
    const auto find = [&](FaultKind kind) {
      return std::find_if(plan.begin(), plan.end(), [&](const Fault& f) { return f.kind == kind; });
    };
    const auto stop = find(FaultKind::stop);
    const auto rogue = find(FaultKind::rogue_velocity);
    if (stop == plan.end()) continue;
    ++stops;
    if (rogue == plan.end()) continue;
    ++rogues;
    EXPECT_GE(rogue->at_s, stop->at_s);
    EXPECT_LE(rogue->at_s, stop->at_s + stop->for_s);
  }
  EXPECT_NEAR(stops, 500, 50);
  EXPECT_NEAR(rogues, 250, 50);
}

TEST(RandomFaults, FreezeARouterInEveryThirdRunAndForgeInEveryFourth) {
  int freezes = 0;
  int forgeries = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    for (const Fault& fault : random_faults(seed, two_hosts_with_routers())) {
      if (fault.kind == FaultKind::forge) ++forgeries;
      if (fault.kind != FaultKind::freeze) continue;
      ++freezes;
      EXPECT_TRUE(fault.target == "uxv/link" || fault.target == "gcs/link") << fault.target;
    }
  }
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    for (const Fault& fault : random_faults(seed, two_hosts())) {
      EXPECT_NE(fault.kind, FaultKind::freeze) << "there is no router";
    }
  }
  EXPECT_NEAR(freezes, 333, 50);
  EXPECT_NEAR(forgeries, 250, 50);
}

int count_of(const deployment::Deployment& deployment, FaultKind first, FaultKind last) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    for (const Fault& fault : random_faults(seed, deployment)) {
      if (fault.kind >= first && fault.kind <= last) ++count;
    }
  }
  return count;
}

TEST(RandomFaults, AreOfALaserWhereThereIsOne) {
  auto deployment = two_hosts();
  EXPECT_EQ(count_of(deployment, FaultKind::laser_dead, FaultKind::kidnap), 0);
  deployment.hosts.front().programs.push_back({});
  deployment.hosts.front().programs.back().command = {"kobuki_simulator", "--laser", "port"};
  EXPECT_NEAR(count_of(deployment, FaultKind::laser_dead, FaultKind::laser_covered), 500, 50);
  for (int kind = 0; kind < 4; ++kind) {
    const auto one = static_cast<FaultKind>(static_cast<int>(FaultKind::laser_dead) + kind);
    EXPECT_NEAR(count_of(deployment, one, one), 125, 35) << kind;
  }
  EXPECT_EQ(count_of(deployment, FaultKind::slip, FaultKind::kidnap), 0);
}

TEST(RandomFaults, DisplaceAVehicleThatHasALocaliser) {
  auto deployment = two_hosts();
  deployment::ComponentInstance localiser;
  localiser.name = localiser.component = "localiser";
  deployment.hosts.front().containers.front().components.push_back(std::move(localiser));
  EXPECT_NEAR(count_of(deployment, FaultKind::slip, FaultKind::slip), 333, 50);
  EXPECT_NEAR(count_of(deployment, FaultKind::kidnap, FaultKind::kidnap), 250, 50);
}

TEST(RandomFaults, SurpriseWhoKnowsTheLinkByPlace) {
  auto deployment = two_hosts();
  EXPECT_EQ(count_of(deployment, FaultKind::access_point, FaultKind::pose_stuck), 0);
  for (const char* const name : {"link_mapper", "modelled_localiser"}) {
    deployment::ComponentInstance instance;
    instance.name = instance.component = name;
    deployment.hosts.front().containers.front().components.push_back(std::move(instance));
  }
  EXPECT_NEAR(count_of(deployment, FaultKind::access_point, FaultKind::access_point), 333, 50);
  EXPECT_NEAR(count_of(deployment, FaultKind::pose_stuck, FaultKind::pose_stuck), 333, 50);
}

bool crashes(const FaultPlan& plan, const std::string& process) {
  return std::any_of(plan.begin(), plan.end(), [&](const Fault& fault) {
    return fault.kind == FaultKind::crash && fault.target == process;
  });
}

/// As in a campaign: the main job without its recorders.
TEST(RandomFaults, CrashEachRouterOfTheMainJobInEveryFifthRun) {
  deployment::Overrides overrides;
  overrides.without = {"uxv/recorder", "gcs/recorder"};
  const auto deployment =
      deployment::load_deployment(TOCSIN_REPOSITORY "/bringup/mission.yaml", overrides);
  int uxv = 0;
  int gcs = 0;
  int either = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const FaultPlan plan = random_faults(seed, deployment);
    const bool of_uxv = crashes(plan, "uxv/link");
    const bool of_gcs = crashes(plan, "gcs/link");
    uxv += of_uxv ? 1 : 0;
    gcs += of_gcs ? 1 : 0;
    either += of_uxv || of_gcs ? 1 : 0;
  }
  std::printf("of 1000 seeds crash uxv/link %d, gcs/link %d, either %d\n", uxv, gcs, either);
  EXPECT_GE(uxv, 200);
  EXPECT_GE(gcs, 200);
}

TEST(LoadFaults, ReadsWhatToYamlWrites) {
  const FaultPlan plan = random_faults(3, two_hosts());
  EXPECT_EQ(to_yaml(load(to_yaml(plan))), to_yaml(plan));
}

TEST(LoadFaults, SortsByTime) {
  const FaultPlan plan = load(
      "faults:\n"
      "  - {kind: unplug, at_s: 9, for_s: 1}\n"
      "  - {kind: crash, at_s: 3, for_s: 1, target: uxv/link}\n");
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(plan[0].kind, FaultKind::crash);
  EXPECT_EQ(plan[0].target, "uxv/link");
  EXPECT_EQ(end_of(plan), 10);
}

TEST(LoadFaults, RefusesWhatMakesNoSense) {
  for (const char* good :
       {"kind: loss, at_s: 1, amount: 1", "kind: crash, at_s: 1, target: /uxv/link"}) {
    EXPECT_NO_THROW((void)load("faults: [{" + std::string(good) + "}]\n")) << good;
  }
  EXPECT_THROW((void)load("a: 1\n"), ConfigError);
  for (const char* bad :
       {"kind: flood, at_s: 1", "kind: loss, at_s: 1, amount: 1.01",
        "kind: delay, at_s: 1, amount: -0.1",
        // a target is printed and written as it is
        R"(kind: crash, at_s: 1, target: "uxv/li nk")", R"(kind: crash, at_s: 1, target: "a\"b")",
        R"(kind: crash, at_s: 1, target: "\x1b[2J")", R"(kind: crash, at_s: 1, target: "Uxv")"}) {
    EXPECT_THROW((void)load("faults: [{" + std::string(bad) + "}]\n"), ConfigError) << bad;
  }
}

}  // namespace
}  // namespace tocsin::simulation
