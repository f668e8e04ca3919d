// SPDX-License-Identifier: Apache-2.0
#include "transport/radio_side.hpp"

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

#include "fast_dds_v2/authentication_repeats.hpp"
#include "fast_dds_v2/discovery_pacer.hpp"
#include "fast_dds_v2/key_repeats.hpp"
#include "fast_dds_v2/message_pieces.hpp"
#include "rtps/this_host.hpp"
#include "runtime/middleware/rtps_message.hpp"
#include "transport/radio_socket.hpp"
#include "watch/activity.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;

constexpr std::uint32_t largest_datagram = 65500;
/// At 30 % loss one of so many arrives in 99.8 %.
constexpr std::size_t copies_of_last = 5;

/// Sends what the pacer holds back when its time has come, and values of the emergency stop, on a
/// thread of its own.
class RadioSender : public fast_dds::PacketSender {
 public:
  RadioSender(const std::string& address, RadioParts parts)
      : sockets_{std::make_unique<RadioSocket>(address), second_socket(parts)},
        parts_(std::move(parts)),
        thread_([this] { run(); }) {
    pthread_setname_np(thread_.native_handle(), "link_discovery");
    if (parts_.stop) parts_.stop->on_say([this] { wake(); });
  }
  ~RadioSender() override {
    if (parts_.stop) parts_.stop->on_say({});
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }
  [[nodiscard]] bool usable() const { return sockets_[0]->usable(); }

 private:
  using Way = RadioMarks::Way;
  static std::unique_ptr<RadioSocket> second_socket(const RadioParts& parts) {
    const std::string& second = parts.ports->second_address();
    return second.empty() ? nullptr : std::make_unique<RadioSocket>(second);
  }
  bool send_packet(const std::uint8_t* bytes, std::uint32_t whole, rtps::LocatorsIterator& next,
                   const rtps::LocatorsIterator& last) override {
    const std::size_t size = size_without_statistics(bytes, whole);
    const auto authentication = parts_.repeats ? authentication_in(bytes, size) : std::nullopt;
    if (authentication && authentication->goes_elsewhere) return true;
    const auto state = discovery_state_in(bytes, size);
    // A longer message would go in pieces; those of Fast DDS 2.9.1 have 120 to 712 bytes.
    const bool has_keys =
        parts_.repeats && size <= radio_message_bytes && is_key_exchange(bytes, size);
    std::optional<ActivityTurn> turn;
    if (is_announcement(bytes, size)) turn.emplace(*timer_);
    bool all = true;
    for (; next != last; ++next) {
      const rtps::Locator_t& to = *next;
      if (!goes_to(to, bytes, size)) continue;
      if (state && !passes(*state, {{bytes, bytes + size}, to})) continue;
      if (has_keys) repeat_keys({{bytes, bytes + size}, to});
      all = send_in_pieces(bytes, size, to, authentication) && all;
    }
    return all;
  }
  /// A topic that both sides write matches this participant, too, which needs nothing of itself.
  [[nodiscard]] bool goes_to(const rtps::Locator_t& to, const std::uint8_t* bytes,
                             std::size_t size) const {
    return to.kind == LOCATOR_KIND_UDPv4 && !rtps::IPLocator::isMulticast(to) &&
           !parts_.ports->is_own(to) && !parts_.marks->withholds(bytes, size, ipv4_of(to));
  }
  bool send_in_pieces(const rtps::octet* bytes, std::size_t size, const rtps::Locator_t& to,
                      const std::optional<Authentication>& authentication) {
    const bool is_short = size <= radio_message_bytes && !authentication;
    if (is_short || (parts_.others && parts_.others->are_at(ipv4_of(to)))) {
      return send_one(bytes, size, to, parts_.marks->mark(bytes, size, size));
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
          send_one(piece.data(), piece.size(), to, parts_.marks->mark(bytes, size, piece.size())) &&
          all;
    }
    if (authentication && !is_last) {
      parts_.repeats->sent(authentication->addressee, {std::move(pieces), to},
                           std::chrono::steady_clock::now());
      wake();
    }
    return all;
  }
  bool send_one(const rtps::octet* bytes, std::size_t size, const rtps::Locator_t& to,
                const Way& way) {
    note_header(bytes, size);
    return send_ways(bytes, size, to, way);
  }
  /// Whether one of the paths took it: Fast DDS holds back what follows one that none took.
  bool send_ways(const rtps::octet* bytes, std::size_t size, const rtps::Locator_t& to,
                 const Way& way) {
    bool any = false;
    if (way.paths[0]) any = send_by(0, {bytes, size}, to, way.dscp);
    const auto second = way.paths[1] ? parts_.ports->second_of(to) : std::nullopt;
    if (second) any = send_by(1, {bytes, size}, *second, way.dscp) || any;
    return any;
  }
  bool send_by(PathIndex path, const TransportSide::Packet& packet, const rtps::Locator_t& to,
               int dscp) {
    const auto [bytes, size] = packet;
    const auto stop = parts_.stop
                          ? parts_.stop->ride(ipv4_of(to), size, std::chrono::steady_clock::now())
                          : nullptr;
    if (!stop) return sockets_[path]->send(bytes, size, to, dscp);
    parts_.marks->note_rider(stop->size(), path);
    return sockets_[path]->send(bytes, size, to, dscp, *stop);
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
    if (!parts_.stop || !has_header_.load(std::memory_order_acquire)) return;
    for (const std::uint32_t peer : parts_.stop->peers()) {
      for (const auto& bytes : parts_.stop->due(peer, now)) send_stop(peer, bytes);
    }
  }
  void send_stop(std::uint32_t peer, const StopChannel::Bytes& bytes) {
    const PathIndex path = parts_.ports->is_second(peer) ? 1 : 0;
    for (const rtps::Locator_t& to : parts_.stop_peers) {
      if (ipv4_of(to) != peer) continue;
      const int dscp = parts_.marks->mark_stop(header_.size() + bytes.size(), path);
      (void)sockets_[path]->send(header_.data(), header_.size(), to, dscp, bytes);
    }
  }
  void send_repeats(Time now) {
    while (const auto due = parts_.repeats ? parts_.repeats->take_due(now) : std::nullopt) {
      for (const auto& packet : due->packets) {
        (void)send_one(packet.data(), packet.size(), due->to,
                       parts_.marks->mark(packet.data(), packet.size(), packet.size()));
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
  void repeat_keys(KeyRepeats::Packet packet) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      keys_.sent(std::move(packet), std::chrono::steady_clock::now());
    }
    wake();
  }
  void send_paced(const std::vector<rtps::octet>& bytes, const rtps::Locator_t& to) {
    (void)send_ways(bytes.data(), bytes.size(), to,
                    parts_.marks->mark(bytes.data(), bytes.size(), bytes.size()));
  }
  void run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!stopping_) {
      if (const auto due = pacer_.take_due(std::chrono::steady_clock::now())) {
        send_paced(due->message, due->to);
        continue;
      }
      if (const auto due = keys_.take_due(std::chrono::steady_clock::now())) {
        send_paced(due->bytes, due->to);
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
    const bool says = parts_.stop && has_header_.load(std::memory_order_acquire);
    Time deadline = std::min(pacer_.deadline(), keys_.deadline());
    if (says) deadline = std::min(deadline, parts_.stop->deadline());
    if (parts_.repeats) deadline = std::min(deadline, parts_.repeats->deadline());
    if (deadline == never) {
      changed_.wait(lock);
    } else {
      changed_.wait_until(lock, deadline);
    }
  }

  const std::array<std::unique_ptr<RadioSocket>, most_paths> sockets_;  ///< the second may be null
  const RadioParts parts_;
  std::mutex mutex_;
  std::condition_variable changed_;
  DiscoveryPacer pacer_;
  KeyRepeats keys_;
  MessagePieces pieces_;
  bool stopping_ = false;
  bool woken_ = false;
  std::atomic<bool> has_header_{false};
  std::array<rtps::octet, header_bytes> header_{};  ///< does not change once it is there
  const std::shared_ptr<Activity> timer_ =
      watched_activity(Duty::announcements, "timer of the link's participant");
  std::thread thread_;  // last: it uses all of this
};

class RadioSide final : public TransportSide {
 public:
  RadioSide(std::string address, RadioParts parts)
      : address_(std::move(address)), parts_(std::move(parts)) {}

