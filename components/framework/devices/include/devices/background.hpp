// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace tocsin {

/// Does beside its component, one after the other, what may block, such as writes to a disk. In
/// simulated time each is done before `post` returns. Destroying it waits until all is done.
class Background {
 public:
  virtual ~Background() = default;
  /// The work must not throw.
  virtual void post(std::function<void()> work) = 0;
  /// How much was posted and is not done: who posts without end looks here first.
  [[nodiscard]] virtual std::size_t waiting() const = 0;
};

/// Without a thread.
[[nodiscard]] std::unique_ptr<Background> work_at_once();

}  // namespace tocsin
