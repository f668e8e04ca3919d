// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// Messages to decode into, used again as soon as nobody holds them: the buffers of a picture are
/// not taken from the system and given back thirty times a second. One thread.
class MessagePool {
 public:
  explicit MessagePool(const TypeInfo& type) : type_(type) {}

  /// A message that nobody else holds, with any content.
  [[nodiscard]] std::shared_ptr<void> take();

 private:
  const TypeInfo& type_;
  std::array<std::shared_ptr<void>, 4> kept_;
  std::size_t next_ = 0;
};

}  // namespace tocsin
