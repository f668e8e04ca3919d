// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/component.hpp"
#include "runtime/middleware/gate_keeper.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Runs in every container: opens and closes the gate of the process by the transmission state of
/// its role, and reports what the gated writers did.
class GateComponent final : public Component {
 public:
  struct Params {
    double silence_limit_s = 5.0;
    double report_period_s = 1.0;
    template <class Visitor>
    void visit(Visitor& v) {
      v("silence_limit_s", silence_limit_s, {1, 600},
        "[s] without a transmission state for longer the gate opens");
      v("report_period_s", report_period_s, {0.1, 60}, "[s] between traffic reports");
    }
  };

  GateComponent(Context& context, const Params& params, std::string process);
  void tick(Time now) override;

 private:
  void report(Time now);
  OptionalInput<topic::TransmissionState> state_{*this};
  Output<topic::TrafficReport> report_{*this};
  GateKeeper keeper_;
  std::string process_;
  Duration report_period_;
  Time next_report_{};
  bool open_ = true;
};

}  // namespace tocsin
