// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"
#include "velocity_smoother/velocity_smoother.hpp"

namespace tocsin {

/// Keeps the selected velocity within the limits of speed and acceleration. Ticks only while the
/// velocity changes or is repeated; at rest it sleeps.
class VelocitySmootherComponent final : public Component {
 public:
  struct Params {
    bool checked = false;
    VelocitySmoother::Params limits;
    template <class Visitor>
    void visit(Visitor& v) {
      v("checked", checked,
        "takes what a collision_brake has checked, not what the mux has selected");
      limits.visit(v);
    }
  };
  VelocitySmootherComponent(Context& context, const Params& params);
  void set_parameters(const Params& params) { smoother_.set_limits(params.limits); }
  void tick(Time now) override;

 private:
  template <class Topic>
  void take_from(std::optional<Input<Topic>>& input, Time now);
  std::optional<Input<topic::CmdVelSelected>> selected_;
  std::optional<Input<topic::CmdVelChecked>> checked_;
  Output<topic::CmdVelSmoothed> smoothed_{*this};
  VelocitySmoother smoother_;
};

}  // namespace tocsin
