// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "link_service.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "site_link.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Made before the link is opened, so that the reports are flows of the host from its start.
struct ReportOutputs {
  explicit ReportOutputs(Component& owner)
      : link_state(owner), budget(owner), traffic(owner), site(owner) {}
  Output<topic::LinkState> link_state;
  Output<topic::LinkBudget> budget;
  Output<topic::TrafficReport> traffic;
  Output<topic::LinkSite> site;
};

/// What a router reports on its host: the state of the link, the traffic of each topic, and the
/// budgets of adaptive topics. A site whose vehicle speaks with another one reports that alone: the
/// other one has its own reports, and a second station may have both.
class ReportLink final : public LinkService {
 public:
  using Services = std::vector<std::unique_ptr<LinkService>>;
  /// All outlive it.
  ReportLink(Component& owner, ReportOutputs& outputs, const LinkParts& parts,
             const Services& services, const SiteLink& sites);
  void finish(Instant at) override;
  [[nodiscard]] Time deadline(Time) const override { return std::min(next_report_, next_budget_); }

 private:
  void report_budgets(Instant at);
  void report_link(Instant at);
  void report_site(const std::string& site);
  void report_traffic(Instant at);
  /// What every report begins with.
  template <class Message>
  [[nodiscard]] Message message(Instant at) const;
  template <class Topic>
  void write(Output<Topic>& output, typename Topic::Message message);

  Component& owner_;
  ReportOutputs& outputs_;
  const LinkParts parts_;
  const Services& services_;
  const SiteLink& sites_;
  Time next_report_{};
  Time next_budget_{};
  std::string told_site_;
};

}  // namespace tocsin
