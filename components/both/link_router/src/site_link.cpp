// SPDX-License-Identifier: Apache-2.0
#include "site_link.hpp"

#include <set>

#include "foundation/printable.hpp"

namespace tocsin {
namespace {

/// [us] By which a value is overtaken by another one on the way to two sockets.
constexpr std::uint64_t most_disorder_us = 10'000'000;
/// Of a link to one there are more by forgery alone.
constexpr std::size_t most_hosts = 64;

/// A vehicle says it ten times a second.
constexpr Duration told_for = std::chrono::seconds(3);

/// On a secured link a value says of its own host alone.
bool is_honest(const ReceivedStop& said) {
  return said.identity.empty() || said.identity == "CN=/" + said.value.host;
}

}  // namespace

SiteLink::SiteLink(LinkBus& link, router::LinkReceiver& receiver, Role role, Logger& log)
    : link_(link),
      receiver_(receiver),
      log_(log),
      role_(role),
      choice_(link.sites()),
      host_(link.host()) {
  if (!chosen().empty()) link_.set_absent(choice_.others());
}

void SiteLink::take(const StopNews& news, Time now) {
  for (const ReceivedStop& said : news.values) {
    if (said.value.role == role_ || !is_honest(said) || !is_newest(said)) continue;
    if (is_left() || !chosen().empty()) {
      receiver_.on_heard(said.value.host, Time(std::chrono::microseconds(said.value.number)),
                         said.received);
    }
    if (role_ == Role::uxv) {
      choice_.on_heard(said.value.host, said.received);
    } else {
      follow_vehicle(said);
    }
  }
  if (role_ == Role::uxv) follow_choice(now);
}

std::string SiteLink::to_tell(Time now) const {
  if (role_ == Role::uxv) return chosen();
  return is_left() && now - told_at_ < told_for ? told_ : "";
}

void SiteLink::follow_choice(Time now) {
  if (!choice_.follow(now)) return;
  log_.warn("{} is the site from now on", chosen());
  link_.set_absent(choice_.others());
}

/// On a plain link a number that is far below the last one is of a clock that was set, or the last
/// one was forged: the next one counts again. On a secured link it is a recording.
bool SiteLink::is_newest(const ReceivedStop& said) {
  const StopValue& value = said.value;
  if (numbers_.size() >= most_hosts && numbers_.count(value.host) == 0) numbers_.clear();
  std::uint64_t& last = numbers_[value.host];
  const bool is_recorded = !said.identity.empty() || last - value.number < most_disorder_us;
  if (value.number <= last && is_recorded) return false;
  last = value.number;
  return true;
}

void SiteLink::follow_vehicle(const ReceivedStop& said) {
  told_at_ = said.received;
  if (said.value.site == told_) return;
  const bool was_left = is_left();
  told_ = said.value.site;
  const std::string vehicle = printable(said.value.host);
  if (is_left()) {
    log_.warn("{} speaks with another site, {}", vehicle, printable(told_));
    link_.set_absent({said.value.host});
  } else if (was_left) {
    log_.info("{} speaks with this site again", vehicle);
    link_.set_absent({});
  }
}

}  // namespace tocsin
