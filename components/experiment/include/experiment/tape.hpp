// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "report/recording.hpp"
#include "simulation/observer.hpp"

namespace tocsin::experiment {

/// Writes down a simulated run as `tocsin report` would have read it from the recorders' files, so
/// that simulated and real runs are measured by the same definitions. Arrivals count in the
/// process named `recorder` of each host, as in reality.
class Tape final : public simulation::Observer {
 public:
  void on_written(const simulation::Written& written) override;
  void on_delivered(const simulation::Delivered& delivered) override;
  void on_channel(const radio::LinkReport& report, Time now) override;
  void on_failure(const std::string& component, const std::string& what, Time now) override;

  [[nodiscard]] report::Recording& recording() { return recording_; }
  /// "component: what" of the first component that threw; empty when none did.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  report::Recording recording_;
  std::map<const simulation::TopicEnd*, std::string> classes_;
  std::string failure_;
};

}  // namespace tocsin::experiment
