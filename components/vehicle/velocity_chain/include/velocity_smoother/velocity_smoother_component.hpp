// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"
#include "velocity_smoother/velocity_smoother.hpp"

namespace tocsin {

/// Keeps the selected velocity within the limits of speed and acceleration. Ticks only while the
/// velocity changes or is repeated; at rest it sleeps.
class VelocitySmootherComponent final : public Component {
 public:
  using Params = VelocitySmoother::Params;
  VelocitySmootherComponent(Context& context, const Params& params)
      : Component(context), smoother_(params) {}
  void set_parameters(const Params& params) { smoother_.set_limits(params); }
  void tick(Time now) override;

 private:
  Input<topic::CmdVelSelected> wanted_{*this};
  Output<topic::CmdVelSmoothed> smoothed_{*this};
  VelocitySmoother smoother_;
};

}  // namespace tocsin
