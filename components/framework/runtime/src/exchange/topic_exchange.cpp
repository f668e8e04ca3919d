// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/topic_exchange.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace tocsin {
namespace {

QosProfile keeping_last(bool keeps_last) {
  QosProfile qos;
  if (keeps_last) qos.durability = Durability::transient_local;
  return qos;
}

}  // namespace

TopicExchange::TopicExchange(const QosProfile& qos)
    : kept_per_writer_(qos.keeps_last()
                           ? static_cast<std::size_t>(qos.keeps_all() ? qos.room() : qos.depth)
                           : 0),
      lifespan_(seconds(qos.lifespan_s)),
      separation_(seconds(qos.minimum_separation_s)),
      deadline_(seconds(qos.deadline_s)) {}

TopicExchange::TopicExchange(bool keeps_last) : TopicExchange(keeping_last(keeps_last)) {}

bool TopicExchange::expired(const Sample& sample, Time now) const {
  return now > sample.received && now - sample.received > lifespan_;
}

void TopicExchange::attach(Receiver& receiver, Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  receivers_.push_back(&receiver);
  has_receivers_.store(true, std::memory_order_relaxed);
  for (const auto& writer : kept_) {
    for (const Sample& sample : writer.second) {
      if (!expired(sample, now)) receiver.receive(sample);
    }
  }
}

void TopicExchange::detach(Receiver& receiver) {
  const std::lock_guard<std::mutex> lock(mutex_);
  receivers_.erase(std::remove(receivers_.begin(), receivers_.end(), &receiver), receivers_.end());
  has_receivers_.store(!receivers_.empty(), std::memory_order_relaxed);
}

void TopicExchange::deliver(Sample&& sample) {
  const std::lock_guard<std::mutex> lock(mutex_);
  hand_over(std::move(sample));
}

void TopicExchange::deliver(Sample&& sample, std::uint64_t& sequence) {
  const std::lock_guard<std::mutex> lock(mutex_);
  sample.sequence = ++sequence;
  hand_over(std::move(sample));
}

void TopicExchange::hand_over(Sample&& sample) {
  deadline_.on_sample(sample.received);
  if (!separation_.pass(sample.source, sample.received, sample.instance)) return;
  if (sample.instance != 0) instances_.on_sample(sample.source, sample.instance);
  ++samples_;
  if (kept_per_writer_ > 0) keep(sample);
  if (receivers_.empty()) return;
  for (auto one = receivers_.begin(); one + 1 != receivers_.end(); ++one) (*one)->receive(sample);
  receivers_.back()->receive_last(std::move(sample));
}

void TopicExchange::keep(const Sample& sample) {
  std::deque<Sample>& kept = kept_[{sample.source, sample.instance}];
  if (kept.size() == kept_per_writer_) kept.pop_front();
  kept.push_back(sample);
}

void TopicExchange::change(const QosProfile& qos, Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  lifespan_ = seconds(qos.lifespan_s);
  separation_.change(seconds(qos.minimum_separation_s));
  deadline_.change(seconds(qos.deadline_s), now);
}

void TopicExchange::tell_end(const Sample& sample) {
  for (Receiver* const receiver : receivers_) receiver->instance_ended(sample);
}

void TopicExchange::end_instance(const Sample& sample) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sample.state == InstanceState::disposed) {
    for (auto it = kept_.begin(); it != kept_.end();) {
      it = it->first.second == sample.instance ? kept_.erase(it) : std::next(it);
    }
    if (instances_.on_disposed(sample.instance)) tell_end(sample);
    return;
  }
  kept_.erase({sample.source, sample.instance});
  if (instances_.on_unregistered(sample.source, sample.instance)) tell_end(sample);
}

void TopicExchange::forget(std::uint64_t source, Time now) {
  constexpr std::uint64_t last_instance = std::numeric_limits<std::uint64_t>::max();
  const std::lock_guard<std::mutex> lock(mutex_);
  kept_.erase(kept_.lower_bound({source, 0}), kept_.upper_bound({source, last_instance}));
  separation_.forget(source);
  for (const std::uint64_t instance : instances_.on_writer_gone(source)) {
    Sample end;
    end.received = now;
    end.source = source;
    end.instance = instance;
    end.state = InstanceState::no_writers;
    tell_end(end);
  }
}

TopicExchange::Account TopicExchange::account(Time now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {samples_, separation_.dropped(), deadline_.missed(now), deadline_.last()};
}

}  // namespace tocsin
