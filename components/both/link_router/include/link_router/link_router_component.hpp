// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "link_router/link_router_params.hpp"
#include "runtime/component.hpp"

namespace tocsin {

/// The one owner of the link on its host. What it does there are services: live samples, backfill,
/// calls, acknowledgements, the emergency stop, reports. The component passes what happens at the
/// link to each of them.
class LinkRouterComponent final : public Component {
 public:
  struct Params {
    router::LinkRouterParams link;
    bool report = true;
    std::string store_directory;
    int store_bytes = 64'000'000;
    double store_age_s = 86'400;
    int history_bytes = 256'000'000;
    double history_age_s = 86'400;
    template <class Visitor>
    void visit(Visitor& v) {
      link.visit(v);
      v("report", report,
        "tells link_state and traffic_report; off at a station behind a relay, which passes on the "
        "site's");
      v("store_directory", store_directory,
        "folder of stored topics, for this router alone; empty: run folder/role/store, which later "
        "runs do not see");
      v("store_bytes", store_bytes, {100'000, 2e9}, "[B] of it at most; the oldest goes");
      v("store_age_s", store_age_s, {1, 1e8}, "[s] what is older goes");
      v("history_bytes", history_bytes, {100'000, 2e9},
        "[B] of the log of what crosses when it is asked for, folder history of store_directory");
      v("history_age_s", history_age_s, {1, 1e8}, "[s] what is older goes there");
    }
  };

  /// Throws ConfigError when the process has no way over the link.
  LinkRouterComponent(Context& context, const Params& params);
  ~LinkRouterComponent() override;
  void tick(Time now) override;

 private:
  class Router;
  const std::unique_ptr<Router> router_;
};

}  // namespace tocsin
