// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/bytes.hpp"
#include "kobuki_idl/topics.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// The bytes of the serial line as hexadecimal text, for people who look for a fault. Part of the
/// driver's component, on demand.
class SerialTopics {
 public:
  explicit SerialTopics(Component& owner);
  /// False when the text was refused.
  [[nodiscard]] bool received(ByteView bytes);
  /// Takes one frame.
  [[nodiscard]] bool sent(ByteView frame);

 private:
  Output<topic::RawStream> received_;
  Output<topic::RawCommand> sent_;
  Output<topic::RawControl> control_;
};

}  // namespace tocsin
