// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "dds_endpoints.hpp"

namespace tocsin {

/// What a channel needs of its bus.
struct ChannelOptions {
  Endpoint endpoint;
  std::string dds_name;
  QosProfile qos;
};

/// One topic in this process. A sample written here goes three ways: by pointer to the readers of
/// this process, by the host participant to other processes of this host, and for link topics by
/// the gate and the link participant to the other side. The domains differ, so nobody gets a
/// sample twice, and the gate never keeps anything from readers on this host.
class TopicChannel {
 public:
  /// `link` is null when the process has no radio link or the topic stays on the host.
  TopicChannel(ChannelOptions options, FastDdsParticipant& host, FastDdsParticipant* link);

  [[nodiscard]] const TypeInfo* type() const { return options_.endpoint.type; }
  /// The gate of this topic, null when it has none.
  [[nodiscard]] GatedWriter* gated_writer() { return gated_.get(); }

  void attach(Receiver& receiver);
  void detach(Receiver& receiver) { exchange_.detach(receiver); }
  /// Makes the writers, once. `rule` and `open` are those of the gate.
  void advertise(const TrafficRule& rule, bool open);
  Status write(const Sample& sample);

 private:
  [[nodiscard]] bool has_readers_on_host() const;

  const ChannelOptions options_;
  FastDdsParticipant& host_;
  FastDdsParticipant* const link_;
  TopicExchange exchange_;
  std::mutex mutex_;  // guards the creation of endpoints
  std::unique_ptr<DdsWriter> host_writer_;
  std::unique_ptr<GatedWriter> gated_;
  std::unique_ptr<DdsReader> host_reader_;  // readers last: destroyed first
  std::unique_ptr<DdsReader> link_reader_;
  std::atomic<bool> reads_{false};
};

}  // namespace tocsin
