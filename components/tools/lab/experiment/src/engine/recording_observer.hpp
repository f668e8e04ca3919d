// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "report/recording.hpp"
#include "simulation/observer.hpp"

namespace tocsin::experiment {

/// Writes down a simulated run as `tocsin report` would have read it from the recorders' files, so
/// that simulated and real runs are measured by the same definitions. Arrivals count in the
/// process named `recorder` of each host, as in reality.
class RecordingObserver final : public simulation::Observer {
 public:
  void on_written(const simulation::Written& written) override;
  void on_delivered(const simulation::Delivered& delivered) override;
  void on_channel(const radio::LinkReport& report, Time now) override;
  void on_failure(const std::string& component, const std::string& what, Time now) override;

  [[nodiscard]] report::Recording& recording() { return recording_; }
  /// "component: what" of the first component that threw; empty when none did.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  /// What a sample is kept as, besides its arrival.
  enum class Kept : std::uint8_t { no, decision, quality, place, mission };
  /// Where the samples of a writer go; found by its address.
  struct Writer {
    bool classified = false;  ///< the traffic file puts it into a class
    Kept kept = Kept::no;
    std::uint64_t* written = nullptr;
    std::vector<report::Arrival>* arrivals = nullptr;
  };
  Writer& writer(const simulation::TopicEnd& end);
  static Writer writer_of(const simulation::TopicEnd& end);
  void keep(Kept kept, const simulation::Written& written);

  report::Recording recording_;
  std::unordered_map<const simulation::TopicEnd*, Writer> writers_;
  std::string failure_;
};

}  // namespace tocsin::experiment
