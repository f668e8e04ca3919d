// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>

namespace tocsin {

class PacketFilter;

/// Keeps what arrives at a participant in its sockets until the participant can take it.
///
/// Fast DDS 2.9.1 announces a participant before it registers its receivers, and throws away what
/// comes between. A peer answers an announcement within 0.3 ms, once; when that answer is lost, the
/// next one comes with the peer's periodic announcement, a second later.
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

/// The transport of `low`, whose reception is held until `reception` is released, and then shown
/// what `filter` lets through.
[[nodiscard]] std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> hold(
    std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> low,
    std::shared_ptr<DeferredReception> reception, std::shared_ptr<PacketFilter> filter);

}  // namespace tocsin
