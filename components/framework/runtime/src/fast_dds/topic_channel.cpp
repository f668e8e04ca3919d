// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/topic_channel.hpp"

#include <cmath>
#include <utility>

#include "fast_dds/instance_key.hpp"
#include "fast_dds/layout_digest.hpp"
#include "foundation/error.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/qos_change.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {
namespace {

ChannelOptions with_digest(ChannelOptions options) {
  std::string& user_data = options.qos.user_data;
  const TypeInfo& type = *options.endpoint.type;
  user_data = with_type_hash(with_layout(user_data, layout_digest(type)), type.ros_hash);
  return options;
}

/// A router carries bytes, and knows no instances.
void refuse_keys_on_link(const Endpoint& endpoint) {
  if (endpoint.topic.scope != Scope::link || endpoint.type->longest_key == 0) return;
  throw ConfigError(std::string("topic ") + endpoint.topic.name +
                    ": crosses the link; types with a key are for host topics");
}

}  // namespace

TopicChannel::TopicChannel(ChannelOptions options, FastDdsParticipant& participant)
    : options_(with_digest(std::move(options))),
      exclusive_(options_.qos.exclusive()),
      always_sent_(exclusive_ || options_.qos.keeps_last()),
      participant_(participant),
      exchange_(options_.qos),
      offered_(options_.qos),
      requested_(requested(options_.endpoint.topic, options_.qos)) {
  refuse_owners_on_link(options_.endpoint.topic, options_.qos);
  refuse_keys_on_link(options_.endpoint);
  offer(offered_, Time{});
}

void TopicChannel::offer(const QosProfile& qos, Time now) {
  const std::lock_guard<std::mutex> lock(written_mutex_);
  if (std::isinf(qos.max_rate_hz)) {
    rate_.reset();
  } else if (rate_) {
    rate_->change(seconds(1 / qos.max_rate_hz));
  } else {
    rate_.emplace(seconds(1 / qos.max_rate_hz));
  }
  if (std::isinf(qos.deadline_s)) {
    deadline_.reset();
  } else if (deadline_) {
    deadline_->change(seconds(qos.deadline_s), now);
  } else {
    deadline_.emplace(seconds(qos.deadline_s));
  }
  has_deadline_ = deadline_.has_value();
  is_watched_ = rate_ || deadline_;
}

int TopicChannel::change_qos(const QosChange& change, Time now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const QosProfile offered = changed(offered_, change.settings);
  const QosProfile requested = changed(requested_, change.settings);
  int ends = 0;
  bool taken = true;
  if (change.writers) {
    offered_ = offered;
    offer(offered, now);
    if (writer_) taken = writer_->change(offered);
    ends += writer_ ? 1 : 0;
  }
  if (change.readers) {
    requested_ = requested;
    exchange_.change(requested, now);
    if (reader_) taken = reader_->change(requested) && taken;
    ends += reader_ ? 1 : 0;
  }
  if (!taken) throw ConfigError("Fast DDS refused it: " + change.settings);
  return ends;
}

Gid TopicChannel::attach(Receiver& receiver, Time now) {
  Gid gid;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!reader_) {
      reader_ = std::make_unique<DdsReader>(participant_, options_.dds_name,
                                            *options_.endpoint.type, requested_, exchange_);
    }
    ++receivers_;
    gid = reader_->gid();
  }
  exchange_.attach(receiver, now);
  return gid;
}

void TopicChannel::detach(Receiver& receiver) {
  exchange_.detach(receiver);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (--receivers_ == 0) reader_.reset();
}

Gid TopicChannel::advertise(std::uint64_t source, const std::string& announced) {
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
  return writer_->gid();
}

std::optional<WriterInfo> TopicChannel::writer(std::uint64_t source) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (publications_.count(source) != 0) {
    return WriterInfo{"this process", offered_.user_data, offered_.lifespan_s};
  }
  return reader_ ? reader_->writer(source) : std::nullopt;
}

void TopicChannel::withdraw(std::uint64_t source, Time now) {
  exchange_.forget(source, now);
  const std::lock_guard<std::mutex> lock(mutex_);
  publications_.erase(source);
  if (publications_.empty()) writer_.reset();
}

bool TopicChannel::has_remote_readers() const {
  return always_sent_ || writer_->matched_readers() > 0;
}

bool TopicChannel::too_soon(Time now) {
  if (!is_watched_) return false;
  const std::lock_guard<std::mutex> lock(written_mutex_);
  if (rate_ && !rate_->pass(now)) return true;
  if (deadline_) deadline_->on_sample(now);
  return false;
}

Status TopicChannel::write(const std::shared_ptr<const void>& message, Sample&& head,
                           std::uint64_t& delivered) {
  if (too_soon(head.received)) return Status::ok;  // the profile asks for no more
  if (!exclusive_) {
    head.instance = instance_of(*options_.endpoint.type, message.get());
    head.message = message;
    exchange_.deliver(std::move(head), delivered);
  }
  return !has_remote_readers() || writer_->send(message.get()) ? Status::ok : Status::failed;
}

Status TopicChannel::end_instance(const std::shared_ptr<const void>& message, Sample&& head) {
  head.instance = instance_of(*options_.endpoint.type, message.get());
  if (head.instance == 0) return Status::failed;
  if (!exclusive_) exchange_.end_instance(head);
  return writer_->end_instance(message.get(), head.state) || !has_remote_readers() ? Status::ok
                                                                                   : Status::failed;
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
