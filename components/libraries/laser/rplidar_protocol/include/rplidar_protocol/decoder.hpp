// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "rplidar_protocol/answer.hpp"
#include "rplidar_protocol/capsule.hpp"

namespace tocsin::rplidar {

/// A scan of this kind begins: readings follow.
struct ScanBegins {
  AnswerType type = AnswerType::scan;
};
using Answer = std::variant<Info, Health, ScanBegins, Reading>;

/// Finds answers in the bytes of a device, however they are cut, damaged or mixed with its
/// greeting.
///
/// Readings of a plain scan have three check bits and no checksum: after damage four in a row must
/// have them right, with angles that rise by less than `most_step_rad`, before one counts again.
/// Later ones must rise, too. A capsule whose checksum is wrong costs its readings and those of the
/// one before. Pure; holds at most one descriptor, four readings or one capsule.
class Decoder {
 public:
  struct Counts {
    std::uint64_t readings = 0;
    std::uint64_t rejected = 0;   ///< readings and capsules that were damaged
    std::uint64_t discarded = 0;  ///< bytes that belong to nothing
  };
  using Sink = std::function<void(const Answer&)>;
  static constexpr double most_step_rad = 0.6;

  void feed(ByteView bytes, const Sink& sink);
  /// What comes next is the answer to a new request.
  void clear();
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  [[nodiscard]] bool take(const Sink& sink);
  [[nodiscard]] bool take_descriptor(const Sink& sink);
  [[nodiscard]] bool take_single(const Sink& sink);
  [[nodiscard]] bool take_reading(const Sink& sink);
  [[nodiscard]] bool take_capsule(const Sink& sink);
  [[nodiscard]] std::optional<AnswerType> descriptor_at_front() const;
  /// Whether `count` readings wait that may follow each other.
  [[nodiscard]] bool has_good_readings(std::size_t count) const;
  void emit_reading(const Sink& sink);
  void drop(std::size_t count);
  [[nodiscard]] ByteView view(std::size_t offset, std::size_t size) const {
    return ByteView{buffer_.data(), buffer_.size()}.part(offset, size);
  }

  Bytes buffer_;
  std::optional<AnswerType> expected_;  ///< what follows the last descriptor
  bool trusted_ = false;                ///< the last reading was good
  double last_angle_rad_ = 0;
  std::optional<Capsule> capsule_;  ///< the last one, whose readings are not known yet
  Counts counts_;
};

}  // namespace tocsin::rplidar
