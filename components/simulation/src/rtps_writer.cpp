// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include "rtps.hpp"

namespace tocsin::simulation {

std::vector<std::size_t> wire::packets_of(std::size_t bytes) {
  constexpr std::size_t around = message_header + info_timestamp + statistics;
  // Fast DDS keeps room for a heartbeat, and measures whole samples as if they were fragments.
  constexpr std::size_t around_fragment = around + info_destination + data_fragment_header;
  constexpr std::size_t fragment = longest_message - around_fragment - heartbeat;
  if (bytes <= fragment) return {ip_and_udp + around + data_header + bytes};
  std::vector<std::size_t> packets;
  for (std::size_t left = bytes; left > 0; left -= std::min(left, fragment)) {
    packets.push_back(ip_and_udp + around_fragment + std::min(left, fragment));
  }
  return packets;
}

namespace {

/// A sample on its way to one reader, which gets it when all its packets have come.
class SampleOnAir final : public Cargo {
 public:
  SampleOnAir(const Core& core, std::uint64_t source, RtpsReader& reader, Change change,
              std::size_t packets)
      : core_(core),
        source_(source),
        reader_(reader),
        change_(std::move(change)),
        missing_(packets, true),
        left_(packets) {}
  void arrive(std::size_t packet) override {
    if (!missing_[packet]) return;
    missing_[packet] = false;
    if (--left_ == 0) reader_.on_data(source_, change_, core_.now);
  }
  [[nodiscard]] bool waits_after(std::size_t packet) const override {
    return left_ > 1 || !missing_[packet];
  }

