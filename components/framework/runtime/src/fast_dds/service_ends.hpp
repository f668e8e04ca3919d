// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fast_dds/raw_ends.hpp"
#include "rtps/service_wire.hpp"
#include "runtime/detail/services.hpp"

namespace tocsin {

/// Participants of the ends that one end is matched with. Thread-safe.
class MatchedParticipants {
 public:
  using Prefix = std::array<std::uint8_t, 12>;
  void count(const Gid& end, bool there);
  [[nodiscard]] bool has(const Prefix& participant) const;
  /// The ends that are there.
  [[nodiscard]] std::vector<Gid> ends() const;
  [[nodiscard]] static Prefix prefix_of(const Gid& gid);

 private:
  mutable std::mutex mutex_;
  std::map<Gid, int> ends_;
};

/// A server on DDS: requests of rmw_fastrtps and of rmw_cyclonedds alike, and each is answered as
/// it was asked. `ros_namespace` without slashes.
class DdsServer final : public ServerEnd {
 public:
  DdsServer(FastDdsParticipant& participant, const std::string& ros_namespace,
            const ServiceEndpoint& endpoint, ServerReceiver& receiver);
  void reply(const CallId& id, const std::shared_ptr<const void>& message) override;
  void flush() override;
  [[nodiscard]] Gid reader() const { return requests_.gid(); }
  [[nodiscard]] Gid writer() const { return replies_.gid(); }

 private:
  using Bytes = RawReader::Bytes;
  void take(const Bytes& bytes, const eprosima::fastdds::dds::SampleInfo& info);
  void send(const CallId& id, const Bytes& message);

  FastDdsParticipant& participant_;
  const ServiceEndpoint endpoint_;
  ServerReceiver& receiver_;
  MatchedParticipants clients_;
  std::deque<std::pair<CallId, Bytes>> waiting_;  ///< for a client that cannot hear yet
  RawWriter replies_;
  RawReader requests_;  // last: destroyed first, its listener uses the rest
};

/// A client on DDS, which asks as the server's maker does.
class DdsClient final : public ClientEnd {
 public:
  DdsClient(FastDdsParticipant& participant, const std::string& ros_namespace,
            const ServiceEndpoint& endpoint, ClientReceiver& receiver);
  [[nodiscard]] std::optional<std::int64_t> send(
      const std::shared_ptr<const void>& message) override;
  [[nodiscard]] bool available() const override { return server().has_value(); }
  [[nodiscard]] Gid reader() const { return replies_.gid(); }
  [[nodiscard]] Gid writer() const { return requests_.gid(); }

 private:
  using Bytes = RawReader::Bytes;
  [[nodiscard]] std::optional<Gid> server() const;
  [[nodiscard]] std::optional<std::int64_t> send_identified(const Bytes& message);
  [[nodiscard]] std::optional<std::int64_t> send_headed(const Bytes& message);
  void take(const Bytes& bytes, const eprosima::fastdds::dds::SampleInfo& info);
  void hand_over(const Bytes& bytes, std::int64_t number);

  FastDdsParticipant& participant_;
  const ServiceEndpoint endpoint_;
  ClientReceiver& receiver_;
  const std::uint64_t id_;  ///< in the header that Cyclone DDS reads
  std::int64_t last_headed_;
  MatchedParticipants request_readers_;
  MatchedParticipants reply_writers_;
  RawReader replies_;
  RawWriter requests_;
};

}  // namespace tocsin
