// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "fast_dds/remote_ends.hpp"
#include "runtime/logger.hpp"

namespace tocsin {

class PacketFilter;

/// Whether a participant is known as soon as it speaks, or when DDS Security has found that it is
/// who it says.
enum class Acquaintance { at_once, when_authenticated };

/// Notes what discovery tells of other participants. Only notes: Fast DDS holds its locks then.
class DiscoveryListener : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  /// `filter`: learns who is authenticated.
  DiscoveryListener(RemoteEnds& ends, Acquaintance acquaintance,
                    std::shared_ptr<PacketFilter> filter)
      : ends_(ends), acquaintance_(acquaintance), filter_(std::move(filter)) {}
  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  void onParticipantAuthentication(
      eprosima::fastdds::dds::DomainParticipant* participant,
      eprosima::fastrtps::rtps::ParticipantAuthenticationInfo&& info) override;

 private:
  using Prefix = eprosima::fastrtps::rtps::GuidPrefix_t;
  RemoteEnds& ends_;
  const Acquaintance acquaintance_;
  const std::shared_ptr<PacketFilter> filter_;
  Logger log_{"link"};
  std::mutex mutex_;
  std::map<Prefix, std::string> strangers_;  ///< by name, until they are authenticated
};

}  // namespace tocsin
