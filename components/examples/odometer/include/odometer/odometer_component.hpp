// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "example_idl/topics.hpp"
#include "odometer/distance_meter.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace example {

/// Tells the ground station how far the vehicle has driven.
class OdometerComponent final : public tocsin::Component {
 public:
  struct Params {
    double period_s = 1;
    double step_m = 0.02;
    double jump_m = 0.5;
    template <class Visitor>
    void visit(Visitor& v) {
      v("period_s", period_s, {0.1, 1}, "[s] between two reports");
      v("step_m", step_m, {0.001, 0.1}, "[m] what is less is noise");
      v("jump_m", jump_m, {0.2, 10}, "[m] what is more between two poses is no drive");
    }
  };
  OdometerComponent(tocsin::Context& context, const Params& params);
  void tick(tocsin::Time now) override;

 private:
  // Poses come 50 times a second; they wait for the next report.
  tocsin::Input<tocsin::topic::Odom> odom_{*this, tocsin::WakeMode::time_triggered};
  tocsin::Output<DistanceDriven> distance_{*this};
  DistanceMeter meter_;
};

}  // namespace example
