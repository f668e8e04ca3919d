// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"
#include "transmission_controller/transmission_controller.hpp"

namespace tocsin {

/// Publishes the transmission state of its role with the evidence of every decision, and the role's
/// heartbeat.
class TransmissionControllerComponent final : public Component {
 public:
  struct Params {
    TransmissionController::Params controller;
    double heartbeat_period_s = 1.0;
    template <class Visitor>
    void visit(Visitor& v) {
      controller.visit(v);
      v("heartbeat_period_s", heartbeat_period_s, {0.05, 60}, "[s] between heartbeats");
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
  TransmissionController controller_;
  Duration heartbeat_period_;
  Time next_beat_{};
  std::uint32_t beats_ = 0;
};

}  // namespace tocsin
