// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/deferred_reception.hpp"

#include <fastdds/rtps/transport/ChainingTransport.h>

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fast_dds/lone_keys.hpp"
#include "fast_dds/packet_filter.hpp"
#include "fast_dds/socket_wait.hpp"
#include "watch/activity.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using namespace eprosima::fastdds::rtps;

struct HoldingDescriptor : ChainingTransportDescriptor {
  HoldingDescriptor(std::shared_ptr<TransportDescriptorInterface> low,
                    std::shared_ptr<DeferredReception> held,
                    std::shared_ptr<PacketFilter> its_filter)
      : ChainingTransportDescriptor(std::move(low)),
        reception(std::move(held)),
        filter(std::move(its_filter)) {}
  [[nodiscard]] TransportInterface* create_transport() const override;
  std::shared_ptr<DeferredReception> reception;
  std::shared_ptr<PacketFilter> filter;
};

/// One port of a transport: what its thread is seen to do, and its socket once that is open.
struct Reception {
  std::shared_ptr<Activity> activity;
  std::shared_ptr<const SocketWait> socket;
};

/// The receptions of a transport, by port.
class Receptions {
 public:
  void open(std::uint32_t port) {
    const std::lock_guard<std::mutex> lock(mutex_);
    by_port_[port].activity =
        watched_activity(Duty::reception, "reception at UDP " + std::to_string(port),
                         static_cast<std::uint16_t>(port));
  }
  void opened(std::uint32_t port) {
    auto socket = std::make_shared<const SocketWait>(static_cast<std::uint16_t>(port));
    const std::lock_guard<std::mutex> lock(mutex_);
    by_port_[port].socket = std::move(socket);
  }
  void close(std::uint32_t port) {
    const std::lock_guard<std::mutex> lock(mutex_);
    by_port_.erase(port);
  }
  /// Empty for a port that is not open.
  [[nodiscard]] Reception at(std::uint32_t port) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = by_port_.find(port);
    return found == by_port_.end() ? Reception{} : found->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::uint32_t, Reception> by_port_;
};

/// Receives through the chain, and sends without it.
class HoldingTransport : public ChainingTransport {
 public:
  explicit HoldingTransport(HoldingDescriptor descriptor)
      : ChainingTransport(descriptor), descriptor_(std::move(descriptor)) {}

  [[nodiscard]] TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  void receive(TransportReceiverInterface* next, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    const Reception at = receptions_.at(local.port);
    const HandingOn handing_on(at.socket ? at.socket->of_last() : Duration{0});
    std::optional<ActivityTurn> turn;
    if (at.activity) turn.emplace(*at.activity);
    descriptor_.reception->wait();
    std::vector<std::uint8_t> changed;
    descriptor_.filter->pass(
        bytes, size, remote, PacketFilter::kind_of(local.port),
        [&](const rtps::octet* shown, std::size_t length) {
          const auto [message, its_size] = with_lone_keys(shown, length, changed);
          next->OnDataReceived(message, static_cast<std::uint32_t>(its_size), local, remote);
        });
  }
  bool OpenInputChannel(const rtps::Locator_t& at, TransportReceiverInterface* receiver,
                        std::uint32_t largest) override {
    receptions_.open(at.port);
    const bool open = ChainingTransport::OpenInputChannel(at, receiver, largest);
    open ? receptions_.opened(at.port) : receptions_.close(at.port);
    return open;
  }
  /// Not chained: the lower transport would not know its own channel again, and open another for
  /// each peer.
  bool OpenOutputChannel(SendResourceList& channels, const rtps::Locator_t& to) override {
    return low_level_transport_->OpenOutputChannel(channels, to);
  }
  // NOLINTNEXTLINE(readability-function-size): the signature is that of Fast DDS
  bool send(rtps::SenderResource* channel, const rtps::octet* bytes, std::uint32_t size,
            rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
            const std::chrono::steady_clock::time_point& timeout) override {
    return channel->send(bytes, size, first, last, timeout);
  }
  bool CloseInputChannel(const rtps::Locator_t& at) override {
    descriptor_.reception->release();
    receptions_.close(at.port);
    return ChainingTransport::CloseInputChannel(at);
  }

 private:
  HoldingDescriptor descriptor_;
  Receptions receptions_;
};

TransportInterface* HoldingDescriptor::create_transport() const {
  return new HoldingTransport(*this);
}

}  // namespace

void DeferredReception::release() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    released_ = true;
  }
  changed_.notify_all();
}

void DeferredReception::wait() {
  if (released_.load(std::memory_order_acquire)) return;
  std::unique_lock<std::mutex> lock(mutex_);
  (void)changed_.wait_for(lock, std::chrono::seconds(1), [this] { return released_.load(); });
}

std::shared_ptr<TransportDescriptorInterface> hold(
    std::shared_ptr<TransportDescriptorInterface> low, std::shared_ptr<DeferredReception> reception,
    std::shared_ptr<PacketFilter> filter) {
  return std::make_shared<HoldingDescriptor>(std::move(low), std::move(reception),
                                             std::move(filter));
}

}  // namespace tocsin
