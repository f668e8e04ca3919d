// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace tocsin {

/// Lets one of the threads that call at once work for all. Fast DDS has a receiving thread for each
/// transport, and writers of this process call a reader's listener, too; one of them takes for all,
/// so that samples stay in order. To wait with a lock could deadlock with the locks of Fast DDS.
class SingleDrainer {
 public:
  /// Calls `drain` until all who called meanwhile have been served; returns at once when another
  /// thread is at it.
  template <class Drain>
  void run(const Drain& drain) {
    unsigned seen = calls_.fetch_add(1) + 1;
    if (seen != 1) return;
    do {
      drain();
    } while (!calls_.compare_exchange_weak(seen, 0));
  }

 private:
  std::atomic<unsigned> calls_{0};
};

}  // namespace tocsin
