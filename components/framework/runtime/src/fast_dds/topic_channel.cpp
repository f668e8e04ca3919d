// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/topic_channel.hpp"

#include <cmath>
#include <utility>

#include "fast_dds/layout_digest.hpp"
#include "foundation/error.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {
namespace {

ChannelOptions with_digest(ChannelOptions options) {
  std::string& user_data = options.qos.user_data;
  user_data = with_layout(user_data, layout_digest(*options.endpoint.type));
  return options;
}

}  // namespace

TopicChannel::TopicChannel(ChannelOptions options, FastDdsParticipant& participant)
    : options_(with_digest(std::move(options))),
      requested_(requested(options_.endpoint.topic, options_.qos)),
      exclusive_(options_.qos.exclusive()),
      always_sent_(exclusive_ || options_.qos.keeps_last()),
      participant_(participant),
      exchange_(options_.qos),
      offered_(options_.qos) {
  refuse_owners_on_link(options_.endpoint.topic, options_.qos);
  if (std::isfinite(options_.qos.max_rate_hz)) rate_.emplace(seconds(1 / options_.qos.max_rate_hz));
  if (std::isfinite(options_.qos.deadline_s)) deadline_.emplace(seconds(options_.qos.deadline_s));
}

void TopicChannel::attach(Receiver& receiver, Time now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!reader_) {
      reader_ = std::make_unique<DdsReader>(participant_, options_.dds_name,
                                            *options_.endpoint.type, requested_, exchange_);
    }
    ++receivers_;
  }
  exchange_.attach(receiver, now);
}

void TopicChannel::detach(Receiver& receiver) {
  exchange_.detach(receiver);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (--receivers_ == 0) reader_.reset();
}

void TopicChannel::advertise(std::uint64_t source, const std::string& announced) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string user_data = joined(options_.qos.user_data, announced);
  if (publications_.empty()) offered_.user_data = user_data;
  if (offered_.user_data != user_data) {
    throw ConfigError(std::string("topic ") + options_.endpoint.topic.name +
                      ": two writers of one process announce '" + offered_.user_data + "' and '" +
                      user_data + "'; let them run in two");
  }
  if (!writer_) {
    writer_ = std::make_unique<DdsWriter>(participant_, options_.dds_name, *options_.endpoint.type,
                                          offered_);
  }
  publications_.insert(source);
}

std::optional<WriterInfo> TopicChannel::writer(std::uint64_t source) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (publications_.count(source) != 0) return WriterInfo{"this process", offered_.user_data};
  return reader_ ? reader_->writer(source) : std::nullopt;
}

void TopicChannel::withdraw(std::uint64_t source) {
  exchange_.forget(source);
  const std::lock_guard<std::mutex> lock(mutex_);
  publications_.erase(source);
  if (publications_.empty()) writer_.reset();
}

bool TopicChannel::has_remote_readers() const {
  return always_sent_ || writer_->matched_readers() > 0;
}

bool TopicChannel::too_soon(Time now) {
  if (!rate_ && !deadline_) return false;
  const std::lock_guard<std::mutex> lock(written_mutex_);
  if (rate_ && !rate_->pass(now)) return true;
  if (deadline_) deadline_->on_sample(now);
  return false;
}

Status TopicChannel::write(const std::shared_ptr<const void>& message, Sample&& head,
                           std::uint64_t& delivered) {
  if (too_soon(head.received)) return Status::ok;  // the profile asks for no more
  if (!exclusive_) {
    head.message = message;
    exchange_.deliver(std::move(head), delivered);
  }
  return !has_remote_readers() || writer_->send(message.get()) ? Status::ok : Status::failed;
}

EndpointHealth TopicChannel::writer_health(const DdsWriter& writer, Time now) const {
  EndpointHealth health = writer.health();
  health.topic = options_.endpoint.topic.name;
  const std::lock_guard<std::mutex> lock(written_mutex_);
  if (rate_) health.thinned = rate_->dropped();
  if (deadline_) health.deadlines_missed = deadline_->missed(now);
  if (deadline_) health.last = deadline_->last();
  return health;
}

EndpointHealth TopicChannel::reader_health(const DdsReader& reader,
                                           const TopicExchange::Account& account) const {
  EndpointHealth health = reader.health();
  health.topic = options_.endpoint.topic.name;
  health.samples = account.samples;
  health.thinned = account.thinned;
  health.deadlines_missed = account.deadlines_missed;
  health.last = account.last;
  return health;
}

std::vector<EndpointHealth> TopicChannel::health(Time now) const {
  std::vector<EndpointHealth> all;
  const TopicExchange::Account account = exchange_.account(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (writer_) all.push_back(writer_health(*writer_, now));
  if (reader_) all.push_back(reader_health(*reader_, account));
  return all;
}

}  // namespace tocsin
