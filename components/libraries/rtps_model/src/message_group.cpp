// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/message_group.hpp"

namespace tocsin::rtps {

bool ByteBudget::is_exceeded_by(std::size_t bytes) const {
  if (limit == 0) return false;
  return limit <= sent + pending || bytes > limit - sent - pending;
}

MessageGroup::MessageGroup(Sender& sender, ByteBudget* budget)
    : sender_(sender), budget_(budget), length_(wire::message_header) {}

void MessageGroup::set_length(std::size_t length) {
  length_ = length;
  if (budget_ != nullptr) budget_->pending = length;
}

void MessageGroup::address(const std::vector<EndId>& receivers) {
  if (receivers == receivers_) return;
  flush();
  receivers_ = receivers;
}

bool MessageGroup::add_data(const SamplePtr& sample, Fragment fragment) {
  if (budget_ != nullptr && budget_->is_exceeded_by(sample->bytes_of(fragment))) return false;
  add(Data{sample, fragment});
  return true;
}

void MessageGroup::add(const Submessage& submessage) {
  const std::size_t size = size_of(submessage);
  if (message_ && length_ + size + wire::statistics > wire::longest_message) flush();
  if (!message_) {
    message_ = std::make_shared<Message>();
    set_length(length_ + (receivers_.size() == 1 ? wire::info_destination : 0));
  }
  message_->parts.push_back(submessage);
  set_length(length_ + size);
}

void MessageGroup::flush() {
  if (!message_) return;
  const std::size_t whole = length_ + wire::statistics;
  message_->ip_bytes = wire::ip_and_udp + whole;
  if (budget_ != nullptr) budget_->sent += whole;
  const MessagePtr message = std::move(message_);
  message_ = nullptr;
  set_length(wire::message_header);
  for (const EndId receiver : receivers_) sender_.send(receiver, message);
}

}  // namespace tocsin::rtps
