// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "teleop_receiver/command_lateness.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The vehicle's end of manual driving: passes an operator's velocities on to the mux, but none
/// that was too long on its way.
class TeleopReceiverComponent final : public Component {
 public:
  struct Params {
    double lifespan_s = 0.5;
    template <class Visitor>
    void visit(Visitor& v) {
      v("lifespan_s", lifespan_s, {0.05, 5},
        "[s] a velocity that was so much longer on its way than the quickest one is dropped");
    }
  };
  TeleopReceiverComponent(Context& context, const Params& params)
      : Component(context), lifespan_(seconds(params.lifespan_s)) {}
  void tick(Time now) override;

 private:
  [[nodiscard]] bool is_fresh(const topic::TeleopCmdVel::Message& command, Time now);

  OptionalInput<topic::TeleopCmdVel> command_{*this};
  Output<topic::CmdVelTeleop> cmd_vel_{*this};
  Duration lifespan_;
  std::map<std::string, CommandLateness> devices_;  ///< by frame_id; each has its clock
  bool was_late_ = false;
};

}  // namespace tocsin
