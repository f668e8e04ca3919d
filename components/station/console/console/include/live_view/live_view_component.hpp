// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "live_view/screen.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Draws the mission on the terminal that its process owns; without a terminal it prints one line
/// every few seconds.
class LiveViewComponent final : public Component {
 public:
  struct Params {
    double refresh_s = 0.5;
    double line_period_s = 5.0;
    FreshnessLimits limits;
    template <class Visitor>
    void visit(Visitor& v) {
      v("refresh_s", refresh_s, {0.05, 60}, "[s] between pages on a terminal");
      v("line_period_s", line_period_s, {0.5, 600}, "[s] between lines without a terminal");
      limits.visit(v);
    }
  };

  /// ConfigError when `unknown_after_s` is less than `stale_after_s`.
  LiveViewComponent(Context& context, const Params& params);
  ~LiveViewComponent() override;
  void tick(Time now) override;
  /// What would be drawn at `now`; for tests.
  [[nodiscard]] ViewState state(Time now);

 private:
  /// Counts a topic whose content is not shown.
  struct Counted {
    std::string topic;
    std::unique_ptr<InputPort> input;
  };
  template <class... Topics>
  void count(topic::List<Topics...>);
  void look_at_readers();
  void take_inputs(Time now);
  void take_states(Time now);
  void take_link_states(Time now);
  void take_diagnostics(Time now);
  template <class Topic>
  std::shared_ptr<const typename Topic::Message> take(Input<Topic>& input, Time now);
  void draw(Time now);

  OptionalInput<topic::Location> location_{*this};
  OptionalInput<topic::MissionStatus> mission_{*this};
  OptionalInput<topic::NavigationStatus> navigation_{*this};
  OptionalInput<topic::NetworkQuality> quality_{*this};
  OptionalInput<topic::TransmissionState> transmission_{*this};
  OptionalInput<topic::Heartbeat> heartbeat_{*this};
  OptionalInput<topic::TrafficReport> report_{*this};
  OptionalInput<topic::LinkState> link_state_{*this};
  OptionalInput<topic::LinkSite> site_{*this};
  OptionalInput<topic::SafetyStatus> safety_{*this};
  OptionalInput<topic::Diagnostics> diagnostics_{*this};
  std::vector<Counted> counted_;
  ViewState view_;
  TrafficTable table_;
  const FreshnessLimits limits_;
  bool terminal_;
  Duration period_;
  Time next_draw_{};
};

}  // namespace tocsin
