// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/fast_dds_qos.hpp"
#include "runtime/fast_dds/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

dds::LivelinessQosPolicyKind liveliness_kind(const QosProfile& profile) {
  if (profile.liveliness == Liveliness::manual_by_topic) return dds::MANUAL_BY_TOPIC_LIVELINESS_QOS;
  return profile.liveliness == Liveliness::automatic ? dds::AUTOMATIC_LIVELINESS_QOS
                                                     : dds::MANUAL_BY_PARTICIPANT_LIVELINESS_QOS;
}

rtps::MemoryManagementPolicy_t memory_policy(const QosProfile& profile) {
  if (profile.memory_policy == MemoryPolicy::dynamic) return rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  return profile.memory_policy == MemoryPolicy::dynamic_reusable
             ? rtps::DYNAMIC_REUSABLE_MEMORY_MODE
             : rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

template <class Qos>
void apply_history(const QosProfile& profile, Keys keys, Qos& qos) {
  constexpr int unlimited = 0;
  qos.history().kind = profile.keeps_all() ? dds::KEEP_ALL_HISTORY_QOS : dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = profile.depth;
  qos.resource_limits().max_samples = keys == Keys::some ? unlimited : profile.room();
  qos.resource_limits().max_instances = keys == Keys::some ? unlimited : 1;
  qos.resource_limits().max_samples_per_instance = profile.room();
  qos.resource_limits().allocated_samples = profile.allocated_samples;
  qos.resource_limits().extra_samples = profile.extra_samples;
  qos.endpoint().history_memory_policy = memory_policy(profile);
  qos.lifespan().duration = dds_duration(profile.lifespan_s);
}

template <class Qos>
void apply_contract(const QosProfile& profile, Qos& qos) {
  qos.reliability().kind =
      profile.reliable() ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = dds_duration(profile.max_blocking_time_s);
  qos.durability().kind =
      profile.keeps_last() ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.deadline().period = dds_duration(profile.deadline_s);
  qos.liveliness().kind = liveliness_kind(profile);
  qos.liveliness().lease_duration = dds_duration(profile.liveliness_lease_s);
  const double announcement_s = std::isfinite(profile.liveliness_announcement_s)
                                    ? profile.liveliness_announcement_s
                                    : profile.liveliness_lease_s / 3;
  qos.liveliness().announcement_period = dds_duration(announcement_s);
  qos.ownership().kind =
      profile.exclusive() ? dds::EXCLUSIVE_OWNERSHIP_QOS : dds::SHARED_OWNERSHIP_QOS;
  qos.data_sharing().off();
  qos.user_data().data_vec({profile.user_data.begin(), profile.user_data.end()});
}

}  // namespace

eprosima::fastdds::dds::Duration_t dds_duration(double s) {
  constexpr std::int64_t ns_in_s = 1'000'000'000;
  if (s >= static_cast<double>(std::numeric_limits<std::int32_t>::max())) {
    return dds::c_TimeInfinite;
  }
  const std::int64_t ns = std::llround(s * static_cast<double>(ns_in_s));
  return {static_cast<std::int32_t>(ns / ns_in_s), static_cast<std::uint32_t>(ns % ns_in_s)};
}

dds::DataWriterQos writer_qos(const QosProfile& profile, Keys keys) {
  dds::DataWriterQos qos;
  apply_contract(profile, qos);
  apply_history(profile, keys, qos);
  // Who does not write an instance any more says only that.
  qos.writer_data_lifecycle().autodispose_unregistered_instances = keys == Keys::none;
  qos.publish_mode().kind = profile.publish_mode == PublishMode::asynchronous
                                ? dds::ASYNCHRONOUS_PUBLISH_MODE
                                : dds::SYNCHRONOUS_PUBLISH_MODE;
  fast_dds::set_times(fast_dds::WriterTimes{dds_duration(profile.initial_heartbeat_delay_s),
                                            dds_duration(profile.heartbeat_period_s),
                                            dds_duration(profile.nack_response_delay_s),
                                            dds_duration(profile.nack_suppression_s)},
                      qos);
  qos.reliable_writer_qos().disable_heartbeat_piggyback = !profile.heartbeat_piggyback;
  qos.ownership_strength().value = static_cast<std::uint32_t>(profile.ownership_strength);
  return qos;
}

dds::DataReaderQos reader_qos(const QosProfile& profile, Keys keys) {
  // An answer to each sample costs a round trip of 1 MiB a fifth; on a host little is lost.
  constexpr double least_response_delay_s = 0.005;
  dds::DataReaderQos qos;
  apply_contract(profile, qos);
  apply_history(profile, keys, qos);
  // With its dynamic policies a reader of Fast DDS 2.9.1 has no memory for what has no payload, and
  // asks for the end of an instance again and again.
  if (keys == Keys::some) {
    qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  }
  // The writer lets go of what is too old. A reader of Fast DDS would compare the writer's wall
  // clock with its own, and drop every sample of a host whose clock is behind by the lifespan.
  qos.lifespan().duration = dds::c_TimeInfinite;
  fast_dds::set_times(
      fast_dds::ReaderTimes{
          dds_duration(profile.initial_acknack_delay_s),
          dds_duration(std::max(profile.heartbeat_response_delay_s, least_response_delay_s))},
      qos);
  return qos;
}

}  // namespace tocsin
