// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// Which emergency stops stand on the vehicle: the rule of all who listen to topic::EmergencyStop.
///
/// Anybody may stop the vehicle. A stop stands until the writer that said it takes it back; the
/// false of another releases nothing. A process that was restarted is another writer, but the
/// ground station is one writer, whichever of its processes speaks, before and after a restart. The
/// stop of a writer that has gone (its process died, it wrote once and ended) stays until the
/// ground station releases its own, which releases what the dead have left.
///
/// Pure: no clock. Takes memory for 64 writers at most; the stop of a further one stays until the
/// ground station releases.
class EmergencyStopLatch {
 public:
  struct Writer {
    std::uint64_t id = 0;  ///< of this life of it
    bool station = false;  ///< speaks for the ground station's people
    std::string name;      ///< to tell people
  };
  /// Whether a writer has not gone.
  using IsThere = std::function<bool(std::uint64_t id)>;
  /// What a process keeps for its successor, which knows the writers by other ids.
  struct Memory {
    bool station = false;
    bool others = false;
  };

  void press(const Writer& writer);
  void release(const Writer& writer, const IsThere& is_there);
  /// What stood when an earlier process of this listener died stands again.
  void restore(const Memory& memory);

  [[nodiscard]] bool stands() const { return station_ || left_ || !others_.empty(); }
  [[nodiscard]] bool stands_by_station() const { return station_; }
  /// Names of those besides the station whose stops stand.
  [[nodiscard]] std::vector<std::string> others() const;
  /// Of one of them, as it was when it pressed first.
  [[nodiscard]] std::optional<std::string> name_of(std::uint64_t id) const;
  [[nodiscard]] Memory memory() const { return {station_, left_ || !others_.empty()}; }

 private:
  static constexpr std::size_t most_writers = 64;
  bool station_ = false;
  bool left_ = false;  ///< by writers whose ids are not known
  std::map<std::uint64_t, std::string> others_;
};

}  // namespace tocsin
