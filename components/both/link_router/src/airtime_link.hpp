// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/role.hpp"
#include "link_router/airtime_keeper.hpp"
#include "link_service.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// The air of a site, which its vehicles share. Both sides reckon with their number; the vehicle
/// also keeps to its share, and tells the site what was used.
class AirtimeLink final : public LinkService {
 public:
  AirtimeLink(Component& owner, const LinkParts& parts, Role role);
  void begin(Instant at) override;
  void finish(Instant at) override;
  [[nodiscard]] Time deadline(Time now) const override;

 private:
  Component& owner_;
  OptionalInput<topic::AirtimeShare> share_;
  std::optional<Output<topic::AirtimeUse>>
      use_;  ///< of a vehicle that has a site: a flow on the link
  const LinkParts parts_;
  const bool has_share_;
  router::AirtimeKeeper keeper_;
  Time next_report_{};
};

}  // namespace tocsin
