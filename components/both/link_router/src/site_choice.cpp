// SPDX-License-Identifier: Apache-2.0
#include "link_router/site_choice.hpp"

#include <utility>

namespace tocsin::router {

SiteChoice::SiteChoice(const std::vector<std::string>& sites) {
  if (sites.size() < 2) return;
  for (const std::string& name : sites) sites_.push_back({name});
}

void SiteChoice::on_heard(const std::string& site, Time now) {
  for (Site& one : sites_) {
    if (one.name != site) continue;
    if (!is_heard(one, now)) one.since = now;
    one.last = now;
  }
}

bool SiteChoice::is_heard(const Site& site, Time now) {
  return site.last && now - *site.last <= silent_after;
}

bool SiteChoice::follow(Time now) {
  if (sites_.empty()) return false;
  if (watch_.begins(now)) sites_[chosen_].last = now;
  return std::exchange(chosen_, best(now)) != chosen_;
}

/// Of those that are silent, none is better than the one that is chosen.
std::size_t SiteChoice::best(Time now) const {
  const bool is_lost = !is_heard(sites_[chosen_], now);
  for (std::size_t i = 0; i < sites_.size(); ++i) {
    if (i == chosen_ && !is_lost) break;
    if (!is_heard(sites_[i], now)) continue;
    if (now - sites_[i].since >= (is_lost ? heard_for : back_after)) return i;
  }
  return chosen_;
}

std::string SiteChoice::chosen() const { return sites_.empty() ? "" : sites_[chosen_].name; }

std::set<std::string> SiteChoice::others() const {
  std::set<std::string> others;
  for (const Site& one : sites_) {
    if (one.name != chosen()) others.insert(one.name);
  }
  return others;
}

}  // namespace tocsin::router
