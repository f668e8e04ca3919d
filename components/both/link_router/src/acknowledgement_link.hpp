// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "link_service.hpp"

namespace tocsin {

/// The acknowledgements between routers: each bears what every service has to say to the peer.
class AcknowledgementLink final : public LinkService {
 public:
  using Services = std::vector<std::unique_ptr<LinkService>>;
  /// `services` outlives it.
  AcknowledgementLink(const LinkParts& parts, const Services& services);
  [[nodiscard]] bool takes(const std::string& topic) const override;
  void on_remote(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) override;
  void finish(Instant at) override;
  [[nodiscard]] Time deadline(Time) const override { return parts_.receiver.deadline(); }

 private:
  const LinkParts parts_;
  const Services& services_;
  const FlowId flow_;
};

}  // namespace tocsin
