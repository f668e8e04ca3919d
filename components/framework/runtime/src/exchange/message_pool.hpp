// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "idl_support/type_info.hpp"

namespace tocsin {

/// Messages to decode into, used again as soon as nobody holds them: the buffers of a picture are
/// not taken from the system and given back thirty times a second. Messages may be given back from
/// any thread, also after the pool is gone.
class MessagePool {
 public:
  explicit MessagePool(const TypeInfo& type) : type_(type) {}

  /// A message that nobody else holds, with any content.
  [[nodiscard]] std::shared_ptr<void> take();

 private:
  /// The messages that nobody holds, at most four.
  struct Shelf {
    std::mutex mutex;
    std::vector<std::shared_ptr<void>> messages;
  };
  const TypeInfo& type_;
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
};

}  // namespace tocsin
