// SPDX-License-Identifier: Apache-2.0
#include "link/radio_transport.hpp"

#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastrtps/utils/IPLocator.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "fast_dds/this_host.hpp"
#include "link/authentication_repeats.hpp"
#include "link/discovery_pacer.hpp"
#include "link/radio_socket.hpp"
#include "link/rtps_message.hpp"
#include "watch/activity.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using namespace eprosima::fastdds::rtps;
using Deadline = std::chrono::steady_clock::time_point;

/// At 30 % loss one of so many arrives in 99.8 %.
constexpr std::size_t copies_of_last = 5;
constexpr std::uint32_t largest_datagram = 65500;

/// Of a participant with DDS Security; both null without.
struct Securing {
  std::shared_ptr<OtherMakers> others;
  std::shared_ptr<AuthenticationRepeats> repeats;
};

/// Sends what the pacer holds back when its time has come, and values of the emergency stop, on a
/// thread of its own.
class MarkingSender : public rtps::SenderResource {
 public:
  MarkingSender(const std::string& address, std::shared_ptr<RadioMarks> marks, Securing securing,
                StopWay stop)
      : SenderResource(LOCATOR_KIND_UDPv4),
        socket_(address),
        marks_(std::move(marks)),
        others_(std::move(securing.others)),
        repeats_(std::move(securing.repeats)),
        stop_(std::move(stop)),
        thread_([this] { run(); }) {
    pthread_setname_np(thread_.native_handle(), "link_discovery");
    send_lambda_ = [this](const rtps::octet* bytes, std::uint32_t size,
                          rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
                          const Deadline&) { return send_to_all(bytes, size, *first, *last); };
    if (stop_.channel) stop_.channel->on_say([this] { wake(); });
  }
  ~MarkingSender() override {
    if (stop_.channel) stop_.channel->on_say({});
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  [[nodiscard]] bool usable() const { return socket_.usable(); }

 private:
  bool send_to_all(const rtps::octet* bytes, std::size_t whole, rtps::LocatorsIterator& next,
                   const rtps::LocatorsIterator& last) {
    const std::size_t size = size_without_statistics(bytes, whole);
    const auto authentication = repeats_ ? authentication_in(bytes, size) : std::nullopt;
    if (authentication && authentication->goes_elsewhere) return true;
    const auto state = discovery_state_in(bytes, size);
    std::optional<ActivityTurn> turn;
    if (is_announcement(bytes, size)) turn.emplace(*timer_);
    bool all = true;
    for (; next != last; ++next) {
      const rtps::Locator_t& to = *next;
      if (to.kind != LOCATOR_KIND_UDPv4 || rtps::IPLocator::isMulticast(to)) continue;
      if (state && !passes(*state, {{bytes, bytes + size}, to})) continue;
      all = send_in_pieces(bytes, size, to, authentication) && all;
    }
    return all;
  }
  bool send_in_pieces(const rtps::octet* bytes, std::size_t size, const rtps::Locator_t& to,
                      const std::optional<Authentication>& authentication) {
    const bool is_short = size <= radio_message_bytes && !authentication;
    if (is_short || (others_ && others_->are_at(ipv4_of(to)))) {
      return send_one(bytes, size, to, marks_->mark(bytes, size, size));
    }
    bool all = true;
    std::unique_lock<std::mutex> lock(mutex_);
    auto pieces = pieces_.of(bytes, size);
    lock.unlock();
    // The last message of a handshake has no answer, and what is sealed with its keys follows at
    // once: who has not received it never asks for that.
    const bool is_last = authentication && pieces.size() == 1;
    if (is_last) pieces.resize(copies_of_last, pieces.front());
    for (const auto& piece : pieces) {
      all =
          send_one(piece.data(), piece.size(), to, marks_->mark(bytes, size, piece.size())) && all;
    }
    if (authentication && !is_last) {
      repeats_->sent(authentication->addressee, {std::move(pieces), to},
                     std::chrono::steady_clock::now());
      wake();
    }
    return all;
  }
  bool send_one(const rtps::octet* bytes, std::size_t size, const rtps::Locator_t& to, int dscp) {
    note_header(bytes, size);
    const auto stop = stop_.channel
                          ? stop_.channel->ride(ipv4_of(to), size, std::chrono::steady_clock::now())
                          : nullptr;
    return stop ? socket_.send(bytes, size, to, dscp, *stop) : socket_.send(bytes, size, to, dscp);
  }
  /// Values of the stop that go alone say by it who has sent them.
  void note_header(const rtps::octet* bytes, std::size_t size) {
    if (has_header_.load(std::memory_order_acquire) || size < header_bytes) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    std::copy_n(bytes, header_bytes, header_.begin());
    has_header_.store(true, std::memory_order_release);
    changed_.notify_one();
  }
  void send_stops(Time now) {
    if (!stop_.channel || !has_header_.load(std::memory_order_acquire)) return;
    for (const std::uint32_t peer : stop_.channel->peers()) {
      for (const auto& bytes : stop_.channel->due(peer, now)) {
        for (const rtps::Locator_t& to : stop_.peers) {
          if (ipv4_of(to) != peer) continue;
          (void)socket_.send(header_.data(), header_.size(), to,
                             marks_->mark_stop(header_.size() + bytes.size()), bytes);
        }
      }
    }
  }
  void send_repeats(Time now) {
    while (const auto due = repeats_ ? repeats_->take_due(now) : std::nullopt) {
      for (const auto& packet : due->packets) {
        (void)send_one(packet.data(), packet.size(), due->to,
                       marks_->mark(packet.data(), packet.size(), packet.size()));
      }
    }
  }
  void wake() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      woken_ = true;
    }
    changed_.notify_one();
  }
  bool passes(const StateKey& state, const DiscoveryPacer::Held& message) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (pacer_.passes(state, message, std::chrono::steady_clock::now())) return true;
    }
    changed_.notify_one();
    return false;
  }
  void run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!stopping_) {
      if (const auto due = pacer_.take_due(std::chrono::steady_clock::now())) {
        const auto& bytes = due->message;
        (void)socket_.send(bytes.data(), bytes.size(), due->to,
                           marks_->mark(bytes.data(), bytes.size(), bytes.size()));
        continue;
      }
      woken_ = false;
      lock.unlock();
      send_repeats(std::chrono::steady_clock::now());
      send_stops(std::chrono::steady_clock::now());
      lock.lock();
      if (!woken_ && !stopping_) sleep(lock);
    }
  }
  void sleep(std::unique_lock<std::mutex>& lock) {
    const bool says = stop_.channel && has_header_.load(std::memory_order_acquire);
    Time deadline = pacer_.deadline();
    if (says) deadline = std::min(deadline, stop_.channel->deadline());
    if (repeats_) deadline = std::min(deadline, repeats_->deadline());
    if (deadline == never) {
      changed_.wait(lock);
    } else {
      changed_.wait_until(lock, deadline);
    }
  }

  RadioSocket socket_;
  std::shared_ptr<RadioMarks> marks_;
  std::shared_ptr<OtherMakers> others_;
  std::shared_ptr<AuthenticationRepeats> repeats_;
  const StopWay stop_;
  std::mutex mutex_;
  std::condition_variable changed_;
  DiscoveryPacer pacer_;
  MessagePieces pieces_;
  bool stopping_ = false;
  bool woken_ = false;
  std::atomic<bool> has_header_{false};
  std::array<rtps::octet, header_bytes> header_{};  ///< does not change once it is there
  const std::shared_ptr<Activity> timer_ =
      watched_activity(Duty::announcements, "timer of the link's participant");
  std::thread thread_;  // last: it uses all of this
};

