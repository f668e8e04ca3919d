// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "emergency_stop_input/emergency_stop_input.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"
#include "velocity_mux/velocity_mux.hpp"

namespace tocsin {

/// Lets one of several sources drive. Each input `name` reads the topic `cmd_vel/name`.
class VelocityMuxComponent final : public Component {
 public:
  struct Params {
    std::string inputs = "teleop 30 0.5, docking 20 0.5, navigation 10 0.5";
    template <class Visitor>
    void visit(Visitor& v) {
      v("inputs", inputs, "sources: name priority timeout_s, ... the greatest priority wins");
    }
  };

  /// Throws ConfigError when the list of inputs is wrong.
  VelocityMuxComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  /// One input's name and its port.
  struct Source {
    std::string name;
    std::unique_ptr<InputPort> port;
  };
  void make_sources();
  void take_list();
  void take_commands(Time now);
  void send(const std::shared_ptr<const topic::CmdVelSelected::Message>& velocity);
  void report_active();
  void report_inputs();

  EmergencyStopInput emergency_stop_{*this};
  OptionalInput<topic::MuxSetInputs> set_inputs_{*this};
  Output<topic::CmdVelSelected> selected_{*this};
  Output<topic::MuxActive> active_{*this};
  Output<topic::MuxInputs> inputs_{*this};

  VelocityMux mux_;
  std::vector<Source> sources_;
  std::string reported_;
};

}  // namespace tocsin
