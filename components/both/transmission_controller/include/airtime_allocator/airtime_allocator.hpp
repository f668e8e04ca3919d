// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

/// Divides the air of a site among its vehicles.
///
/// Wi-Fi gives stations equal packets, whatever air these take, so one slow vehicle slows all
/// (Heusse et al., "Performance anomaly of 802.11b", INFOCOM 2003), and above about nine tenths of
/// the air everybody waits. Here each vehicle gets a share of the air, and all together less than
/// all: max-min fair by weight, where who does not use what it has gets a quarter of its even share
/// or one and a half of what it uses, whichever is more. What strangers take of the channel is
/// left to them. Pure; `now` never decreases.
class AirtimeAllocator {
 public:
  struct Params {
    double air = 0.4;
    double driven_weight = 4;
    template <class Visitor>
    void visit(Visitor& v) {
      v("air", air, {0.05, 1},
        "[1] of the air that strangers leave, for classes normal and low of all vehicles; the rest "
        "is for what is urgent and for repairs. 0.85 is better where the access point has WMM");
      v("driven_weight", driven_weight, {1, 100},
        "[1] of a vehicle that is driven by hand, against 1 of another");
    }
  };
  /// What a vehicle is told.
  struct Share {
    double share = 1;     ///< (0, 1] of the air; 1: no bound, since all other vehicles are silent
    double fallback = 1;  ///< the same, when the site falls silent: even among all vehicles
  };
  /// What all are told.
  struct Division {
    std::vector<Share> shares;
    std::size_t vehicles = 0;  ///< that share it: all while they start, then those that are heard
  };
  /// A vehicle that is silent for longer has no use for air.
  static constexpr Duration silence_limit = std::chrono::seconds(5);
  /// From the first division: who is not heard yet has the most to say.
  static constexpr Duration starting = std::chrono::seconds(15);

  AirtimeAllocator(const Params& params, std::size_t vehicles);

  /// What a vehicle reports.
  struct Use {
    double used = 0;      ///< [0, 1] of the air
    double share = 1;     ///< [0, 1] that it kept to
    bool waited = false;  ///< something would have used more
  };
  /// A report with another value is not taken.
  void on_use(std::size_t vehicle, const Use& use, Time now);
  /// [0, 1] of the time that the channel was busy, with whatever, as the vehicle's radio tells. A
  /// value outside, or NaN, is not known.
  void on_busy(std::size_t vehicle, double busy, Time now);
  void set_driven(std::size_t vehicle, bool driven) { vehicles_[vehicle].driven = driven; }

  [[nodiscard]] Division divide(Time now);

 private:
  struct Vehicle {
    Time heard = Time::min();
    Use use;
    std::optional<double> busy;
    bool driven = false;
  };
  [[nodiscard]] bool is_heard(const Vehicle& vehicle, Time now) const {
    return vehicle.heard != Time::min() && now - vehicle.heard <= silence_limit;
  }
  [[nodiscard]] double weight_of(const Vehicle& vehicle) const {
    return vehicle.driven ? params_.driven_weight : 1;
  }
  /// [1] of the air that is neither a stranger's nor urgent: what the vehicles hear of the channel
  /// (the median), less what they reported to have used.
  [[nodiscard]] double free_air(Time now) const;
  /// The most that is of use to it. `even`: its part by weight.
  [[nodiscard]] static double wanted(const Vehicle& vehicle, double even);

  const Params params_;
  std::vector<Vehicle> vehicles_;
  std::optional<Time> begun_;
};

}  // namespace tocsin
