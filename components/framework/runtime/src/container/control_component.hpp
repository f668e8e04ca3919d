// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "container/health_report.hpp"
#include "container/instances.hpp"
#include "container/served_nodes.hpp"
#include "deployment/deployment.hpp"
#include "runtime/host_control.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Who a container process is, on its host.
struct ProcessName {
  std::string host;
  std::string container;
  int pid;
  /// Which of its nodes have them.
  deployment::ParameterServices parameter_services = deployment::ParameterServices::on_demand;
};

/// Runs in every container, on a thread of its own: answers the services of its nodes, and tells
/// the instances' states, health and log. A request that waits for a blocked component delays only
/// this.
class ControlComponent final : public Component {
 public:
  /// What it asks its computer, once per report.
  struct Computer {
    std::function<std::uint64_t()> resident_bytes;
    std::function<std::optional<std::uint64_t>(const std::string& folder)> free_bytes;
    std::function<rtps_filter::DropAccount()> dropped_packets = {};  ///< empty: none are
    /// What is wrong with the threads of this process; empty: nobody looks.
    std::function<std::optional<std::string>()> finding = {};
    std::function<RefusedNames()> refused_names = {};  ///< empty: none are
  };
  /// `instances` must outlive it.
  ControlComponent(Context& context, const HealthLimits& limits, ProcessName process,
                   Instances& instances, Computer computer);
  ~ControlComponent() override;
  void tick(Time now) override;

 private:
  using Other = std::pair<std::string, int>;  // container and process id
  struct Heard {
    Time at;
    std::vector<std::string> names;
  };
  /// Refuses a name that another container has.
  Outcome load(const LoadOrder& order);
  void note_neighbour(const tocsin_msgs::msg::ContainerState& state, Time now);
  /// The other container that has an instance of this name; empty when there is none.
  [[nodiscard]] std::string twin_of(const std::string& name) const;
  void publish_state(Time now);
  void publish_health(Time now);
  [[nodiscard]] InstanceHealth health_of(const Instance& instance, Time now);
  void add_endpoints(diagnostic_msgs::msg::DiagnosticArray& array);
  void add_dropped(Time now, diagnostic_msgs::msg::DiagnosticArray& array);
  void add_refused(diagnostic_msgs::msg::DiagnosticArray& array);
  void add_process(Time now, diagnostic_msgs::msg::DiagnosticArray& array);

  Input<topic::ContainerState> neighbours_{*this};
  Output<topic::ContainerState> state_{*this};
  Output<topic::Diagnostics> diagnostics_{*this};
  const HealthLimits limits_;
  const ProcessName process_;
  Instances& instances_;
  const Computer computer_;
  std::map<Other, Heard> heard_;
  std::map<std::uint32_t, InstanceSums> before_;
  std::map<std::string, EndpointHealth> endpoints_before_;
  rtps_filter::DropAccount dropped_before_;
  RefusedNames refused_before_;
  ServedNodes served_;
  Time next_drop_line_{};
  std::uint64_t first_bytes_ = 0;
  Time started_{};
  Time next_report_{};
};

}  // namespace tocsin
