// SPDX-License-Identifier: Apache-2.0
#include "faulty_link.hpp"

namespace tocsin::router {
namespace {

constexpr Duration ms = std::chrono::milliseconds(1);
constexpr Duration step_length = 10 * ms;
constexpr Duration recovery = 2000 * ms;
constexpr Duration longest_period = 500 * ms;
constexpr Duration forged_delay = 300 * ms;
constexpr const char* vehicle = "vehicle";
constexpr const char* station = "station";
constexpr SourceId source = 7;

}  // namespace

FaultyLink::FaultyLink(unsigned seed) : random_(seed) {
  clock_difference_ = (below(2'000'000) - 1'000'000) * ms;
  end_of_faults_ = now_ + (1000 + below(3000)) * ms;
  const Duration forever = Duration::max();
  add_stream(1, 200 * ms, chance(0.5) ? 1000 * ms : forever, 1);  // as the emergency stop
  add_stream(2, 100 * ms, chance(0.5) ? 500 * ms : forever, 1);
  add_stream(3, longest_period, forever, static_cast<std::size_t>(1 + below(4)));
  restart_sender();
  restart_receiver();
}

void FaultyLink::add_stream(StreamId id, Duration period, Duration lifespan, std::size_t depth) {
  Stream& stream = streams_[id];
  stream.rule.name = "topic" + std::to_string(id);
  stream.rule.traffic_class = TrafficClass::critical;
  stream.rule.repaired = true;
  stream.rule.lifespan = lifespan;
  stream.rule.depth = depth;
  stream.period = period;
  stream.bytes = id == 3 && chance(0.5) ? 5000 : 200;
  stream.next = now_ + below(100) * ms;
}

void FaultyLink::restart_sender() {
  sender_ = std::make_unique<LinkSender>(params_);
  ++sender_instance_;
  numbers_.clear();
  air_.clear();
  for (const auto& [id, stream] : streams_) sender_->add_stream(id, stream.rule);
  if (receiver_) introduce();
}

void FaultyLink::restart_receiver() {
  receiver_ = std::make_unique<LinkReceiver>();
  ++receiver_instance_;
  for (auto& entry : streams_) entry.second.delivered.clear();
  introduce();
}

void FaultyLink::introduce() {
  receiver_->on_peer(vehicle, sender_instance_);
  sender_->on_peer(station, receiver_instance_, now_);
  for (const auto& [id, stream] : streams_) {
    receiver_->on_stream(vehicle, id, stream.rule);
    sender_->set_wanted(station, id, true, now_);
  }
}

std::string FaultyLink::run() {
  while (now_ < end_of_faults_) {
    if (chance(0.03)) fault();
    step();
  }
  loss_ = 0;
  sender_frozen_ = std::min(sender_frozen_, now_);
  receiver_frozen_ = std::min(receiver_frozen_, now_);
  last_fault_ = now_ + forged_delay;  // when the last of it is received
  while (now_ < last_fault_ + recovery + longest_period) step();
  for (const auto& [id, stream] : streams_) {
    if (stream.again > last_fault_ + recovery + stream.period)
      broken_ += "stream " + std::to_string(id) + " is silent; ";
  }
  return broken_;
}

void FaultyLink::fault() {
  switch (below(8)) {
    case 0:
      sender_frozen_ = now_ + below(6000) * ms;
      break;
    case 1:
      receiver_frozen_ = now_ + below(6000) * ms;
      break;
    case 2:
      return restart_sender();
    case 3:
      return restart_receiver();
    case 4:
      loss_ = chance(0.3) ? 1 : 0.01 * below(60);
      break;
    case 5:
      return forge_sample();
    case 6:
      return forge_acknowledgement();
    default:
      return replay();
  }
}

void FaultyLink::forge_sample() {
  ++forged_;
  const auto id = static_cast<StreamId>(1 + below(3));
  const std::array<std::uint64_t, 4> sequences{~std::uint64_t{0}, std::uint64_t{1} << 40U,
                                               streams_[id].sequence + 5, 1};
  const std::array<Duration, 5> ahead{0 * ms, 400 * ms, 1900 * ms, 3'600'000 * ms, -3'600'000 * ms};
  const std::array<TransmissionNumber, 3> numbers{1, 1U << 20U, std::uint64_t{1} << 52U};
  Transmission one;
  one.stream = id;
  const TransmissionNumber number = numbers[static_cast<std::size_t>(below(3))];
  if (chance(0.3)) one.piece = {static_cast<std::uint8_t>(below(5)), 5};
  one.sample.origin = {source, sequences[static_cast<std::size_t>(below(4))],
                       now_ + clock_difference_ + ahead[static_cast<std::size_t>(below(5))]};
  for (int i = 1 + below(12); i > 0; --i) {
    air_.emplace(now_ + below(forged_delay / ms) * ms, OnAir{one, number, false});
  }
}

void FaultyLink::forge_acknowledgement() {
  ++forged_;
  LinkAcknowledgement acknowledgement{~0U, now_, {}};
  acknowledgement.made += (below(2'000'000) - 1'000'000) * ms;
  if (chance(0.3)) acknowledgement.count = static_cast<std::uint32_t>(random_());
  const auto id = static_cast<StreamId>(1 + below(3));
  acknowledgement.streams.push_back({id, random_(), below(6000) * ms, chance(0.5) ? ~0ULL : 0});
  if (sender_runs()) sender_->on_acknowledgement(station, acknowledgement, now_);
}

void FaultyLink::replay() {
  if (received_.empty()) return;
  const std::size_t first = random_() % received_.size();
  for (std::size_t i = first; i < received_.size() && i < first + 20; ++i) {
    air_.emplace(now_ + below(200) * ms, received_[i]);
  }
}

void FaultyLink::step() {
  now_ += step_length;
  offer();
  if (sender_runs()) send();
  if (!receiver_runs()) return;
  receive();
  acknowledge();
}

/// A frozen router finds the newest of what the host wrote meanwhile.
void FaultyLink::offer() {
  for (auto& [id, stream] : streams_) {
    if (now_ < stream.next) continue;
    stream.next += stream.period;
    ++stream.sequence;
    if (!sender_runs()) continue;
    sender_->offer(id, {{source, stream.sequence, now_ + clock_difference_}, stream.bytes, nullptr},
                   now_);
  }
}

void FaultyLink::send() {
  while (const auto one = sender_->next(now_)) {
    const OnAir sent{*one, ++numbers_[one->stream], true};
    sender_->on_written(*one, sent.number);
    received_.push_back(sent);
    if (chance(loss_)) continue;
    for (int i = chance(0.05) ? 2 : 1; i > 0; --i) {
      const Duration delay = chance(0.1) ? below(150) * ms : 2 * ms;
      air_.emplace(now_ + delay, sent);
    }
  }
}

/// What arrives while it is frozen is dropped: it has outlived its time in the socket.
void FaultyLink::receive() {
  for (; !air_.empty() && air_.begin()->first <= now_; air_.erase(air_.begin())) {
    const OnAir& one = air_.begin()->second;
    if (now_ - air_.begin()->first > 300 * ms) continue;
    take(one.what.stream, one);
  }
}

void FaultyLink::take(StreamId id, const OnAir& one) {
  const Origin& origin = one.what.sample.origin;
  const Arrived arrived{id, one.number, origin, one.what.piece, nullptr};
  if (!receiver_->on_piece(vehicle, arrived, now_)) return;
  const auto disposition = receiver_->on_arrived(vehicle, arrived, now_);
  if (disposition != Disposition::deliver || !one.honest) return;
  ++deliveries_;
  Stream& stream = streams_[id];
  if (now_ > last_fault_) stream.again = std::min(stream.again, now_);
  const std::string what = "stream " + std::to_string(id) + ": " + std::to_string(origin.sequence);
  if (!stream.delivered.insert(origin.sequence).second) broken_ += what + " is delivered twice; ";
  if (stream.rule.depth == 1 && *stream.delivered.rbegin() != origin.sequence) {
    broken_ += what + " is out of order; ";
  }
}

void FaultyLink::acknowledge() {
  while (const auto acknowledgement = receiver_->take_acknowledgement(now_)) {
    if (chance(loss_) || !sender_runs()) continue;
    sender_->on_acknowledgement(station, acknowledgement->acknowledgement, now_);
  }
}

}  // namespace tocsin::router
