// SPDX-License-Identifier: Apache-2.0
#include "radio_link.hpp"

#include <cassert>
#include <cmath>
#include <cstdio>
#include <utility>

#include "geometry/wall.hpp"

namespace tocsin::simulation {
namespace {

/// What is done when a single packet arrives.
class Call final : public Cargo {
 public:
  explicit Call(std::function<void()> what) : what_(std::move(what)) {}
  void arrive(std::size_t) override { what_(); }
  [[nodiscard]] bool waits_after(std::size_t) const override { return false; }

 private:
  std::function<void()> what_;
};

constexpr Duration report_period = std::chrono::seconds(1);

/// As the kernel prints it: noise is always -256, and an unassociated interface shows zeros
/// without dots.
std::string proc_text(const radio::LinkReport& report) {
  char line[160];
  const char* format = report.associated
                           ? " wlan0: 0000  %3d.  %3ld.  -256        0      0      0 %6llu      0 "
                             "       0\n"
                           : " wlan0: 0000  %3d   %3ld   0        0      0      0 %6llu      0 "
                             "       0\n";
  std::snprintf(line, sizeof line, format, report.quality,
                report.associated ? std::lround(report.rssi_dbm) : 0L,
                static_cast<unsigned long long>(report.associated ? report.uplink.air.failed : 0));
  return std::string("Inter-| sta-|\n face | tus |\n") + line;
}

}  // namespace

RadioLink::RadioLink(Core& core, const radio::ChannelParams& params, const Site& site,
                     Reports reports)
    : core_(core),
      channel_(params, site.walls, site.seed, core.now, site.vehicles),
      vehicles_(site.vehicles),
      random_(site.seed) {
  if (reports == Reports::no) return;
  for (std::size_t i = 0; i < site.vehicles; ++i) report(i);
}

void RadioLink::move_access_point(double by_x_m) {
  radio::ChannelParams params = channel_.params();
  params.access_point_x_m += by_x_m;
  channel_.configure(params);
}

void RadioLink::send(const Way& way, std::size_t ip_bytes, std::function<void()> on_arrival) {
  send(way, ip_bytes, std::make_shared<Call>(std::move(on_arrival)), 0);
}

void RadioLink::send(const Way& way, std::size_t ip_bytes, std::shared_ptr<Cargo> cargo,
                     std::size_t packet) {
  const radio::Packet on_air{static_cast<int>(ip_bytes), false,
                             radio::access_category_of_dscp(way.dscp), way.vehicle};
  const radio::FrameId id = channel_.push(way.direction, on_air, core_.now);
  assert(id == next_);
  ++next_;
  under_way_.push_back({std::move(cargo), packet});
}

Time RadioLink::next_arrival(Time limit) {
  for (;;) {
    const Time at = channel_.advance_to_outcome(limit);
    if (at == limit || matters(channel_.first_outcome())) return at;
    end(*channel_.take());
  }
}

bool RadioLink::matters(const radio::Outcome& outcome) const {
  if (outcome.fate != radio::Fate::delivered) return false;
  const Arrival& arrival = under_way_[outcome.id - first_];
  return vehicles_[outcome.vehicle].faults.any() || !arrival.cargo->waits_after(arrival.packet);
}

void RadioLink::advance() {
  channel_.advance(core_.now);
  while (const auto outcome = channel_.take()) end(*outcome);
}

void RadioLink::end(const radio::Outcome& outcome) {
  const Arrival arrival = std::exchange(under_way_[outcome.id - first_], {});
  while (!under_way_.empty() && !under_way_.front().cargo) {
    under_way_.pop_front();
    ++first_;
  }
  if (outcome.fate == radio::Fate::delivered) carry(arrival, vehicles_[outcome.vehicle].faults);
}

double RadioLink::share() { return static_cast<double>(random_() >> 11U) / 9007199254740992.0; }

void RadioLink::carry(const Arrival& arrival, const AirFaults& faults) {
  if (!faults.any()) return arrival.cargo->arrive(arrival.packet);
  if (share() < faults.loss) return;
  const int copies = share() < faults.duplication ? 2 : 1;
  for (int i = 0; i < copies; ++i) {
    if (faults.delay_s <= 0) {
      arrival.cargo->arrive(arrival.packet);
    } else {
      core_.events.at(core_.now + seconds(faults.delay_s * share()),
                      [arrival] { arrival.cargo->arrive(arrival.packet); });
    }
  }
}

void RadioLink::report(std::size_t vehicle) {
  const radio::LinkReport report_now = channel_.report(core_.now, vehicle);
  vehicles_[vehicle].wireless_text = proc_text(report_now);
  if (Observer* const observer = core_.observer(vehicle)) {
    observer->on_channel(report_now, core_.now);
  }
  core_.events.at(core_.now + report_period, [this, vehicle] { report(vehicle); });
}

}  // namespace tocsin::simulation
