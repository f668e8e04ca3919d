// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core.hpp"
#include "geometry/wall.hpp"
#include "radio_channel/radio_channel.hpp"

namespace tocsin::simulation {

/// How packets go: where to, with which DSCP (0 to 63), from or to which vehicle.
struct Way {
  Way(radio::Direction to, std::uint8_t with_dscp = 0, std::size_t of_vehicle = 0)
      : direction(to), dscp(with_dscp), vehicle(of_vehicle) {}
  radio::Direction direction;
  std::uint8_t dscp;
  std::size_t vehicle;
};

/// The other way, with the same DSCP and vehicle.
[[nodiscard]] inline Way back(const Way& way) {
  return {way.direction == radio::Direction::uplink ? radio::Direction::downlink
                                                    : radio::Direction::uplink,
          way.dscp, way.vehicle};
}

/// What goes wrong on the air besides what the channel does.
struct AirFaults {
  double loss = 0;         ///< [0, 1]
  double duplication = 0;  ///< [0, 1]
  double delay_s = 0;      ///< up to so much more, each packet on its own
  [[nodiscard]] bool any() const { return loss > 0 || duplication > 0 || delay_s > 0; }
};

/// Something that packets carry.
class Cargo {
 public:
  virtual ~Cargo() = default;
  /// One of its packets has come to the other side; twice when the air has doubled it.
  virtual void arrive(std::size_t packet) = 0;
  /// Whether its arrival changes nothing but the cargo: another packet has to come yet.
  [[nodiscard]] virtual bool waits_after(std::size_t packet) const = 0;
};

/// Carries packets between the vehicles and the ground station: one radio_channel for all.
class RadioLink {
 public:
  enum class Reports { yes, no };  ///< whether drivers and the core's observers are told of it
  struct Site {
    std::vector<geometry::Wall> walls = {};
    std::uint64_t seed = 1;
    std::size_t vehicles = 1;
  };
  RadioLink(Core& core, const radio::ChannelParams& params, const Site& site,
            Reports reports = Reports::yes);

  /// Sends an IP packet of `cargo`, which is told when and if it comes to the other side.
  void send(const Way& way, std::size_t ip_bytes, std::shared_ptr<Cargo> cargo, std::size_t packet);
  /// The same for a single packet.
  void send(const Way& way, std::size_t ip_bytes, std::function<void()> on_arrival);
  [[nodiscard]] Time next_event() const { return channel_.next_event(); }
  /// When a packet next arrives that matters to others than its cargo, or `limit`, before which
  /// nothing else happens. What the radio does until then is done.
  [[nodiscard]] Time next_arrival(Time limit);
  /// Does what is due at the core's time.
  void advance();
  /// Of what a vehicle sends and is sent from now on; may be changed at any time.
  [[nodiscard]] AirFaults& faults(std::size_t vehicle) { return vehicles_[vehicle].faults; }
  [[nodiscard]] std::size_t vehicles() const { return vehicles_.size(); }

  void set_position(double x_m, double y_m, std::size_t vehicle) {
    channel_.set_position(x_m, y_m, vehicle);
  }
  void move_access_point(double by_x_m);
  /// The text of /proc/net/wireless on a vehicle, renewed each second as by the link emulator.
  [[nodiscard]] const std::string& wireless_text(std::size_t vehicle) const {
    return vehicles_[vehicle].wireless_text;
  }
  [[nodiscard]] std::uint64_t pushed() const { return next_ - 1; }

 private:
  struct Arrival {
    std::shared_ptr<Cargo> cargo;  ///< null: it has ended
    std::size_t packet = 0;
  };
  struct Vehicle {
    AirFaults faults;
    std::string wireless_text;
  };
  void report(std::size_t vehicle);
  [[nodiscard]] bool matters(const radio::Outcome& outcome) const;
  void end(const radio::Outcome& outcome);
  void carry(const Arrival& arrival, const AirFaults& faults);
  [[nodiscard]] double share();
  Core& core_;
  radio::RadioChannel channel_;
  std::deque<Arrival> under_way_;  ///< packets first_ to next_ - 1
  radio::FrameId first_ = 1;
  radio::FrameId next_ = 1;
  std::vector<Vehicle> vehicles_;
  std::mt19937_64 random_;  ///< of the faults
};

}  // namespace tocsin::simulation