 private:
  const Core& core_;
  std::uint64_t source_;
  RtpsReader& reader_;
  Change change_;
  std::vector<bool> missing_;
  std::size_t left_;
};

/// What a gate hands back that is not the object of the last write.
std::shared_ptr<const void> copy_of(const TypeInfo& type, const void* message, std::size_t size) {
  std::vector<std::uint8_t> cdr(size);
  if (type.serialize(message, cdr.data(), cdr.size()) == 0) return nullptr;
  std::shared_ptr<void> copy = type.create();
  return type.deserialize(cdr.data(), cdr.size(), copy.get()) ? copy : nullptr;
}

}  // namespace

RtpsWriter::RtpsWriter(Core& core, RadioLink& link, const Owner& owner, const QosProfile& qos)
    : core_(core), link_(link), owner_(owner), qos_(qos) {}

void RtpsWriter::match(RtpsReader& reader) {
  forget_expired();
  const bool history = qos_.keeps_last() && reader.qos().keeps_last() && !history_.empty();
  const std::uint64_t first = history ? history_.front().sequence : sent_ + 1;
  reader.match(owner_.source, first);
  // Of a best-effort reader nothing is asked: it counts as having all.
  const bool answers = reader.qos().reliable();
  proxies_.push_back({&reader, answers ? first - 1 : std::numeric_limits<std::uint64_t>::max()});
  if (!history) return;
  for (const Change& change : history_) transmit(reader, change);
  ask_for_heartbeat();
}

std::size_t RtpsWriter::send(const void* message) {
  const TypeInfo& type = *owner_.end->type;
  const bool known = owner_.origin->message.get() == message;
  Change change{sent_ + 1,  core_.now, nullptr,   type.serialized_size(message),
                owner_.end, 0,         core_.now, 0};
  change.message = known ? owner_.origin->message : copy_of(type, message, change.bytes);
  if (!change.message) return 0;
  const std::size_t bytes = change.bytes;
  ++sent_;
  change.sent_wall_ns = owner_.wall_ns(core_.now);
  if (known) {
    change.written = owner_.origin->sequence;
    change.written_at = owner_.origin->time;
  }
  if (core_.observer != nullptr) {
    core_.observer->on_sent({*owner_.end, core_.now, sent_, change.written, change.bytes});
  }
  history_.push_back(std::move(change));
  if (history_.size() > static_cast<std::size_t>(qos_.depth)) history_.pop_front();
  for (Proxy& proxy : proxies_) {
    if (proxy.reader->alive()) transmit(*proxy.reader, history_.back());
  }
  ask_for_heartbeat();
  return bytes;
}

void RtpsWriter::transmit(RtpsReader& reader, const Change& change) {
  const auto packets = wire::packets_of(change.bytes);
  const auto sample =
      std::make_shared<SampleOnAir>(core_, owner_.source, reader, change, packets.size());
  for (std::size_t i = 0; i < packets.size(); ++i) {
    link_.send(owner_.direction, packets[i], sample, i);
  }
}

void RtpsWriter::forget_expired() {
  const Duration lifespan = seconds(qos_.lifespan_s);
  while (!history_.empty() && core_.now - history_.front().sent > lifespan) {
    history_.pop_front();
  }
}

void RtpsWriter::ask_for_heartbeat() {
  if (heartbeat_asked_ || !qos_.reliable() || proxies_.empty()) return;
  heartbeat_asked_ = true;
  core_.events.at(core_.now + seconds(qos_.heartbeat_period_s), [this] { heartbeat(); });
}

void RtpsWriter::heartbeat() {
  heartbeat_asked_ = false;
  if (!alive_) return;
  forget_expired();
  if (history_.empty()) return;
  bool all_have_it = true;
  for (Proxy& proxy : proxies_) {
    if (proxy.acknowledged >= sent_ || !proxy.reader->alive()) continue;
    all_have_it = false;
    send_heartbeat(proxy);
  }
  if (!all_have_it) ask_for_heartbeat();
}

void RtpsWriter::send_heartbeat(Proxy& proxy) {
  constexpr std::size_t bytes =
      wire::ip_and_udp + wire::message_header + wire::heartbeat + wire::statistics;
  const std::uint64_t first = history_.front().sequence;
  const std::uint64_t last = sent_;
  link_.send(owner_.direction, bytes, [this, &proxy, first, last] {
    const Time answer_at = core_.now + seconds(proxy.reader->qos().heartbeat_response_delay_s);
    core_.events.at(answer_at, [this, &proxy, first, last] {
      constexpr std::size_t size = wire::ip_and_udp + wire::message_header +
                                   wire::info_destination + wire::acknack + wire::statistics;
      if (!proxy.reader->alive()) return;
      auto missing = proxy.reader->on_heartbeat(owner_.source, first, last, core_.now);
      link_.send(back(owner_.direction), size, [this, &proxy, last, missing = std::move(missing)] {
        on_acknack(proxy, last, missing);
      });
    });
  });
}

void RtpsWriter::on_acknack(Proxy& proxy, std::uint64_t last,
                            const std::vector<std::uint64_t>& missing) {
  if (!alive_) return;
  const std::uint64_t acknowledged = missing.empty() ? last : missing.front() - 1;
  proxy.acknowledged = std::max(proxy.acknowledged, acknowledged);
  if (missing.empty()) return;
  core_.events.at(core_.now + seconds(qos_.nack_response_delay_s), [this, &proxy, missing] {
    if (!alive_ || !proxy.reader->alive()) return;
    forget_expired();
    for (const std::uint64_t sequence : missing) repair(*proxy.reader, sequence);
  });
}

void RtpsWriter::repair(RtpsReader& reader, std::uint64_t sequence) {
  if (const Change* change = find(sequence)) return transmit(reader, *change);
  constexpr std::size_t bytes = wire::ip_and_udp + wire::message_header + wire::info_destination +
                                wire::gap + wire::statistics;
  link_.send(owner_.direction, bytes,
             [this, &reader, sequence] { reader.on_gap(owner_.source, sequence, core_.now); });
}

const Change* RtpsWriter::find(std::uint64_t sequence) const {
  const auto found = std::find_if(history_.begin(), history_.end(),
                                  [sequence](const Change& c) { return c.sequence == sequence; });
  return found == history_.end() ? nullptr : &*found;
}

}  // namespace tocsin::simulation
