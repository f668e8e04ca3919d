// SPDX-License-Identifier: Apache-2.0
#include "airtime_allocator/airtime_allocator_component.hpp"

#include <set>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "named_end/named_end.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr Duration period = std::chrono::seconds(1);

template <class Topic>
std::shared_ptr<const typename Topic::Message> take(InputPort& port) {
  return std::static_pointer_cast<const typename Topic::Message>(port.take_message());
}

std::vector<std::string> checked(const std::vector<std::string>& names) {
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (!is_name(name)) {
      throw ConfigError("vehicles: '" + name + "' must be " + name_rule);
    }
    if (!known.insert(name).second) throw ConfigError("vehicles: " + name + " is there twice");
  }
  return names;
}

}  // namespace

AirtimeAllocatorComponent::Vehicle::Vehicle(Component& owner, const std::string& name)
    : use_topic(name + "/" + topic::AirtimeUse::info.name),
      quality_topic(name + "/" + topic::NetworkQuality::info.name),
      driver_topic(name + "/" + topic::DriverState::info.name),
      share_topic(name + "/" + topic::AirtimeShare::info.name),
      use(owner, named_end<topic::AirtimeUse>(use_topic, owner), WakeMode::time_triggered),
      quality(owner, named_end<topic::NetworkQuality>(quality_topic, owner),
              WakeMode::time_triggered),
      driver(owner, named_end<topic::DriverState>(driver_topic, owner), WakeMode::time_triggered),
      share(owner.bus().advertise(named_end<topic::AirtimeShare>(share_topic, owner))) {}

AirtimeAllocatorComponent::AirtimeAllocatorComponent(Context& context, const Params& params)
    : Component(context), allocator_(params.allocator, params.vehicles.size()) {
  for (const std::string& name : checked(params.vehicles)) vehicles_.emplace_back(*this, name);
  wake_every(period);
}

void AirtimeAllocatorComponent::take_inputs(Time now) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    while (const auto use = take<topic::AirtimeUse>(vehicles_[i].use)) {
      allocator_.on_use(
          i, {static_cast<double>(use->used()), static_cast<double>(use->share()), use->waited()},
          now);
    }
    while (const auto quality = take<topic::NetworkQuality>(vehicles_[i].quality)) {
      allocator_.on_busy(i, static_cast<double>(quality->busy_percent()) / 100, now);
    }
    while (const auto state = take<topic::DriverState>(vehicles_[i].driver)) {
      allocator_.set_driven(i, !state->driver().empty());
    }
  }
}

void AirtimeAllocatorComponent::tick(Time now) {
  take_inputs(now);
  const auto division = allocator_.divide(now);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    auto message = std::make_shared<topic::AirtimeShare::Message>();
    message->stamp(wall(now));
    message->share(static_cast<float>(division.shares[i].share));
    message->fallback(static_cast<float>(division.shares[i].fallback));
    message->vehicles(static_cast<std::uint16_t>(division.vehicles));
    (void)vehicles_[i].share->write(message);  // the next one replaces it
  }
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::AirtimeAllocatorComponent)
