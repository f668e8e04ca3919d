// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "motion/velocity_smoother.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Keeps the selected velocity within the limits of speed and acceleration. Ticks only while the
/// velocity changes or is repeated; at rest it sleeps.
class VelocitySmootherComponent final : public Component {
 public:
  using Params = motion::VelocitySmoother::Params;
  VelocitySmootherComponent(Context& context, const Params& params)
      : Component(context), smoother_(params) {}
  void tick(Time now) override;

 private:
  Input<topic::CmdVelSelected> wanted_{*this};
  Output<topic::CmdVelSmoothed> smoothed_{*this};
  motion::VelocitySmoother smoother_;
};

}  // namespace tocsin
