// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "devices/true_pose.hpp"
#include "foundation/parameters.hpp"
#include "geometry/pose.hpp"
#include "map_ports/pose_output.hpp"
#include "modelled_localiser/pose_error.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Stands in for `localiser` where the radio is studied: the truth, its error and its failures, in
/// the time that nothing takes. For simulated vehicles only.
class ModelledLocaliserComponent final : public Component {
 public:
  struct Params {
    double rate_hz = 5.5;
    PoseErrorParams error;
    template <class Visitor>
    void visit(Visitor& v) {
      v("rate_hz", rate_hz, {0.1, 50}, "[Hz] of poses");
      error.visit(v);
    }
  };

  /// Throws ConfigError where the vehicle is not simulated.
  ModelledLocaliserComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void tell(const geometry::Pose& odom, const builtin_interfaces::msg::Time& stamp, Time now);

  Input<topic::Odom> odom_{*this};
  PoseOutput pose_{*this};
  Params params_;
  std::unique_ptr<TruePose> truth_;
  PoseError error_;
  geometry::Pose known_;  ///< what it said last
  Time next_{};
};

}  // namespace tocsin
