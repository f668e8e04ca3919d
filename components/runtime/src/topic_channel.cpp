// SPDX-License-Identifier: Apache-2.0
#include "topic_channel.hpp"

#include <utility>

namespace tocsin {

TopicChannel::TopicChannel(ChannelOptions options, FastDdsParticipant& host,
                           FastDdsParticipant* link)
    : options_(std::move(options)),
      host_(host),
      link_(link),
      exchange_(options_.qos.keeps_last()) {}

void TopicChannel::attach(Receiver& receiver) {
  exchange_.attach(receiver);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (host_reader_) return;
  reads_ = true;
  const auto make_reader = [this](FastDdsParticipant& participant) {
    return std::make_unique<DdsReader>(participant, options_.dds_name, *options_.endpoint.type,
                                       options_.qos, exchange_);
  };
  host_reader_ = make_reader(host_);
  if (link_ != nullptr) link_reader_ = make_reader(*link_);
}

void TopicChannel::advertise(const TrafficRule& rule, bool open) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (host_writer_) return;
  const TypeInfo& type = *options_.endpoint.type;
  host_writer_ = std::make_unique<DdsWriter>(host_, options_.dds_name, type, options_.qos);
  if (link_ == nullptr) return;
  gated_ = std::make_unique<GatedWriter>(
      options_.endpoint.topic.name, type, rule,
      std::make_unique<DdsWriter>(*link_, options_.dds_name, type, options_.qos));
  gated_->set_open(open);
}

bool TopicChannel::has_readers_on_host() const {
  const int own = reads_ ? 1 : 0;
  return options_.qos.keeps_last() || host_writer_->matched_readers() > own;
}

Status TopicChannel::write(const Sample& sample) {
  exchange_.deliver(sample);
  const bool host_ok = !has_readers_on_host() || host_writer_->send(sample.message.get());
  const Status link = gated_ ? gated_->write(sample.message) : Status::ok;
  return host_ok ? link : Status::failed;
}

}  // namespace tocsin
