// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "stack.hpp"

namespace tocsin {

/// A vehicle that stands, with two sites behind one emulated radio (bringup/two_sites.yaml), whose
/// batteries and loads are stored topics, and samples of class critical that cross both ways.
class SiteRig {
 public:
  enum class Trouble : std::uint8_t { freeze, kill };  ///< of the router of the first site

  SiteRig();
  /// Whether samples cross both ways within a minute.
  [[nodiscard]] bool runs();
  /// How long no critical sample arrived, each way: at the hand-over to the second site, and at
  /// that back.
  struct Silence {
    double up_s = 0;
    double down_s = 0;
    double back_up_s = 0;
    double back_down_s = 0;
  };
  /// The router of the first site is frozen for 2 s or killed with -9; returns when the vehicle
  /// speaks with the first site again. Nothing when it does not within 30 s.
  [[nodiscard]] std::optional<Silence> hand_over(Trouble trouble);
  /// Stored samples that the vehicle has logged until `end_ns`.
  struct Stored {
    std::size_t logged = 0;
    std::size_t missing = 0;  ///< in no site's log
    std::size_t both = 0;     ///< in the logs of both
    std::size_t twice = 0;    ///< more than once in that of one
  };
  [[nodiscard]] Stored stored(std::int64_t end_ns) const;
  [[nodiscard]] const Stack& stack() const { return *stack_; }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<Stack> stack_;
  std::unique_ptr<Crossings> crossings_;
};

}  // namespace tocsin
