// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fast_dds/dds_endpoints.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/qos_change.hpp"

namespace tocsin {

/// What a channel needs of its bus.
struct ChannelOptions {
  Endpoint endpoint;
  std::string dds_name;
  QosProfile qos;
};

/// One topic in this process. A sample written here goes two ways: by pointer to the readers of
/// this process, and by the participant to other processes of this host, its link_router among
/// them.
class TopicChannel {
 public:
  /// Throws ConfigError when the topic crosses the link and its writers have owners.
  TopicChannel(ChannelOptions options, FastDdsParticipant& participant);

  [[nodiscard]] const TypeInfo* type() const { return options_.endpoint.type; }

  /// The first receiver makes the readers, the last one that goes removes them. Returns the gid of
  /// the DDS reader, which stays until then.
  Gid attach(Receiver& receiver, Time now);
  void detach(Receiver& receiver);
  /// The first publication makes the writer, the last one that goes removes it. `user_data`: what
  /// it announces. Throws ConfigError when the others of this process announce something else.
  /// Returns the gid of the DDS writer, which stays until the last one goes.
  Gid advertise(std::uint64_t source, const std::string& user_data);
  void withdraw(std::uint64_t source, Time now);
  /// The writer of samples that come here, see Subscription::writer.
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const;
  /// `head` lacks the message and its number, the next after `delivered`.
  Status write(const std::shared_ptr<const void>& message, Sample&& head, std::uint64_t& delivered);
  /// Ends an instance for the readers of this process and of others.
  Status end_instance(const std::shared_ptr<const void>& message, Sample&& head);
  /// Whether a sample that is written now gets anywhere, or is kept or counted for others.
  [[nodiscard]] bool has_readers() const {
    return has_deadline_ || exchange_.has_receivers() || has_remote_readers();
  }
  /// Whether somebody reads now.
  [[nodiscard]] bool is_read() const {
    return exchange_.has_receivers() || writer_->matched_readers() > 0;
  }
  /// Changes the ends of this process, see Bus::change_qos.
  int change_qos(const QosChange& change, Time now);
  /// Both DDS endpoints of this topic.
  [[nodiscard]] std::vector<EndpointHealth> health(Time now) const;

 private:
  [[nodiscard]] bool has_remote_readers() const;
  [[nodiscard]] bool too_soon(Time now);
  [[nodiscard]] EndpointHealth writer_health(const DdsWriter& writer, Time now) const;
  [[nodiscard]] EndpointHealth reader_health(const DdsReader& reader,
                                             const TopicExchange::Account& account) const;

  void offer(const QosProfile& qos, Time now);

  const ChannelOptions options_;
  const bool exclusive_;
  const bool always_sent_;  // whoever reads
  FastDdsParticipant& participant_;
  TopicExchange exchange_;
  mutable std::mutex mutex_;  // guards the making and removing of endpoints
  std::size_t receivers_ = 0;
  std::set<std::uint64_t> publications_;  // of this process
  QosProfile offered_;                    // by its writers
  QosProfile requested_;                  // by its readers
  std::atomic<bool> has_deadline_{false};
  std::atomic<bool> is_watched_{false};  // there is a rate or a deadline
  mutable std::mutex written_mutex_;
  std::optional<RateLimit> rate_;
  std::optional<DeadlineWatch> deadline_;
  std::unique_ptr<DdsWriter> writer_;
  std::unique_ptr<DdsReader> reader_;  // last: destroyed first
};

}  // namespace tocsin
