// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kobuki_idl/topics.hpp"
#include "kobuki_protocol/bytes.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// The bytes of the serial line as hexadecimal text, for people who look for a fault. Part of the
/// driver's component, on demand.
class SerialTopics {
 public:
  explicit SerialTopics(Component& owner);
  /// False when the text was refused.
  [[nodiscard]] bool received(kobuki::ByteView bytes);
  /// Takes one frame.
  [[nodiscard]] bool sent(kobuki::ByteView frame);

 private:
  Output<topic::RawStream> received_;
  Output<topic::RawCommand> sent_;
  Output<topic::RawControl> control_;
};

}  // namespace tocsin
