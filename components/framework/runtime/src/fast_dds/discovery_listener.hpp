// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "fast_dds/remote_ends.hpp"
#include "runtime/fast_dds/discovery.hpp"
#include "runtime/logger.hpp"

namespace tocsin {

class PacketFilter;

/// Whether a participant is known as soon as it speaks, or when DDS Security has found that it is
/// who it says.
enum class Acquaintance { at_once, when_authenticated };

/// Notes what discovery tells of other participants. Only notes: Fast DDS holds its locks then.
class DiscoveryListener : public fast_dds::DiscoveryEvents {
 public:
  using Prefix = eprosima::fastdds::rtps::GuidPrefix_t;
  /// `filter`: learns who is authenticated.
  DiscoveryListener(RemoteEnds& ends, Acquaintance acquaintance,
                    std::shared_ptr<PacketFilter> filter)
      : ends_(ends), acquaintance_(acquaintance), filter_(std::move(filter)) {}
  void on_participant(const fast_dds::DiscoveredParticipant& participant,
                      fast_dds::Presence presence) override;
  void on_authentication(const Prefix& participant, bool authorized) override;
  void on_end(const fast_dds::DiscoveredEnd& end, bool writer,
              fast_dds::Presence presence) override;

 private:
  RemoteEnds& ends_;
  const Acquaintance acquaintance_;
  const std::shared_ptr<PacketFilter> filter_;
  Logger log_{"link"};
  std::mutex mutex_;
  std::map<Prefix, std::string> strangers_;  ///< by name, until they are authenticated
  std::set<Prefix> authenticated_;
};

}  // namespace tocsin
