// SPDX-License-Identifier: Apache-2.0
// Sources: Fast DDS 2.9.1, XMLElementParser.cpp; OMG DDS-XML 1.0 (formal/18-10-01), section 7.3.2.
#include "dialect.hpp"

#include <map>

namespace tocsin::qos_tool {
namespace {

using Places = std::vector<Place>;

Places joined_places(Places one, const Places& more) {
  one.insert(one.end(), more.begin(), more.end());
  return one;
}

/// What both ends of Fast DDS say in the same place.
Places fast_dds_of_both() {
  return {
      {"max_blocking_time_s", "qos/reliability/max_blocking_time", Form::seconds},
      {"deadline_s", "qos/deadline/period", Form::seconds},
      {"liveliness", "qos/liveliness/kind", Form::word},
      {"liveliness_lease_s", "qos/liveliness/lease_duration", Form::seconds},
      {"liveliness_announcement_s", "qos/liveliness/announcement_period", Form::seconds},
      {"ownership", "qos/ownership/kind", Form::word},
      {"partition", "qos/partition/names", Form::names, "name"},
      {"user_data", "qos/userData", Form::hex},
      {"history", "topic/historyQos/kind", Form::word},
      {"depth", "topic/historyQos/depth", Form::number},
      {"max_samples", "topic/resourceLimitsQos/max_samples", Form::number},
      {"", "topic/resourceLimitsQos/max_instances", Form::number, "", "1"},
      {"max_samples", "topic/resourceLimitsQos/max_samples_per_instance", Form::number},
      {"allocated_samples", "topic/resourceLimitsQos/allocated_samples", Form::number},
      {"extra_samples", "topic/resourceLimitsQos/extra_samples", Form::number},
      {"memory_policy", "historyMemoryPolicy", Form::word},
      {"", "qos/data_sharing/kind", Form::word, "", "off"},
  };
}

Places fast_dds_writer(Vendor vendor) {
  const auto time = [vendor](const char* two, const char* three) {
    return std::string("times/") + (vendor == Vendor::fast_dds ? two : three);
  };
  return joined_places(
      {{"reliability", "qos/reliability/kind", Form::word},
       {"durability", "qos/durability/kind", Form::word},
       {"lifespan_s", "qos/lifespan/duration", Form::seconds},
       {"publish_mode", "qos/publishMode/kind", Form::word},
       {"ownership_strength", "qos/ownershipStrength/value", Form::number},
       {"heartbeat_piggyback", "qos/disable_heartbeat_piggyback", Form::not_flag},
       {"initial_heartbeat_delay_s", time("initialHeartbeatDelay", "initial_heartbeat_delay"),
        Form::seconds},
       {"heartbeat_period_s", time("heartbeatPeriod", "heartbeat_period"), Form::seconds},
       {"nack_response_delay_s", time("nackResponseDelay", "nack_response_delay"), Form::seconds},
       {"nack_suppression_s", time("nackSupressionDuration", "nack_supression_duration"),
        Form::seconds}},
      fast_dds_of_both());
}

Places fast_dds_reader(Vendor vendor) {
  const bool two = vendor == Vendor::fast_dds;
  return joined_places(
      {{"reliability", "qos/reliability/kind", Form::word},
       {"durability", "qos/durability/kind", Form::word},
       {"", "qos/lifespan/duration", Form::seconds, "", ".inf"},
       {"initial_acknack_delay_s",
        two ? "times/initialAcknackDelay" : "times/initial_acknack_delay", Form::seconds},
       {"heartbeat_response_delay_s",
        two ? "times/heartbeatResponseDelay" : "times/heartbeat_response_delay", Form::seconds}},
      fast_dds_of_both());
}

/// What both ends of DDS-XML say in places of the same name.
Places dds_xml_of_both(const std::string& end, const std::string& holder) {
  const std::string limits = end + "/resource_limits/";
  return {
      {"reliability", end + "/reliability/kind", Form::word, "_RELIABILITY_QOS"},
      {"max_blocking_time_s", end + "/reliability/max_blocking_time", Form::seconds},
      {"durability", end + "/durability/kind", Form::word, "_DURABILITY_QOS"},
      {"deadline_s", end + "/deadline/period", Form::seconds},
      {"liveliness", end + "/liveliness/kind", Form::word, "_LIVELINESS_QOS"},
      {"liveliness_lease_s", end + "/liveliness/lease_duration", Form::seconds},
      {"ownership", end + "/ownership/kind", Form::word, "_OWNERSHIP_QOS"},
      {"partition", holder + "/partition/name", Form::names, "element"},
      {"history", end + "/history/kind", Form::word, "_HISTORY_QOS"},
      {"depth", end + "/history/depth", Form::number},
      {"max_samples", limits + "max_samples", Form::number},
      {"", limits + "max_instances", Form::number, "", "1"},
      {"max_samples", limits + "max_samples_per_instance", Form::number},
  };
}

Places cyclone_writer() {
  return joined_places(
      {{"lifespan_s", "datawriter_qos/lifespan/duration", Form::seconds},
       {"ownership_strength", "datawriter_qos/ownership_strength/value", Form::number}},
      dds_xml_of_both("datawriter_qos", "publisher_qos"));
}

Places cyclone_reader() {
  return joined_places({{"minimum_separation_s",
                         "datareader_qos/time_based_filter/minimum_separation", Form::seconds}},
                       dds_xml_of_both("datareader_qos", "subscriber_qos"));
}

constexpr const char* of_runtime = "the runtime does it, neither DDS nor Fast DDS knows it";
constexpr const char* of_fast_dds = "DDS knows no such policy; Cyclone DDS decides by itself";

const std::map<std::string, const char*>& lost_to_fast_dds() {
  static const std::map<std::string, const char*> lost{
      {"max_rate_hz", of_runtime},
      {"minimum_separation_s", "Fast DDS announces a time-based filter and delivers everything"}};
  return lost;
}

const std::map<std::string, const char*>& lost_to_cyclone() {
  static const std::map<std::string, const char*> lost{
      {"allocated_samples", of_fast_dds},
      {"extra_samples", of_fast_dds},
      {"memory_policy", of_fast_dds},
      {"initial_heartbeat_delay_s", of_fast_dds},
      {"heartbeat_period_s", of_fast_dds},
      {"nack_response_delay_s", of_fast_dds},
      {"nack_suppression_s", of_fast_dds},
      {"heartbeat_piggyback", of_fast_dds},
      {"initial_acknack_delay_s", of_fast_dds},
      {"heartbeat_response_delay_s", of_fast_dds},
      {"liveliness_announcement_s", of_fast_dds},
      {"publish_mode", of_fast_dds},
      {"max_rate_hz", of_runtime},
      {"user_data", "it belongs to our readers and writers"}};
  return lost;
}

}  // namespace

const std::vector<Place>& places(Vendor vendor, bool writer) {
  static const Places of_fast_writer = fast_dds_writer(Vendor::fast_dds);
  static const Places of_fast_reader = fast_dds_reader(Vendor::fast_dds);
  static const Places of_fast_3_writer = fast_dds_writer(Vendor::fast_dds_3);
  static const Places of_fast_3_reader = fast_dds_reader(Vendor::fast_dds_3);
  static const Places of_cyclone_writer = cyclone_writer();
  static const Places of_cyclone_reader = cyclone_reader();
  if (vendor == Vendor::fast_dds) return writer ? of_fast_writer : of_fast_reader;
  if (vendor == Vendor::fast_dds_3) return writer ? of_fast_3_writer : of_fast_3_reader;
  return writer ? of_cyclone_writer : of_cyclone_reader;
}

std::string why_lost(Vendor vendor, const std::string& policy) {
  const auto& lost = vendor == Vendor::cyclone ? lost_to_cyclone() : lost_to_fast_dds();
  const auto found = lost.find(policy);
  return found != lost.end() ? found->second : "";
}

}  // namespace tocsin::qos_tool
