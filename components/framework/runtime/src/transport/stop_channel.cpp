// SPDX-License-Identifier: Apache-2.0
#include "transport/stop_channel.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <string>
#include <utility>

#include "foundation/hash.hpp"
#include "runtime/middleware/rtps_message.hpp"
#include "transport/stop_bytes.hpp"

namespace tocsin {
namespace {

// Of the kinds that RTPS 2.2 section 9.4.5.1.1 leaves to vendors (0x80 to 0xff).
constexpr std::uint8_t value_kind = 0xc8;
constexpr std::uint8_t certificate_kind = 0xc9;
constexpr std::uint8_t little_endian = 1;
constexpr std::size_t guid_prefix_at = 8;  // RTPS 2.2 section 9.4.4
constexpr std::size_t id_bytes = 8;
constexpr std::size_t longest_certificate = 1200;

/// A changed value goes so often at once: at 30 % loss one of four arrives in 99 %.
constexpr int burst_packets = 4;
constexpr Duration burst_period = std::chrono::milliseconds(15);
constexpr Duration certificate_period = std::chrono::seconds(1);
/// A restarted router may not listen yet when its first packet arrives.
constexpr int certificates_after_restart = 10;
/// Values that wait for a router that does not look, and routers that are told apart.
constexpr std::size_t most_values = 64;
constexpr std::size_t most_routers = 64;

std::vector<std::uint8_t> submessage(std::uint8_t kind, const std::vector<std::uint8_t>& content) {
  const std::size_t padded = (content.size() + 3) / 4 * 4;
  std::vector<std::uint8_t> bytes(submessage_header_bytes + padded);
  bytes[0] = kind;
  bytes[1] = little_endian;
  put_number(bytes.data() + 2, static_cast<std::uint16_t>(padded), true);
  std::copy(content.begin(), content.end(), bytes.begin() + submessage_header_bytes);
  return bytes;
}

std::uint64_t router_of(const std::uint8_t* packet) {
  constexpr std::size_t prefix_bytes = 12;
  return hash_of(std::string(packet + guid_prefix_at, packet + guid_prefix_at + prefix_bytes));
}

}  // namespace

std::vector<std::uint32_t> ipv4_addresses(const std::vector<std::string>& texts) {
  std::vector<std::uint32_t> all;
  for (const std::string& text : texts) {
    in_addr parsed{};
    all.push_back(inet_pton(AF_INET, text.c_str(), &parsed) == 1 ? ntohl(parsed.s_addr) : 0);
  }
  return all;
}

StopChannel::StopChannel(Options options) : options_(std::move(options)) {
  for (const std::uint32_t peer : options_.peers) told_[peer];
  if (options_.enclave.empty()) return;
  keystore::Signer signer(options_.enclave);
  Bytes content(2);
  put_number(content.data(), static_cast<std::uint16_t>(signer.certificate().size()), true);
  content.insert(content.end(), signer.certificate().begin(), signer.certificate().end());
  Bytes certificate = submessage(certificate_kind, content);
  seal_.emplace(
      Seal{std::move(signer), keystore::SignatureCheck(options_.enclave), std::move(certificate)});
}

void StopChannel::on_say(std::function<void()> wake) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wake_ = wake ? std::move(wake) : [] {};
}

StopChannel::Bytes StopChannel::sealed(const StopValue& value) const {
  Bytes content = to_bytes(value);
  if (!seal_) return submessage(value_kind, content);
  const Bytes signature = seal_->signer.sign(content);
  const std::uint64_t id = keystore::signer_id(seal_->signer.certificate());
  content.resize(content.size() + id_bytes + 2);
  put_number(content.data() + content.size() - id_bytes - 2, id, true);
  put_number(content.data() + content.size() - 2, static_cast<std::uint16_t>(signature.size()),
             true);
  content.insert(content.end(), signature.begin(), signature.end());
  return submessage(value_kind, content);
}

void StopChannel::say(const StopValue& value, Time now) {
  auto bytes = std::make_shared<const Bytes>(sealed(value));
  std::unique_lock<std::mutex> lock(mutex_);
  const bool is_new = !value_ || !says_the_same(*value_, value) || !is_fresh(now);
  value_ = value;
  submessage_ = std::move(bytes);
  said_ = now;
  if (!is_new) return;
  for (auto& one : told_) {
    one.second.burst = burst_packets;
    one.second.next = now;
  }
  const auto wake = wake_;
  lock.unlock();
  wake();
}

std::shared_ptr<const StopChannel::Bytes> StopChannel::ride(std::uint32_t to, std::size_t size,
                                                            Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto peer = told_.find(to);
  if (peer == told_.end() || !submessage_ || !is_fresh(now)) return nullptr;
  if (size + submessage_->size() > options_.packet_bytes) return nullptr;
  peer->second.last = now;
  peer->second.next = std::max(peer->second.next, now + stop_value_period);
  return submessage_;
}

