// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fast_dds/remote_ends.hpp"
#include "fast_dds_v2/deferred_reception.hpp"
#include "foundation/time.hpp"
#include "rtps/writer_numbers.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "transport/radio_marks.hpp"
#include "transport/stop_channel.hpp"

namespace tocsin {

class PacketFilter;

/// Where a participant lives and whom it looks for: on its host (see host_side), or on the
/// link, if it has peers. There discovery is unicast, and traffic stays on the interface
/// of `address`.
struct ParticipantOptions {
  std::string name;
  int domain = 0;
  std::string address = "127.0.0.1";    ///< on the link: IPv4 of the only interface that is used
  std::vector<std::string> peers = {};  ///< on the link: IPv4 addresses; none: on the host
  std::string second_address = {};      ///< on the link, of a second path; empty: none
  std::vector<std::string> second_peers = {};  ///< the peers by it, in the same order
  std::string user_data = "";                  ///< of the participant
  /// How long its writers wait, in all, until their readers have what they wrote last.
  Duration farewell = {};
  /// Called by discovery with what others announce; must not call Fast DDS.
  RemoteEnds::OnEnd on_end = {};
  RemoteEnds::OnParticipant on_participant = {};
  std::shared_ptr<RadioMarks> marks = {};  ///< of a router's packets; null: as large as UDP carries
  std::shared_ptr<StopChannel> stop = {};  ///< on the link: the emergency stop's way; null: none
  std::shared_ptr<WriterNumbers> numbers = {};  ///< sees what is received; null: nobody does
  std::string enclave = {};                     ///< folder of its identity; empty: no DDS Security
  /// Of its packets; null: participant_qos makes one.
  std::shared_ptr<PacketFilter> filter = {};
  /// Released when the participant is complete.
  std::shared_ptr<DeferredReception> reception = std::make_shared<DeferredReception>();
};

/// The filter of the packets of such a participant.
[[nodiscard]] std::shared_ptr<PacketFilter> packet_filter(const ParticipantOptions& options);

/// `options` must outlive the participant: Fast DDS keeps pointers to the names.
[[nodiscard]] eprosima::fastdds::dds::DomainParticipantQos participant_qos(
    const ParticipantOptions& options);

}  // namespace tocsin
