// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace tocsin {

/// Keeps what arrives at a participant in its sockets until the participant can take it.
///
/// Fast DDS 2.9.1 announces a participant before it registers its receivers, and throws away what
/// comes between. A peer answers an announcement within 0.3 ms, once; when that answer is lost, the
/// next one comes with the peer's periodic announcement, a second later. So does Fast DDS 3.1, more
/// seldom.
class DeferredReception {
 public:
  /// Any thread; for good.
  void release();
  /// Returns once released, or after a second: a participant that failed must not hang.
  void wait();

 private:
  std::atomic<bool> released_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
};

}  // namespace tocsin
