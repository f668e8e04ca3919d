// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fast_dds/dds_endpoints.hpp"

namespace tocsin {

/// What a channel needs of its bus.
struct ChannelOptions {
  Endpoint endpoint;
  std::string dds_name;
  QosProfile qos;
  bool crosses = false;  ///< the link, now or once it is up
};

/// One topic in this process. A sample written here goes three ways: by pointer to the readers of
/// this process, by the host participant to other processes of this host, and for link topics by
/// the gate and the link participant to the other side. The domains differ, so nobody gets a
/// sample twice, and the gate never keeps anything from readers on this host.
class TopicChannel {
 public:
  /// `link` is null when the topic does not cross, or the link is not up yet. Throws ConfigError
  /// when the topic crosses and its writers have owners.
  TopicChannel(ChannelOptions options, FastDdsParticipant& host, FastDdsParticipant* link);

  [[nodiscard]] const TypeInfo* type() const { return options_.endpoint.type; }
  /// The gate of this topic, null when it has none.
  [[nodiscard]] GatedWriter* gated_writer() { return gated_.get(); }

  /// The first receiver makes the readers, the last one that goes removes them.
  void attach(Receiver& receiver, Time now);
  void detach(Receiver& receiver);
  /// What a publication asks for: rule and state of the gate, and what its writers announce.
  struct Wish {
    std::uint64_t source;
    TrafficRule rule;
    bool open;
    std::string user_data;
  };
  /// The first publication makes the writers, the last one that goes removes them. Throws
  /// ConfigError when the others of this process announce something else.
  void advertise(const Wish& wish);
  void withdraw(std::uint64_t source);
  /// The writer of samples that come here, see Subscription::writer.
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const;
  /// The link is up: from now on the topic crosses it, if it is one that does.
  void join(FastDdsParticipant& link);
  /// `head` lacks the message and its number, the next after `delivered`.
  Status write(const std::shared_ptr<const void>& message, Sample&& head, std::uint64_t& delivered);
  /// Whether a sample that is written now gets anywhere, or is kept or counted for others.
  [[nodiscard]] bool has_readers() const {
    return gated_ || deadline_ || exchange_.has_receivers() || has_readers_on_host();
  }
  /// Every DDS endpoint of this topic.
  [[nodiscard]] std::vector<EndpointHealth> health(Time now) const;

 private:
  [[nodiscard]] std::unique_ptr<DdsReader> make_reader(FastDdsParticipant& participant);
  [[nodiscard]] std::unique_ptr<DdsWriter> make_writer(FastDdsParticipant& participant) const;
  [[nodiscard]] std::unique_ptr<DdsWriter> make_link_writer();
  [[nodiscard]] bool has_readers_on_host() const;
  [[nodiscard]] bool too_soon(Time now);
  [[nodiscard]] EndpointHealth waiting(bool writer) const;
  [[nodiscard]] EndpointHealth writer_health(const DdsWriter& writer, Time now) const;
  [[nodiscard]] EndpointHealth reader_health(const DdsReader& reader,
                                             const TopicExchange::Account& account) const;

  const ChannelOptions options_;
  const QosProfile requested_;  // by its readers
  const bool exclusive_;
  const bool always_sent_;  // to the host, whoever reads
  FastDdsParticipant& host_;
  FastDdsParticipant* link_;
  TopicExchange exchange_;
  mutable std::mutex mutex_;  // guards the making and removing of endpoints
  std::size_t receivers_ = 0;
  std::set<std::uint64_t> publications_;  // of this process
  QosProfile offered_;                    // by its writers
  mutable std::mutex written_mutex_;
  std::optional<RateLimit> rate_;
  std::optional<DeadlineWatch> deadline_;
  std::unique_ptr<DdsWriter> host_writer_;
  std::unique_ptr<GatedWriter> gated_;
  DdsWriter* link_writer_ = nullptr;        // owned by gated_
  std::unique_ptr<DdsReader> host_reader_;  // readers last: destroyed first
  std::unique_ptr<DdsReader> link_reader_;
};

}  // namespace tocsin
