// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "emergency_stop_input/hindrances.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "link_state_text/link_state_text.hpp"
#include "live_view/screen.hpp"
#include "words.hpp"

namespace tocsin {
namespace {

/// Joins what is known of each value; a stale one tells its age, an unknown one only that.
class Summary {
 public:
  Summary(Time now, const FreshnessLimits& limits) : now_(now), limits_(limits) {}

  template <class Value, class Words>
  void tell(const char* name, const std::optional<Heard<Value>>& heard, const Words& words_of) {
    if (!heard) return;
    const Duration age = now_ - heard->at;
    const Freshness state = freshness(age, limits_);
    if (state == Freshness::unknown) {
      add(std::string(name) + " unknown for " + age_text(age));
    } else if (std::string words = words_of(heard->value); !words.empty()) {
      if (state == Freshness::stale) words += " " + age_text(age) + " ago";
      add(words);
    }
  }
  [[nodiscard]] std::string text() const { return text_.empty() ? "nothing heard yet" : text_; }

 private:
  void add(const std::string& part) { text_ += (text_.empty() ? "" : "  ") + part; }
  const Time now_;
  const FreshnessLimits& limits_;
  std::string text_;
};

std::string decision(const char* side, const tocsin_msgs::msg::TransmissionState& decided) {
  return fmt::format("{} {} ({})", side, decided.active() ? "active" : "passive", decided.reason());
}

}  // namespace

std::string summary_line(const ViewState& state, Time now, const FreshnessLimits& limits) {
  Summary summary(now, limits);
  summary.tell("safety", state.safety, [](const tocsin_msgs::msg::SafetyStatus& safety) {
    return joined(hindrances(safety));
  });
  summary.tell("site", view::elsewhere(state, now, limits),
               [](const OtherSite& site) { return "speaks with " + site.name; });
  if (state.disk && state.disk->value.is_full()) {
    summary.tell("disk", state.disk,
                 [](const Disk& disk) { return "disk " + view::trouble(disk); });
  }
  summary.tell("mission", state.mission, [](const tocsin_msgs::msg::MissionStatus& mission) {
    return view::waypoint(mission, "/") + " " + mission.state();
  });
  summary.tell("location", state.location, view::place_text);
  summary.tell("vehicle", state.uxv, [](const tocsin_msgs::msg::TransmissionState& decided) {
    return fmt::format("QNI {}  {}", view::number(decided.qni(), 1, ""),
                       decision("vehicle", decided));
  });
  summary.tell("station", state.gcs, [](const tocsin_msgs::msg::TransmissionState& decided) {
    return decision("station", decided);
  });
  summary.tell("uplink", state.uplink, link_text::summary);
  summary.tell("downlink", state.downlink, link_text::summary);
  return printable(summary.text());
}

}  // namespace tocsin