struct MarkingDescriptor : ChainingTransportDescriptor {
  MarkingDescriptor(std::shared_ptr<TransportDescriptorInterface> low, std::string its_address,
                    std::shared_ptr<RadioMarks> its_marks, std::shared_ptr<OtherMakers> others,
                    StopWay its_stop)
      : ChainingTransportDescriptor(std::move(low)),
        address(std::move(its_address)),
        marks(std::move(its_marks)),
        stop(std::move(its_stop)) {
    maxMessageSize = others ? largest_datagram : radio_message_bytes;
    if (others) securing = {others, std::make_shared<AuthenticationRepeats>()};
  }
  [[nodiscard]] TransportInterface* create_transport() const override;
  [[nodiscard]] std::uint32_t max_message_size() const override { return maxMessageSize; }
  std::string address;
  std::shared_ptr<RadioMarks> marks;
  Securing securing;
  StopWay stop;
};

class MarkingTransport : public ChainingTransport {
 public:
  explicit MarkingTransport(MarkingDescriptor descriptor)
      : ChainingTransport(descriptor), descriptor_(std::move(descriptor)) {}

  [[nodiscard]] TransportDescriptorInterface* get_configuration() override { return &descriptor_; }
  bool OpenInputChannel(const rtps::Locator_t& at, TransportReceiverInterface* receiver,
                        std::uint32_t) override {
    return ChainingTransport::OpenInputChannel(at, receiver, largest_datagram);
  }
  void receive(TransportReceiverInterface* next, const rtps::octet* bytes, std::uint32_t size,
               const rtps::Locator_t& local, const rtps::Locator_t& remote) override {
    if (descriptor_.securing.repeats) descriptor_.securing.repeats->on_packet(bytes, size);
    const std::size_t left = without_stop(bytes, size, remote);
    if (left == 0) return;
    next->OnDataReceived(bytes, static_cast<std::uint32_t>(left), local, remote);
  }
  /// One socket sends to all peers.
  bool OpenOutputChannel(SendResourceList& channels, const rtps::Locator_t& to) override {
    if (to.kind != kind()) return false;
    for (const auto& one : channels) {
      if (dynamic_cast<const MarkingSender*>(one.get()) != nullptr) return true;
    }
    auto sender = std::make_unique<MarkingSender>(descriptor_.address, descriptor_.marks,
                                                  descriptor_.securing, descriptor_.stop);
    if (!sender->usable()) return false;
    channels.push_back(std::move(sender));
    return true;
  }
  // NOLINTNEXTLINE(readability-function-size): the signature is that of Fast DDS
  bool send(rtps::SenderResource* channel, const rtps::octet* bytes, std::uint32_t size,
            rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
            const Deadline& deadline) override {
    return channel->send(bytes, size, first, last, deadline);
  }

 private:
  /// The size of a packet without the value of the stop in it, which has then been taken.
  [[nodiscard]] std::size_t without_stop(const rtps::octet* bytes, std::size_t size,
                                         const rtps::Locator_t& remote) const {
    if (!descriptor_.stop.channel) return size;
    return descriptor_.stop.channel->take(bytes, size, ipv4_of(remote),
                                          std::chrono::steady_clock::now(),
                                          wall_now_ns() / 1'000'000'000);
  }
  MarkingDescriptor descriptor_;
};

TransportInterface* MarkingDescriptor::create_transport() const {
  return new MarkingTransport(*this);
}

}  // namespace

std::shared_ptr<TransportDescriptorInterface> marked(std::shared_ptr<UDPv4TransportDescriptor> udp,
                                                     std::shared_ptr<RadioMarks> marks,
                                                     std::shared_ptr<OtherMakers> others,
                                                     StopWay stop) {
  const std::string address =
      udp->interfaceWhiteList.empty() ? "0.0.0.0" : udp->interfaceWhiteList.front();
  udp->maxMessageSize = largest_datagram;
  return std::make_shared<MarkingDescriptor>(std::move(udp), address, std::move(marks),
                                             std::move(others), std::move(stop));
}

}  // namespace tocsin