std::vector<StopChannel::Bytes> StopChannel::due(std::uint32_t to, Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto peer = told_.find(to);
  if (peer == told_.end() || !submessage_ || !is_fresh(now)) return {};
  Told& told = peer->second;
  std::vector<Bytes> all;
  if (now >= told.next) {
    all.push_back(*submessage_);
    told.last = now;
    if (told.burst > 0) --told.burst;
    told.next = now + (told.burst > 0 ? burst_period : stop_value_period);
  }
  const Duration period = told.certificates > 0 ? stop_value_period : certificate_period;
  if (seal_ && now - told.certificate >= period) {
    all.push_back(seal_->certificate);
    told.certificate = now;
    told.certificates = std::max(0, told.certificates - 1);
  }
  return all;
}

Time StopChannel::deadline() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!submessage_) return never;
  Time next = never;
  for (const auto& one : told_) next = std::min(next, one.second.next);
  // A value that is not said again any more wakes nobody.
  return next == never || next - said_ < stop_value_lives ? next : never;
}

bool StopChannel::knows_peer(std::uint32_t address) const {
  return std::find(options_.peers.begin(), options_.peers.end(), address) != options_.peers.end();
}

std::size_t StopChannel::take(const std::uint8_t* packet, std::size_t size, std::uint32_t from,
                              Time now, std::int64_t wall_s) {
  if (size < header_bytes || !knows_peer(from)) return size;
  const std::uint64_t router = router_of(packet);
  std::size_t left = size;
  Submessages submessages(packet, size);
  std::unique_lock<std::mutex> lock(mutex_);
  while (const auto one = submessages.next()) {
    if (one->kind != value_kind && one->kind != certificate_kind) continue;
    left =
        std::min(left, static_cast<std::size_t>(one->content - packet) - submessage_header_bytes);
    if (one->kind == value_kind) {
      receive(one->content, one->bytes, router, now);
    } else if (seal_) {
      learn(one->content, one->bytes, wall_s);
    }
  }
  note_packet(router, now);
  const auto told = told_.find(from);
  const bool is_new = told != told_.end() && std::exchange(told->second.router, router) != router;
  if (is_new) told->second.certificates = certificates_after_restart;
  const bool tell = std::exchange(has_news_, false);
  lock.unlock();
  if (tell) options_.on_news();
  return left == header_bytes ? 0 : left;
}

void StopChannel::learn(const std::uint8_t* content, std::size_t size, std::int64_t wall_s) {
  constexpr std::size_t length_bytes = 2;
  if (size < length_bytes) return;
  const std::size_t length = number_at<std::uint16_t>(content, true);
  if (length > longest_certificate || length_bytes + length > size) return;
  const std::uint8_t* const begin = content + length_bytes;
  (void)seal_->check.learn(Bytes(begin, begin + length), wall_s);
}

std::optional<std::string> StopChannel::identity_in(const std::uint8_t* content,
                                                    std::size_t value_bytes,
                                                    std::size_t size) const {
  if (!seal_) return "";
  if (size < value_bytes + id_bytes + 2) return std::nullopt;
  const std::uint8_t* const at = content + value_bytes;
  const auto id = number_at<std::uint64_t>(at, true);
  const std::size_t length = number_at<std::uint16_t>(at + id_bytes, true);
  const std::uint8_t* const signature = at + id_bytes + 2;
  if (static_cast<std::size_t>(content + size - signature) < length) return std::nullopt;
  return seal_->check.signer_of(Bytes(content, content + value_bytes),
                                Bytes(signature, signature + length), id);
}

bool StopChannel::is_news(const ReceivedStop& received) {
  const auto before = last_.find(received.router);
  const bool same = before != last_.end() && says_the_same(before->second, received.value);
  if (before == last_.end() && last_.size() >= most_routers) last_.erase(last_.begin());
  last_[received.router] = received.value;
  return !same;
}

void StopChannel::receive(const std::uint8_t* content, std::size_t size, std::uint64_t router,
                          Time now) {
  const auto read = stop_value_in(content, size);
  if (!read) return;
  // The same value rides in all packets of a tenth of a second; its signature is looked at once.
  const auto before = last_.find(router);
  if (before != last_.end() && before->second == read->first) return;
  auto identity = identity_in(content, read->second, size);
  if (!identity) return;
  ReceivedStop received{read->first, router, std::move(*identity), now};
  if (is_news(received)) has_news_ = true;
  keep(std::move(received));
}

/// A flood of other values does not push out a stop.
void StopChannel::keep(ReceivedStop received) {
  auto& values = news_.values;
  if (values.size() < most_values) return values.push_back(std::move(received));
  const auto calm =
      std::find_if(values.begin(), values.end(), [](const auto& one) { return !one.value.stands; });
  if (calm == values.end()) return;
  values.erase(calm);
  values.push_back(std::move(received));
}

void StopChannel::note_packet(std::uint64_t router, Time now) {
  auto& packets = news_.packets;
  const auto found = std::find_if(packets.begin(), packets.end(),
                                  [&](const auto& one) { return one.router == router; });
  if (found != packets.end()) {
    found->received = now;
  } else if (packets.size() < most_routers) {
    packets.push_back({router, now});
  }
}

StopNews StopChannel::take_news() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(news_, {});
}

}  // namespace tocsin
