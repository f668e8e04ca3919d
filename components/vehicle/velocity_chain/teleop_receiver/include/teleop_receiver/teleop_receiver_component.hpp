// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "teleop_receiver/command_lateness.hpp"
#include "teleop_receiver/driver_authority.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The vehicle's end of manual driving: passes the velocities of one operator at a time on to the
/// mux, but none that was too long on its way.
class TeleopReceiverComponent final : public Component {
 public:
  struct Params {
    double lifespan_s = 0.5;
    DriverAuthority::Params driver;
    template <class Visitor>
    void visit(Visitor& v) {
      v("lifespan_s", lifespan_s, {0.05, 5},
        "[s] a velocity that was so much longer on its way than the quickest one is dropped");
      driver.visit(v);
    }
  };
  TeleopReceiverComponent(Context& context, const Params& params)
      : Component(context), lifespan_(seconds(params.lifespan_s)), authority_(params.driver) {}
  void tick(Time now) override;

 private:
  void follow(const topic::TeleopCmdVel::Message& command, Time now);
  void obey(const topic::DriverRequest::Message& request, Time now);
  void publish_driver(Time now);
  [[nodiscard]] bool is_fresh(const topic::TeleopCmdVel::Message& command, Time now);

  OptionalInput<topic::TeleopCmdVel> command_{*this};
  OptionalInput<topic::DriverRequest> request_{*this};
  Output<topic::CmdVelTeleop> cmd_vel_{*this};
  Output<topic::DriverState> state_{*this};
  Duration lifespan_;
  std::map<std::string, CommandLateness> devices_;  ///< by frame_id; each has its clock
  bool was_late_ = false;
  DriverAuthority authority_;
  /// What was published last, and when it is published again.
  std::optional<std::string> driver_;
  std::optional<std::string> asked_by_;
  Time next_report_ = Time::min();
};

}  // namespace tocsin
