// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/authentication_repeats.hpp"

#include <algorithm>
#include <utility>

#include "fast_dds_v2/message_pieces.hpp"
#include "runtime/middleware/rtps_message.hpp"

namespace tocsin {
namespace {

/// Whose numbers are remembered: more than a link has peers.
constexpr std::size_t most_remembered = 64;

}  // namespace

void AuthenticationRepeats::sent(const Participant& addressee, Due message, Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  messages_.remove_if([&](const Message& one) { return one.addressee == addressee; });
  if (messages_.size() >= most_messages) messages_.pop_front();
  messages_.push_back({addressee, std::move(message), RepeatTimes(now)});
}

void AuthenticationRepeats::on_packet(const std::uint8_t* bytes, std::size_t size) {
  const auto number = piece_number(bytes, size);
  if (!number) return;
  Participant sender;
  std::copy_n(bytes + header_bytes - Participant::size, Participant::size, sender.value);
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto [last, is_first] = last_.try_emplace(sender, *number);
  if (!is_first && last->second == *number) return;
  last->second = *number;
  messages_.remove_if([&](const Message& one) { return one.addressee == sender; });
  if (last_.size() > most_remembered) last_.erase(last_.begin());
}

std::optional<AuthenticationRepeats::Due> AuthenticationRepeats::take_due(Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto due = std::find_if(messages_.begin(), messages_.end(),
                                [&](const Message& one) { return now >= one.times.next(); });
  if (due == messages_.end()) return std::nullopt;
  Due content = due->content;
  if (!due->times.repeat(now)) messages_.erase(due);
  return content;
}

Time AuthenticationRepeats::deadline() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  Time next = never;
  for (const Message& one : messages_) next = std::min(next, one.times.next());
  return next;
}

}  // namespace tocsin
