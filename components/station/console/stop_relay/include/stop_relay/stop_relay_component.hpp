// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "emergency_stop/stop_keeper.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The emergency stop of another station, beside the router of a site that relays to it: what that
/// station presses is pressed at the site under this process's name, for one vehicle, and ends when
/// that station releases it. A release at the site ends what a station has left that has gone. What
/// the site knows of the vehicle's stop goes the other way.
class StopRelayComponent final : public Component {
 public:
  struct Params {
    std::string vehicle;
    template <class Visitor>
    void visit(Visitor& v) {
      v("vehicle", vehicle, "namespace of the vehicle's topics on the site's host");
    }
  };
  /// Throws ConfigError when the vehicle has no name.
  StopRelayComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  void take_other_station(Time now);
  void take_site(Time now);
  void say(bool pressed, Time now);

  const std::string stop_topic_;
  const std::string request_topic_;
  const std::string state_topic_;
  OptionalInput<topic::LinkStop> link_{*this};
  Output<topic::EmergencyStopRequest> left_{*this};  ///< for the router
  Output<topic::SafetyStatus> status_{*this};        ///< for the router, too
  InputPort request_;                                ///< of people at the site
  InputPort state_;                                  ///< as the site knows it
  std::unique_ptr<Publication> stop_;
  StopKeeper keeper_{StopKeeper::Params{}};
};

}  // namespace tocsin
