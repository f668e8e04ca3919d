// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "runtime/fast_dds/names.hpp"

#if TOCSIN_FAST_DDS >= 3
#include <fastdds/LibrarySettings.hpp>
#else
#include <fastrtps/xmlparser/XMLProfileManager.h>
#endif

namespace tocsin::fast_dds {

namespace dds = eprosima::fastdds::dds;

/// Packets, not calls, between the participants of this process. Before the first of them.
inline void deliver_by_packets() {
#if TOCSIN_FAST_DDS >= 3
  eprosima::fastdds::LibrarySettings settings;
  settings.intraprocess_delivery = eprosima::fastdds::INTRAPROCESS_OFF;
  (void)dds::DomainParticipantFactory::get_instance()->set_library_settings(settings);
#else
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
#endif
}

/// Times of a reliable writer.
struct WriterTimes {
  dds::Duration_t initial_heartbeat_delay;
  dds::Duration_t heartbeat_period;
  dds::Duration_t nack_response_delay;
  dds::Duration_t nack_suppression;
};

inline void set_times(const WriterTimes& wanted, dds::DataWriterQos& qos) {
  auto& times = qos.reliable_writer_qos().times;
#if TOCSIN_FAST_DDS >= 3
  times.initial_heartbeat_delay = wanted.initial_heartbeat_delay;
  times.heartbeat_period = wanted.heartbeat_period;
  times.nack_response_delay = wanted.nack_response_delay;
  times.nack_supression_duration = wanted.nack_suppression;
#else
  times.initialHeartbeatDelay = wanted.initial_heartbeat_delay;
  times.heartbeatPeriod = wanted.heartbeat_period;
  times.nackResponseDelay = wanted.nack_response_delay;
  times.nackSupressionDuration = wanted.nack_suppression;
#endif
}

/// Times of a reliable reader.
struct ReaderTimes {
  dds::Duration_t initial_acknack_delay;
  dds::Duration_t heartbeat_response_delay;
};

inline void set_times(const ReaderTimes& wanted, dds::DataReaderQos& qos) {
  auto& times = qos.reliable_reader_qos().times;
#if TOCSIN_FAST_DDS >= 3
  times.initial_acknack_delay = wanted.initial_acknack_delay;
  times.heartbeat_response_delay = wanted.heartbeat_response_delay;
#else
  times.initialAcknackDelay = wanted.initial_acknack_delay;
  times.heartbeatResponseDelay = wanted.heartbeat_response_delay;
#endif
}

}  // namespace tocsin::fast_dds
