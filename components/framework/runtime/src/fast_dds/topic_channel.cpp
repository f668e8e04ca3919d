// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/topic_channel.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "fast_dds/layout_digest.hpp"
#include "foundation/error.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {
namespace {

GatedWriter::Freshness freshness(const QosProfile& qos) {
  if (!std::isfinite(qos.lifespan_s)) return {};
  return {[] { return Time(std::chrono::steady_clock::now()); }, seconds(qos.lifespan_s)};
}

ChannelOptions with_digest(ChannelOptions options) {
  std::string& user_data = options.qos.user_data;
  user_data = with_layout(user_data, layout_digest(*options.endpoint.type));
  return options;
}

}  // namespace

TopicChannel::TopicChannel(ChannelOptions options, FastDdsParticipant& host,
                           FastDdsParticipant* link)
    : options_(with_digest(std::move(options))),
      requested_(requested(options_.endpoint.topic, options_.qos)),
      exclusive_(options_.qos.exclusive()),
      always_sent_(exclusive_ || options_.qos.keeps_last()),
      host_(host),
      link_(link),
      exchange_(options_.qos),
      offered_(options_.qos) {
  refuse_owners_on_link(options_.endpoint.topic, options_.qos);
  if (std::isfinite(options_.qos.max_rate_hz)) rate_.emplace(seconds(1 / options_.qos.max_rate_hz));
  if (std::isfinite(options_.qos.deadline_s)) deadline_.emplace(seconds(options_.qos.deadline_s));
}

std::unique_ptr<DdsReader> TopicChannel::make_reader(FastDdsParticipant& participant) {
  return std::make_unique<DdsReader>(participant, options_.dds_name, *options_.endpoint.type,
                                     requested_, exchange_);
}

std::unique_ptr<DdsWriter> TopicChannel::make_writer(FastDdsParticipant& participant) const {
  return std::make_unique<DdsWriter>(participant, options_.dds_name, *options_.endpoint.type,
                                     offered_);
}

/// Null while the link is not up.
std::unique_ptr<DdsWriter> TopicChannel::make_link_writer() {
  if (link_ == nullptr) return nullptr;
  auto writer = make_writer(*link_);
  link_writer_ = writer.get();
  return writer;
}

void TopicChannel::join(FastDdsParticipant& link) {
  if (!options_.crosses) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  link_ = &link;
  if (host_reader_) link_reader_ = make_reader(link);
  if (gated_) gated_->connect(make_link_writer());
}

void TopicChannel::attach(Receiver& receiver, Time now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!host_reader_) host_reader_ = make_reader(host_);
    if (!link_reader_ && link_ != nullptr) link_reader_ = make_reader(*link_);
    ++receivers_;
  }
  exchange_.attach(receiver, now);
}

void TopicChannel::detach(Receiver& receiver) {
  exchange_.detach(receiver);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (--receivers_ > 0) return;
  link_reader_.reset();
  host_reader_.reset();
}

void TopicChannel::advertise(const Wish& wish) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string user_data = joined(options_.qos.user_data, wish.user_data);
  if (publications_.empty()) offered_.user_data = user_data;
  if (offered_.user_data != user_data) {
    throw ConfigError(std::string("topic ") + options_.endpoint.topic.name +
                      ": two writers of one process announce '" + offered_.user_data + "' and '" +
                      user_data + "'; let them run in two");
  }
  if (!host_writer_) host_writer_ = make_writer(host_);
  if (!gated_ && options_.crosses) {
    gated_ = std::make_unique<GatedWriter>(options_.endpoint.topic.name, wish.rule,
                                           make_link_writer(), freshness(options_.qos));
    gated_->set_open(wish.open);
  }
  publications_.insert(wish.source);
}

std::optional<WriterInfo> TopicChannel::writer(std::uint64_t source) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (publications_.count(source) != 0) return WriterInfo{"this process", offered_.user_data};
  for (const auto* reader : {host_reader_.get(), link_reader_.get()}) {
    if (reader == nullptr) continue;
    if (auto found = reader->writer(source)) return found;
  }
  return std::nullopt;
}

void TopicChannel::withdraw(std::uint64_t source) {
  exchange_.forget(source);
  const std::lock_guard<std::mutex> lock(mutex_);
  publications_.erase(source);
  if (!publications_.empty()) return;
  link_writer_ = nullptr;
  gated_.reset();
  host_writer_.reset();
}

bool TopicChannel::has_readers_on_host() const {
  return always_sent_ || host_writer_->matched_readers() > 0;
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
  const bool host_ok = !has_readers_on_host() || host_writer_->send(message.get());
  const Status link = gated_ ? gated_->write(message) : Status::ok;
  return host_ok ? link : Status::failed;
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

EndpointHealth TopicChannel::waiting(bool writer) const {
  EndpointHealth health;
  health.topic = options_.endpoint.topic.name;
  health.writer = writer;
  health.link = health.waits = true;
  return health;
}

std::vector<EndpointHealth> TopicChannel::health(Time now) const {
  std::vector<EndpointHealth> all;
  const TopicExchange::Account account = exchange_.account(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (host_writer_) all.push_back(writer_health(*host_writer_, now));
  if (link_writer_ != nullptr) all.push_back(writer_health(*link_writer_, now));
  if (host_reader_) all.push_back(reader_health(*host_reader_, account));
  if (link_reader_) all.push_back(reader_health(*link_reader_, account));
  if (options_.crosses && link_ == nullptr) {
    if (host_writer_) all.push_back(waiting(true));
    if (host_reader_) all.push_back(waiting(false));
  }
  return all;
}

}  // namespace tocsin
