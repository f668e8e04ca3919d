// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace tocsin {

/// Something of the computer that bytes, events or replies come from. Used by one thread. An
/// interface that derives from it has a `kind`, says nothing by its own default functions, and may
/// replace `Address` and `text`.
class Device {
 public:
  /// Where it is; empty when there can be only one.
  using Address = std::string;
  [[nodiscard]] static std::string text(const std::string& path) { return path; }

  virtual ~Device() = default;
  /// Readable when something waits or the device is gone; the device keeps it. Empty when there is
  /// nothing to poll, as in simulated time: then `readable`, given at opening, is called instead.
  [[nodiscard]] virtual std::optional<int> descriptor() const { return std::nullopt; }
};

/// What came of opening a device of type D.
template <class D>
struct Opened {
  enum class Result { open, absent, busy };

  Opened() = default;
  /// Absent when there is none.
  template <class Derived>
  Opened(std::unique_ptr<Derived> its_device)
      : result(its_device ? Result::open : Result::absent), device(std::move(its_device)) {}
  Opened(Result its_result, std::string its_reason, bool is_held = false)
      : result(its_result), reason(std::move(its_reason)), held(is_held) {}

  Result result = Result::absent;
  std::unique_ptr<D> device;  ///< null unless open
  std::string reason;         ///< one line, for people; empty when open
  bool held = false;          ///< a busy one: by a living process, as far as we may see
};

}  // namespace tocsin
