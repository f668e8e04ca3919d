// SPDX-License-Identifier: Apache-2.0
// A container process does its periodic work at the phases that simulation draws, too, and ends
// when its watchdog says so.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include "container/staged_process.hpp"
#include "deployment/deployment.hpp"
#include "foundation/temporary_folder.hpp"
#include "runtime/detail/schedule.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

constexpr int domain = 91;
constexpr Duration patience = std::chrono::seconds(20);
const std::string config = TOCSIN_REPOSITORY "/config/";

/// How much later than their phase of the clock the reports of health come, at best.
class PhaseMeter : private Receiver {
 public:
  PhaseMeter(Bus& bus, Duration period, double phase)
      : period_(period),
        phase_(phase),
        subscription_(bus.subscribe(
            {topic::Diagnostics::info, &type_info<topic::Diagnostics::Message>()}, *this)) {}
  /// Of a period, after `reports` of them and the one at the start.
  double least_lateness(int reports) {
    std::unique_lock<std::mutex> lock(mutex_);
    came_.wait_for(lock, patience, [&] { return count_ > reports; });
    return least_;
  }

 private:
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double instant = to_seconds(sample.received) / to_seconds(period_) - phase_;
    if (count_++ > 0) least_ = std::min(least_, instant - std::floor(instant));
    came_.notify_all();
  }
  const Duration period_;
  const double phase_;
  std::mutex mutex_;
  std::condition_variable came_;
  int count_ = 0;
  double least_ = 1;
  std::unique_ptr<Subscription> subscription_;
};

/// One container `drive` of a ground station, with a lamp, that reports its health each 0.5 s.
deployment::Deployment deployment_of(const std::string& run_dir, int seed) {
  deployment::Deployment deployment;
  deployment.file = run_dir + "/deployment.yaml";
  deployment.run_dir = run_dir;
  deployment.share = STAGE "/share/tocsin";
  deployment.qos = config + "qos.yaml";
  deployment.traffic = config + "traffic.yaml";
  deployment.seed = seed;
  deployment.link_domain = domain + 2;
  deployment::Host& host = deployment.hosts.emplace_back();
  host.name = "gcs";
  host.role = Role::gcs;
  host.address = "127.0.0.1";
  host.local_domain = domain;
  deployment::Container& container = host.containers.emplace_back();
  container.name = "drive";
  container.health.period_s = 0.5;
  deployment::ComponentInstance& lamp = container.components.emplace_back();
  lamp.component = lamp.name = "link_lamp";
  lamp.parameters = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
  return deployment;
}

std::unique_ptr<Bus> make_bus() {
  BusOptions options;
  options.name = "container_phase_test";
  options.role = Role::gcs;
  options.qos_file = config + "qos.yaml";
  options.traffic_file = config + "traffic.yaml";
  options.host_domain = domain;
  return make_fast_dds_bus(options);
}

TEST(ContainerPhase, IsWhatTheSeedOfTheRunAndItsNamesSay) {
  for (const int seed : {1, 7}) {
    const TemporaryFolder folder;
    const auto deployment = deployment_of(folder.path(), seed);
    write_resolved(deployment, deployment.file);
    const auto bus = make_bus();
    PhaseMeter meter(*bus, seconds(0.5), phase_of(process_seed(seed, "gcs", "drive"), "control"));
    Process sut({STAGE "/bin/tocsin-container", deployment.file, "gcs", "drive"});
    EXPECT_LT(meter.least_lateness(4), 0.1) << "seed " << seed;
  }
}

TEST(ContainerWatch, AContainerThatTakesMoreMemoryThanItMayEndsToBeStartedAgain) {
  const TemporaryFolder folder;
  auto deployment = deployment_of(folder.path(), 1);
  deployment.hosts.front().containers.front().health.memory_mib = 16;  // less than Fast DDS takes
  write_resolved(deployment, deployment.file);
  Process sut({STAGE "/bin/tocsin-container", deployment.file, "gcs", "drive"});
  EXPECT_EQ(sut.wait(), 75);
}

}  // namespace
}  // namespace tocsin
