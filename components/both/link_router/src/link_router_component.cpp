// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_router_component.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "acknowledgement_link.hpp"
#include "airtime_link.hpp"
#include "backfill/backfill_link.hpp"
#include "call_link.hpp"
#include "foundation/error.hpp"
#include "link_events.hpp"
#include "link_service.hpp"
#include "live_link.hpp"
#include "report_link.hpp"
#include "router_stop.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "site_link.hpp"
#include "store_places.hpp"

namespace tocsin {
namespace {

std::unique_ptr<LinkBus> open_link(Component& owner) {
  LinkAccess* const access = owner.bus().link_access();
  if (access == nullptr) throw ConfigError("link_router: this process has no address on the link");
  return access->open_link([&owner] { owner.schedule().input_arrived(); });
}

}  // namespace

/// The services, and what they share.
class LinkRouterComponent::Router {
 public:
  Router(Component& owner, Context& context, Logger& log, const Params& params);
  /// Returns when to tick next.
  Time tick(Instant at);

 private:
  std::optional<ReportOutputs> reports_;
  const std::unique_ptr<LinkBus> link_;
  router::LinkSender sender_;
  router::LinkReceiver receiver_;
  LinkStreams streams_;
  SiteLink sites_;
  LinkEvents::Services services_;
  LinkEvents events_;
};

LinkRouterComponent::Router::Router(Component& owner, Context& context, Logger& log,
                                    const Params& params)
    : reports_(params.report ? std::make_optional<ReportOutputs>(owner) : std::nullopt),
      link_(open_link(owner)),
      sender_(params.link),
      streams_(*link_, sender_),
      sites_(*link_, receiver_, context.role, log),
      events_(*link_, receiver_, services_) {
  const LinkParts parts{*link_,          sender_,         receiver_,        streams_,
                        events_.peers(), events_.local(), events_.remote(), log};
  auto acknowledgements = std::make_unique<AcknowledgementLink>(parts, services_);
  auto live = std::make_unique<LiveLink>(owner, parts, context.role);
  auto backfill = std::make_unique<BackfillLink>(owner, parts, context.computer,
                                                 backfill_params(context, params));
  live->set_backfill(*backfill);
  services_.push_back(std::make_unique<RouterStop>(owner, context, *link_, sites_, log));
  services_.push_back(std::move(live));
  services_.push_back(std::move(acknowledgements));
  services_.push_back(std::make_unique<CallLink>(parts));
  services_.push_back(std::make_unique<AirtimeLink>(owner, parts, context.role));
  services_.push_back(std::move(backfill));
  if (reports_)
    services_.push_back(std::make_unique<ReportLink>(owner, *reports_, parts, services_, sites_));
  if (link_->paths() > 1) sender_.add_path();
}

Time LinkRouterComponent::Router::tick(Instant at) {
  for (const auto& one : services_) one->begin(at);
  events_.take(at);
  for (const auto& one : services_) one->follow(at);
  for (const auto& one : services_) one->send(at);
  for (const auto& one : services_) one->follow(at);
  for (const auto& one : services_) one->finish(at);
  Time next = events_.deadline();
  for (const auto& one : services_) next = std::min(next, one->deadline(at.now));
  return next;
}

LinkRouterComponent::LinkRouterComponent(Context& context, const Params& params)
    : Component(context), router_(std::make_unique<Router>(*this, context, log(), params)) {}

LinkRouterComponent::~LinkRouterComponent() = default;

void LinkRouterComponent::tick(Time now) { wake_at(router_->tick({now, bus().wall_ns(now)})); }

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LinkRouterComponent)
