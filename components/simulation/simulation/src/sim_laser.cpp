// SPDX-License-Identifier: Apache-2.0
#include "sim_laser.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::simulation {

class SimLaser::Port final : public SerialDevice {
 public:
  explicit Port(SimLaser& laser) : laser_(laser), plugged_(laser.plugged_) {}
  ~Port() override {
    if (!lost()) laser_.readable_ = nullptr;
  }
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    if (lost()) return std::nullopt;
    auto& arrived = laser_.arrived_;
    const std::size_t count = std::min(size, arrived.size());
    std::copy_n(arrived.begin(), count, to);
    arrived.erase(arrived.begin(), arrived.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  bool write(const std::uint8_t* bytes, std::size_t size) override {
    if (lost()) return false;
    laser_.laser_.receive({bytes, size}, laser_.core_.now);
    return true;
  }

 private:
  [[nodiscard]] bool lost() const { return !laser_.is_plugged_ || plugged_ != laser_.plugged_; }
  SimLaser& laser_;
  int plugged_;  ///< how often it was plugged in when this was opened
};

SimLaser::SimLaser(Core& core, const LaserOptions& options,
                   std::shared_ptr<const laser::Scene> scene, std::uint64_t seed)
    : core_(core),
      path_(options.link),
      laser_(laser::find_laser_profile(options.profile), std::move(scene), options.mount, seed,
             core.now) {}

/// What nobody reads is not measured.
Time SimLaser::next_event() const {
  if (!readable_) return never;
  return sent_.empty() ? laser_.next_event() : std::min(laser_.next_event(), sent_.front().arrives);
}

void SimLaser::advance(const laser::SimulatedLaser::Motion& motion) {
  if (next_event() > core_.now) return;
  laser_.step(motion, core_.now, [this](ByteView bytes) {
    sent_.push_back({core_.now + delay_, {bytes.begin(), bytes.end()}});
  });
  deliver();
}

void SimLaser::deliver() {
  const std::size_t before = arrived_.size();
  for (; !sent_.empty() && sent_.front().arrives <= core_.now; sent_.pop_front()) {
    const auto& bytes = sent_.front().bytes;
    arrived_.insert(arrived_.end(), bytes.begin(), bytes.end());
  }
  if (arrived_.size() > before) readable_();
}

void SimLaser::set(const Fault& fault, bool holds) {
  if (fault.kind == FaultKind::laser_dead) set_plugged(!holds);
  if (fault.kind == FaultKind::laser_stuck) laser_.stick(holds);
  if (fault.kind == FaultKind::laser_late) delay_ = seconds(holds ? fault.amount : 0);
  if (fault.kind == FaultKind::laser_covered) laser_.cover(holds);
}

void SimLaser::set_plugged(bool plugged) {
  if (plugged) ++plugged_;
  is_plugged_ = plugged;
  sent_.clear();
  arrived_.clear();
  if (plugged) return;
  if (const auto tell = std::exchange(readable_, nullptr)) tell();
}

std::unique_ptr<SerialDevice> SimLaser::open(Devices::Readable readable) {
  if (!is_plugged_) return nullptr;
  sent_.clear();
  arrived_.clear();
  readable_ = std::move(readable);
  return std::make_unique<Port>(*this);
}

}  // namespace tocsin::simulation
