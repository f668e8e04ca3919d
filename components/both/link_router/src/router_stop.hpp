// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "link_service.hpp"
#include "runtime/component.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/port.hpp"
#include "site_link.hpp"
#include "stop_keys_file.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The emergency stop's part of a router: what the host says to the link, and what the link says to
/// the host. It needs no stream of the router.
class RouterStop final : public LinkService {
 public:
  /// A host's side of it.
  class Side {
   public:
    virtual ~Side() = default;
    virtual void take(const StopNews& news, Time now) = 0;
    /// What goes into every packet.
    virtual void fill(StopValue& value, Time now) = 0;
    /// What the host is to know.
    virtual void fill(topic::LinkStop::Message& message, Time now) = 0;
    /// Whether it knows enough for that.
    [[nodiscard]] virtual bool may_publish(Time) const { return true; }
    /// What a successor needs.
    [[nodiscard]] virtual StopKeysFile::Content kept() const = 0;
  };

  /// It tells `sites` what was received. All outlive it.
  RouterStop(Component& owner, const Context& context, LinkBus& link, SiteLink& sites, Logger& log);
  void begin(Instant at) override;
  [[nodiscard]] Time deadline(Time) const override { return next_; }

 private:
  void send_value(Instant at);
  void publish(Instant at);

  LinkBus& link_;
  SiteLink& sites_;
  Logger& log_;
  const Role role_;
  StopKeysFile file_;
  std::unique_ptr<Side> side_;
  Output<topic::LinkStop> output_;
  StopValue value_;
  std::optional<topic::LinkStop::Message> message_;
  Time next_ = Time::min();
};

}  // namespace tocsin
