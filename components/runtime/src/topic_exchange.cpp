// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/topic_exchange.hpp"

#include <algorithm>

namespace tocsin {

void TopicExchange::attach(Receiver& receiver) {
  const std::lock_guard<std::mutex> lock(mutex_);
  receivers_.push_back(&receiver);
  if (last_.message) receiver.receive(last_);
}

void TopicExchange::detach(Receiver& receiver) {
  const std::lock_guard<std::mutex> lock(mutex_);
  receivers_.erase(std::remove(receivers_.begin(), receivers_.end(), &receiver), receivers_.end());
}

void TopicExchange::deliver(const Sample& sample) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (keeps_last_) last_ = sample;
  for (Receiver* receiver : receivers_) receiver->receive(sample);
}

}  // namespace tocsin
