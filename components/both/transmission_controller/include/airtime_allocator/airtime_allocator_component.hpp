// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "airtime_allocator/airtime_allocator.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Tells each vehicle of a site its share of the air, once a second. Runs at the station, once for
/// all vehicles, without a namespace: it reads `NAME/airtime_use`, `NAME/network_quality`
/// and `NAME/teleop/driver`, and writes `NAME/airtime_share`.
class AirtimeAllocatorComponent final : public Component {
 public:
  struct Params {
    AirtimeAllocator::Params allocator;
    std::vector<std::string> vehicles;
    template <class Visitor>
    void visit(Visitor& v) {
      allocator.visit(v);
      v("vehicles", vehicles, "names of the vehicles on the channel");
    }
  };

  /// Throws ConfigError for a name that is none or is there twice.
  AirtimeAllocatorComponent(Context& context, const Params& params);
  void tick(Time now) override;

 private:
  /// The ends of one vehicle's topics.
  struct Vehicle {
    Vehicle(Component& owner, const std::string& name);
    const std::string use_topic;
    const std::string quality_topic;
    const std::string driver_topic;
    const std::string share_topic;
    InputPort use;
    InputPort quality;
    InputPort driver;
    std::unique_ptr<Publication> share;
  };
  void take_inputs(Time now);

  AirtimeAllocator allocator_;
  std::deque<Vehicle> vehicles_;
};

}  // namespace tocsin