  [[nodiscard]] std::unique_ptr<Sender> make_sender() override {
    auto sender = std::make_unique<RadioSender>(address_, parts_);
    return sender->usable() ? std::move(sender) : nullptr;
  }
  /// Without the value of the stop in it, which has then been taken.
  [[nodiscard]] Packet received(const Packet& packet, const Locator& from,
                                std::vector<std::uint8_t>& /*changed*/) override {
    if (parts_.repeats) parts_.repeats->on_packet(packet.first, packet.second);
    if (!parts_.stop) return packet;
    return {packet.first,
            parts_.stop->take(packet.first, packet.second, ipv4_of(from),
                              std::chrono::steady_clock::now(), wall_now_ns() / 1'000'000'000)};
  }
  /// Its sender has an address, whichever interface bears that, and when.
  [[nodiscard]] bool reach(const Locator& remote, Locator& result) const override {
    result = remote;
    return remote.kind == LOCATOR_KIND_UDPv4;
  }
  [[nodiscard]] Locator known_as(const Locator& from) const override {
    return parts_.ports->first_of(from).value_or(from);
  }
  [[nodiscard]] RadioPorts* ports() override { return parts_.ports.get(); }
  [[nodiscard]] std::unique_lock<std::mutex> turn(const Locator& local) override {
    return std::unique_lock<std::mutex>(turns_[local.port % 2]);
  }
  [[nodiscard]] std::uint32_t message_bytes() const override {
    return parts_.others ? largest_datagram : static_cast<std::uint32_t>(radio_message_bytes);
  }

 private:
  const std::string address_;
  const RadioParts parts_;
  /// Packets of two paths come to a port by two threads.
  std::array<std::mutex, 2> turns_;
};

}  // namespace

std::shared_ptr<TransportSide> radio_side(const std::string& address, RadioParts parts) {
  return std::make_shared<RadioSide>(address, std::move(parts));
}

}  // namespace tocsin
