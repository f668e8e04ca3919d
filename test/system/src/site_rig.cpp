// SPDX-License-Identifier: Apache-2.0
#include "site_rig.hpp"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>
#include <utility>

#include "stored_topics.hpp"

namespace tocsin {
namespace {

using Way = Crossings::Way;

const std::vector<std::string> stored_topics{"battery_state", "memory_usage", "cpu_load",
                                             "cpu_temperature"};

std::string bringup(const TemporaryFolder& folder) {
  (void)folder.write("sites_traffic.yaml",
                     "extends: traffic_store.yaml\n"
                     "uxv:\n"
                     "  critical: {topics: [crossing/up]}\n"
                     "  low: {keep: [battery_state, memory_usage, cpu_load, cpu_temperature]}\n"
                     "gcs: {critical: {topics: [crossing/down]}}\n");
  return folder.write("sites.yaml",
                      "extends: two_sites.yaml\n"
                      "traffic: sites_traffic.yaml\n"
                      "stop_when_exits: ~\n"
                      "hosts:\n"
                      "  gcs: {containers: [{mission: ~}, {view: ~}, {page: ~}, {recorder: ~}]}\n"
                      "  south: {containers: [{mission: ~}, {page: ~}, {recorder: ~}]}\n"
                      "  uxv: {containers: [{recorder: ~}]}\n");
}

using Ids = std::map<std::pair<std::uint64_t, std::uint64_t>, int>;

Ids ids_in(const std::string& folder, const std::string& topic) {
  Ids ids;
  for (const LoggedOne& one : logged_in(folder, topic)) ++ids[{one.source, one.sequence}];
  return ids;
}

std::size_t repeated(const Ids& ids) {
  return static_cast<std::size_t>(
      std::count_if(ids.begin(), ids.end(), [](const auto& one) { return one.second > 1; }));
}

}  // namespace

SiteRig::SiteRig()
    : stack_(std::make_unique<Stack>(std::vector<std::string>{
          bringup(folder_), "--seed", "1", "--channel", Stack::share("config/radio/open.yaml")})) {}

bool SiteRig::runs() {
  const std::vector<pid_t> stations{stack_->running("gcs/link"), stack_->running("south/link")};
  crossings_ = std::make_unique<Crossings>(stack_->running("uxv/link"), stations, standing_domain);
  const auto all_cross = [&] {
    return crossings_->has_come(0, 0) && crossings_->first_after(Way::down, 0);
  };
  if (!Stack::eventually(std::chrono::seconds(60), all_cross)) return false;
  return true;
}

std::optional<SiteRig::Silence> SiteRig::hand_over(Trouble trouble) {
  const pid_t router = stack_->running("gcs/link");
  const std::int64_t begin_ns = wall_now_ns();
  ::kill(router, trouble == Trouble::freeze ? SIGSTOP : SIGKILL);
  const auto crosses_at = [&](std::size_t station, std::int64_t since_ns) {
    return Stack::eventually(std::chrono::seconds(30), [&] {
      return crossings_->has_come(station, since_ns) &&
             crossings_->first_after(Way::down, since_ns);
    });
  };
  // One that is killed may be started again before it is missed.
  const bool over =
      crosses_at(trouble == Trouble::freeze ? 1 : 0, begin_ns) || crossings_->has_come(1, begin_ns);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  if (trouble == Trouble::freeze) ::kill(router, SIGCONT);
  if (!over) return std::nullopt;
  Silence silence;
  silence.up_s = crossings_->longest_gap_s(Way::up, begin_ns);
  silence.down_s = crossings_->longest_gap_s(Way::down, begin_ns);
  const std::int64_t back_ns = wall_now_ns();
  if (!crosses_at(0, back_ns)) return std::nullopt;
  std::this_thread::sleep_for(std::chrono::seconds(1));
  silence.back_up_s = crossings_->longest_gap_s(Way::up, back_ns);
  silence.back_down_s = crossings_->longest_gap_s(Way::down, back_ns);
  return silence;
}

SiteRig::Stored SiteRig::stored(std::int64_t end_ns) const {
  Stored figures;
  for (const std::string& topic : stored_topics) {
    const Ids first = ids_in(stack_->path("gcs/store/history"), topic);
    const Ids second = ids_in(stack_->path("south/gcs/store/history"), topic);
    figures.twice += repeated(first) + repeated(second);
    for (const LoggedOne& one : logged_in(stack_->path("uxv/store"), topic)) {
      if (one.at_ns > end_ns) continue;
      ++figures.logged;
      const auto copies =
          first.count({one.source, one.sequence}) + second.count({one.source, one.sequence});
      figures.missing += copies == 0 ? 1 : 0;
      figures.both += copies == 2 ? 1 : 0;
    }
  }
  return figures;
}

}  // namespace tocsin
