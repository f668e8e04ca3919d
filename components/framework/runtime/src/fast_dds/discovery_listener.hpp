// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include "fast_dds/remote_ends.hpp"

namespace tocsin {

/// Notes what discovery tells of other participants. Only notes: Fast DDS holds its locks then.
class DiscoveryListener : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  explicit DiscoveryListener(RemoteEnds& ends) : ends_(ends) {}
  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;

 private:
  RemoteEnds& ends_;
};

}  // namespace tocsin
