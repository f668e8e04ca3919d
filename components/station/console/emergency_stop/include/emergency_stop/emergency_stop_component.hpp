// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "emergency_stop/request_file.hpp"
#include "emergency_stop/stop_keeper.hpp"
#include "emergency_stop_input/vehicle_stop_view.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The ground station's end of the emergency stop. A person's command lives for a second; this says
/// it on, and tells what the vehicle makes of it, by the rule of VehicleStopView.
class EmergencyStopComponent final : public Component {
 public:
  using Params = StopKeeper::Params;
  EmergencyStopComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_requests(Time now);
  void take_vehicle(Time now);
  void see(const VehicleStopView::Report& vehicle);
  void say(bool pressed, Time now);
  void keep();
  void tell(Time now);

  OptionalInput<topic::EmergencyStopRequest> request_{*this};
  Input<topic::SafetyStatus> status_{*this};
  OptionalInput<topic::LinkStop> link_{*this};
  Output<topic::EmergencyStop> stop_{*this, topic::EmergencyStop::station};
  Output<topic::EmergencyStopState> state_{*this};
  RequestFile file_;
  StopKeeper keeper_;
  VehicleStopView vehicle_;
  std::optional<bool> kept_;  ///< in the file
  topic::EmergencyStopState::Message known_;
  bool told_ = false;  ///< `known_`
};

}  // namespace tocsin
