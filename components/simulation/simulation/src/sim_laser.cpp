// SPDX-License-Identifier: Apache-2.0
#include "sim_laser.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::simulation {

class SimLaser::Port final : public SerialDevice {
 public:
  explicit Port(SimLaser& laser) : laser_(laser) {}
  ~Port() override { laser_.readable_ = nullptr; }
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    auto& arrived = laser_.arrived_;
    const std::size_t count = std::min(size, arrived.size());
    std::copy_n(arrived.begin(), count, to);
    arrived.erase(arrived.begin(), arrived.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  bool write(const std::uint8_t* bytes, std::size_t size) override {
    laser_.laser_.receive({bytes, size}, laser_.core_.now);
    return true;
  }

 private:
  SimLaser& laser_;
};

SimLaser::SimLaser(Core& core, const LaserOptions& options,
                   std::shared_ptr<const laser::Scene> scene, std::uint64_t seed)
    : core_(core),
      path_(options.link),
      laser_(laser::find_laser_profile(options.profile), std::move(scene), options.mount, seed,
             core.now) {}

/// What nobody reads is not measured.
Time SimLaser::next_event() const { return readable_ ? laser_.next_event() : never; }

void SimLaser::advance(const laser::SimulatedLaser::Motion& motion) {
  if (next_event() > core_.now) return;
  const std::size_t before = arrived_.size();
  laser_.step(motion, core_.now, [this](ByteView bytes) {
    arrived_.insert(arrived_.end(), bytes.begin(), bytes.end());
  });
  if (arrived_.size() > before) readable_();
}

std::unique_ptr<SerialDevice> SimLaser::open(Devices::Readable readable) {
  arrived_.clear();
  readable_ = std::move(readable);
  return std::make_unique<Port>(*this);
}

}  // namespace tocsin::simulation
