// SPDX-License-Identifier: Apache-2.0
// Worlds with routers alone; test/system/simulation_test.cpp has the whole mission.
#include "simulation/sim_world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <set>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::simulation {
namespace {

using ::testing::ElementsAre;

const std::string config = TOCSIN_REPOSITORY "/config/";

deployment::Container container(const char* name) {
  deployment::Container made;
  made.name = name;
  made.components.push_back({"link_router", "link_router",
                             std::make_shared<const YAML::Node>(YAML::Node(YAML::NodeType::Map))});
  return made;
}

/// A base, and a router on each side.
deployment::Deployment small() {
  deployment::Deployment deployment;
  deployment.qos = config + "qos.yaml";
  deployment.traffic = config + "traffic.yaml";
  deployment::Host uxv;
  uxv.name = "uxv";
  uxv.role = Role::uxv;
  uxv.programs = {{"base", {"kobuki_simulator", "--link", "/dev/kobuki"}}};
  uxv.containers = {container("drive")};
  deployment::Host gcs;
  gcs.name = "gcs";
  gcs.role = Role::gcs;
  gcs.containers = {container("mission")};
  deployment.hosts = {uxv, gcs};
  return deployment;
}

/// Two of them and a station with a router for each.
deployment::Deployment fleet() {
  deployment::Deployment deployment = small();
  deployment.vehicles = {"uxv1", "uxv2"};
  const deployment::Host uxv = deployment.hosts[0];
  deployment::Host gcs = deployment.hosts[1];
  deployment.hosts.clear();
  gcs.containers.clear();
  gcs.peers = {"uxv1", "uxv2"};
  for (const char* const vehicle : {"uxv1", "uxv2"}) {
    deployment.hosts.push_back(uxv);
    deployment.hosts.back().name = vehicle;
    deployment.hosts.back().address = vehicle;
    gcs.containers.push_back(container("mission"));
    gcs.containers.back().name = vehicle + std::string("_mission");
    gcs.containers.back().vehicle = vehicle;
  }
  deployment.hosts.push_back(gcs);
  return deployment;
}

deployment::Deployment in(const TemporaryFolder& folder, deployment::Deployment deployment) {
  deployment.run_dir = folder.path();
  return deployment;
}

TEST(SimWorld, GoesOnWhereItStopped) {
  SimWorld whole(small());
  SimWorld parts(small());
  const Outcome at_once = whole.run(seconds(10));
  EXPECT_EQ(at_once.simulated, seconds(10));
  EXPECT_FALSE(at_once.exit_code);
  EXPECT_GE(at_once.ticks, 20U);  // each router each second
  (void)parts.run(seconds(4));
  const Outcome rest = parts.run(seconds(6));
  EXPECT_EQ(rest.simulated, seconds(6));
  EXPECT_EQ(rest.digest, at_once.digest);
}

TEST(SimWorld, RefusesARelay) {
  deployment::Deployment deployment = small();
  deployment.relay = deployment::Relay{"uxv", "gcs"};
  EXPECT_THROW(SimWorld{deployment}, ConfigError);
}

TEST(SimWorld, WorldsInOneProcessDoNotTouchEachOther) {
  SimWorld alone(small());
  const Outcome expected = alone.run(seconds(5));
  SimWorld one(small());
  SimWorld other(small());
  Outcome last;
  for (int i = 0; i < 5; ++i) {
    last = one.run(seconds(1));
    (void)other.run(seconds(0.7));
  }
  EXPECT_EQ(last.digest, expected.digest);
  EXPECT_EQ(last.ticks, expected.ticks);
}

/// Counts what it is shown.
class Counter : public Observer {
 public:
  void on_written(const Written& written) override {
    ++samples;
    EXPECT_EQ(written.sequence, ++last[&written.from]);
    EXPECT_EQ(written.bytes > 0, written.from.scope == Scope::link);
  }
  void on_sent(const Sent& sent) override { in_air[sent.written] = sent.time; }
  void on_delivered(const Delivered& delivered) override {
    ++deliveries;
    EXPECT_NE(delivered.from.host, delivered.to.host);
    EXPECT_EQ(delivered.sent_at, in_air[delivered.written]);
    EXPECT_GT(delivered.received, delivered.sent_at);
  }
  void on_channel(const radio::LinkReport&, Time) override { ++reports; }
  void on_position(const BasePosition& base) override {
    EXPECT_EQ(base.host, "uxv");
    ++positions;
  }
  void on_step(Time now) override { now_ = now; }
  std::uint64_t samples = 0;
  int deliveries = 0;
  int reports = 0;
  int positions = 0;
  Time now_{};
  std::map<const TopicEnd*, std::uint64_t> last;
  std::map<std::uint64_t, Time> in_air;
};

TEST(SimWorld, ShowsTheObserverWhatHappensAndIsNotChangedByIt) {
  const Outcome alone = SimWorld(small()).run(seconds(10));
  Counter counter;
  WorldOptions options;
  options.observer = &counter;
  SimWorld sut(small(), options);
  const Outcome outcome = sut.run(seconds(10));
  EXPECT_EQ(outcome.digest, alone.digest);
  EXPECT_EQ(counter.samples, outcome.samples);
  EXPECT_EQ(counter.reports, 11);     // at start and each second
  EXPECT_EQ(counter.positions, 101);  // at start and each 100 ms
  options.observer = nullptr;
  options.digest = false;
  const Outcome without = SimWorld(small(), options).run(seconds(10));
  EXPECT_EQ(without.digest, 0U);
  EXPECT_EQ(without.ticks, alone.ticks);
  EXPECT_EQ(without.samples, alone.samples);
}

/// Whose positions it was shown, and whose processes.
class Hosts : public Observer {
 public:
  void on_position(const BasePosition& base) override { bases.insert(base.host); }
  void on_written(const Written& written) override {
    processes.insert(written.from.host + "/" + written.from.process);
  }
  void on_channel(const radio::LinkReport&, Time) override { ++reports; }
  std::set<std::string> bases;
  std::set<std::string> processes;
  int reports = 0;
};

TEST(SimWorld, EachOfSeveralVehiclesHasItsObserver) {
  Hosts first;
  Hosts second;
  WorldOptions options;
  options.observers = {&first, &second};
  const TemporaryFolder folder;
  SimWorld sut(in(folder, fleet()), options);
  (void)sut.run(seconds(3));
  EXPECT_THAT(first.bases, ElementsAre("uxv1"));
  EXPECT_THAT(second.bases, ElementsAre("uxv2"));
  EXPECT_THAT(second.processes, ElementsAre("gcs/uxv2_mission", "uxv2/drive"));
  EXPECT_EQ(second.reports, 4);
}

TEST(SimWorld, SeveralVehiclesAreRepeatableAndShareTheAir) {
  const TemporaryFolder folder;
  const Outcome once = SimWorld(in(folder, fleet())).run(seconds(10));
  const Outcome again = SimWorld(in(folder, fleet())).run(seconds(10));
  const Outcome alone = SimWorld(small()).run(seconds(10));
  EXPECT_EQ(once.digest, again.digest);
  EXPECT_NEAR(static_cast<double>(once.packets), 2 * static_cast<double>(alone.packets), 30);
}

TEST(SimWorld, RefusesAProgramWithoutAModelAndAComponentThatIsNotInstalled) {
  deployment::Deployment deployment = small();
  deployment.hosts[1].programs = {{"browser", {"firefox"}}};
  EXPECT_THROW(SimWorld{deployment}, ConfigError);
  deployment = small();
  deployment.hosts[0].containers[0].components[0].component = "no_such_component";
  EXPECT_THROW(SimWorld{deployment}, ConfigError);
}

}  // namespace
}  // namespace tocsin::simulation
