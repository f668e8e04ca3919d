// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"
#include "transmission_controller/foresight_inputs.hpp"
#include "transmission_controller/transmission_controller.hpp"

namespace tocsin {

/// Publishes the transmission state of its role with the evidence of every decision, and the role's
/// heartbeat.
class TransmissionControllerComponent final : public Component {
 public:
  struct Params {
    TransmissionController::Params controller;
    double heartbeat_period_s = 1.0;
    double foresight_speed_mps = 0.5;
    template <class Visitor>
    void visit(Visitor& v) {
      controller.visit(v);
      v("heartbeat_period_s", heartbeat_period_s, {0.05, 60}, "[s] between heartbeats");
      v("foresight_speed_mps", foresight_speed_mps, {0.05, 5}, "[m/s] at which plans are driven");
    }
  };

  TransmissionControllerComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void publish(const TransmissionDecision& decision, Time now);
  void beat(Time now);

  Input<topic::NetworkQuality> quality_{*this};
  Output<topic::TransmissionState> state_{*this};
  Output<topic::Heartbeat> heartbeat_{*this};
  std::optional<ForesightInputs> ahead_;  ///< of a vehicle whose policy looks ahead
  TransmissionController controller_;
  decision::Outlook outlook_;  ///< of the last decision
  Duration heartbeat_period_;
  Time next_beat_{};
  std::uint32_t beats_ = 0;
};

}  // namespace tocsin
