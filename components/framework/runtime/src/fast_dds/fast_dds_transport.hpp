// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <map>
#include <string>
#include <vector>

#include "fast_dds/deferred_reception.hpp"
#include "fast_dds/remote_ends.hpp"
#include "link/radio_transport.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {

/// Where a participant lives and whom it looks for. Discovery is UDP and unicast: nothing is
/// multicast, and traffic stays on the interface of `address`.
struct ParticipantOptions {
  std::string name;
  int domain = 0;
  std::string address;             ///< IPv4 of the only interface that is used
  std::vector<std::string> peers;  ///< IPv4 addresses that are asked for participants
  int peer_participants = 4;       ///< [1, 100] participant ids that are asked at each of them
  bool radio = false;              ///< small RTPS messages, asynchronous writers, patient lease
  bool shared_memory = false;      ///< samples go by shared memory where the peer has it, too
  std::map<std::string, FlowController> flow_controllers = {};
  /// Called by discovery with what others announce; must not call Fast DDS.
  RemoteEnds::OnEnd on_end = {};
  RemoteEnds::OnParticipant on_participant = {};
  std::shared_ptr<RadioMarks> marks = {};  ///< of the packets of a radio; null: none
  /// Released when the participant is complete.
  std::shared_ptr<DeferredReception> reception = std::make_shared<DeferredReception>();
};

/// `options` must outlive the participant: Fast DDS keeps pointers to the names.
[[nodiscard]] eprosima::fastdds::dds::DomainParticipantQos participant_qos(
    const ParticipantOptions& options);

}  // namespace tocsin
