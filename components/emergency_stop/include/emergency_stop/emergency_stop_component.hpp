// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "emergency_stop/request_file.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The ground station's end of the emergency stop: the one writer of that topic. A person's command
/// lives for a second, but a vehicle that comes later must still find it.
class EmergencyStopComponent final : public Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  EmergencyStopComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  OptionalInput<topic::EmergencyStopRequest> request_{*this};
  Output<topic::EmergencyStop> stop_{*this};
  RequestFile file_;
  std::optional<bool> wanted_;  ///< empty: nobody has asked for anything
  std::optional<bool> sent_;
};

}  // namespace tocsin
