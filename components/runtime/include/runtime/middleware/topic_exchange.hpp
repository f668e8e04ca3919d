// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <vector>

#include "runtime/bus.hpp"

namespace tocsin {

/// Hands the samples of one topic to its receivers in this process. Thread-safe; the order in
/// which one writer delivers is the order in which every receiver gets it.
class TopicExchange {
 public:
  /// `keeps_last`: a receiver that attaches later gets the last sample at once.
  explicit TopicExchange(bool keeps_last) : keeps_last_(keeps_last) {}

  void attach(Receiver& receiver);
  /// Waits until `receiver` is not being called any more.
  void detach(Receiver& receiver);
  void deliver(const Sample& sample);

 private:
  const bool keeps_last_;
  std::mutex mutex_;
  std::vector<Receiver*> receivers_;
  Sample last_;
};

}  // namespace tocsin
