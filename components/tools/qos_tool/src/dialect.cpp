// SPDX-License-Identifier: Apache-2.0
// Sources: Fast DDS 2.9.1, XMLElementParser.cpp and the QoS classes' defaults; OMG DDS-XML 1.0
// (formal/18-10-01), section 7.3.2, and DDS 1.4, section 2.2.3, for its defaults.
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
      {"max_blocking_time_s", "qos/reliability/max_blocking_time", Form::seconds, "", "0.1"},
      {"deadline_s", "qos/deadline/period", Form::seconds, "", ".inf"},
      {"liveliness", "qos/liveliness/kind", Form::word, "", "automatic"},
      {"liveliness_lease_s", "qos/liveliness/lease_duration", Form::seconds, "", ".inf"},
      {"liveliness_announcement_s", "qos/liveliness/announcement_period", Form::seconds, "",
       ".inf"},
      {"ownership", "qos/ownership/kind", Form::word, "", "shared"},
      {"partition", "qos/partition/names", Form::names, "name", "[]"},
      {"user_data", "qos/userData", Form::hex, "", ""},
      {"history", "topic/historyQos/kind", Form::word, "", "keep_last"},
      {"depth", "topic/historyQos/depth", Form::number, "", "1"},
      {"max_samples", "topic/resourceLimitsQos/max_samples", Form::number, "", "5000"},
      {"", "topic/resourceLimitsQos/max_instances", Form::number, "", "1"},
      {"max_samples", "topic/resourceLimitsQos/max_samples_per_instance", Form::number, "", "400"},
      {"allocated_samples", "topic/resourceLimitsQos/allocated_samples", Form::number, "", "100"},
      {"extra_samples", "topic/resourceLimitsQos/extra_samples", Form::number, "", "1"},
      {"memory_policy", "historyMemoryPolicy", Form::word, "", "preallocated_with_realloc"},
      {"", "qos/data_sharing/kind", Form::word, "", "off"},
  };
}

Places fast_dds_writer() {
  return joined_places(
      {{"reliability", "qos/reliability/kind", Form::word, "", "reliable"},
       {"durability", "qos/durability/kind", Form::word, "", "transient_local"},
       {"lifespan_s", "qos/lifespan/duration", Form::seconds, "", ".inf"},
       {"publish_mode", "qos/publishMode/kind", Form::word, "", "synchronous"},
       {"ownership_strength", "qos/ownershipStrength/value", Form::number, "", "0"},
       {"heartbeat_piggyback", "qos/disable_heartbeat_piggyback", Form::not_flag, "", "true"},
       {"initial_heartbeat_delay_s", "times/initialHeartbeatDelay", Form::seconds, "", "0.012"},
       {"heartbeat_period_s", "times/heartbeatPeriod", Form::seconds, "", "3"},
       {"nack_response_delay_s", "times/nackResponseDelay", Form::seconds, "", "0.005"},
       {"nack_suppression_s", "times/nackSupressionDuration", Form::seconds, "", "0"}},
      fast_dds_of_both());
}

Places fast_dds_reader() {
  return joined_places(
      {{"reliability", "qos/reliability/kind", Form::word, "", "best_effort"},
       {"durability", "qos/durability/kind", Form::word, "", "volatile"},
       {"", "qos/lifespan/duration", Form::seconds, "", ".inf"},
       {"initial_acknack_delay_s", "times/initialAcknackDelay", Form::seconds, "", "0.07"},
       {"heartbeat_response_delay_s", "times/heartbeatResponseDelay", Form::seconds, "", "0.005"}},
      fast_dds_of_both());
}

/// What both ends of DDS-XML say in places of the same name.
Places dds_xml_of_both(const std::string& end, const std::string& holder, const char* reliability) {
  const std::string limits = end + "/resource_limits/";
  return {
      {"reliability", end + "/reliability/kind", Form::word, "_RELIABILITY_QOS", reliability},
      {"max_blocking_time_s", end + "/reliability/max_blocking_time", Form::seconds, "", "0.1"},
      {"durability", end + "/durability/kind", Form::word, "_DURABILITY_QOS", "volatile"},
      {"deadline_s", end + "/deadline/period", Form::seconds, "", ".inf"},
      {"liveliness", end + "/liveliness/kind", Form::word, "_LIVELINESS_QOS", "automatic"},
      {"liveliness_lease_s", end + "/liveliness/lease_duration", Form::seconds, "", ".inf"},
      {"ownership", end + "/ownership/kind", Form::word, "_OWNERSHIP_QOS", "shared"},
      {"partition", holder + "/partition/name", Form::names, "element", "[]"},
      {"history", end + "/history/kind", Form::word, "_HISTORY_QOS", "keep_last"},
      {"depth", end + "/history/depth", Form::number, "", "1"},
      {"max_samples", limits + "max_samples", Form::number, "", "0"},
      {"", limits + "max_instances", Form::number, "", "1"},
      {"max_samples", limits + "max_samples_per_instance", Form::number, "", "0"},
  };
}

Places cyclone_writer() {
  return joined_places(
      {{"lifespan_s", "datawriter_qos/lifespan/duration", Form::seconds, "", ".inf"},
       {"ownership_strength", "datawriter_qos/ownership_strength/value", Form::number, "", "0"}},
      dds_xml_of_both("datawriter_qos", "publisher_qos", "reliable"));
}

Places cyclone_reader() {
  return joined_places(
      {{"minimum_separation_s", "datareader_qos/time_based_filter/minimum_separation",
        Form::seconds, "", "0"}},
      dds_xml_of_both("datareader_qos", "subscriber_qos", "best_effort"));
}

constexpr const char* of_runtime = "the runtime does it, neither DDS nor Fast DDS knows it";
constexpr const char* of_fast_dds = "DDS knows no such policy; Cyclone DDS decides by itself";

const std::map<std::string, const char*>& lost_to_fast_dds() {
  constexpr const char* no_flow = "Fast DDS 2.9.1 has flow controllers in C++ only, not in XML";
  static const std::map<std::string, const char*> lost{
      {"flow_controller", no_flow},
      {"priority", no_flow},
      {"bandwidth_reservation_percent", no_flow},
      {"max_rate_hz", of_runtime},
      {"minimum_separation_s",
       "Fast DDS 2.9.1 announces a time-based filter and delivers everything"}};
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
      {"flow_controller", "Cyclone DDS has no flow controllers"},
      {"priority", "Cyclone DDS has no flow controllers"},
      {"bandwidth_reservation_percent", "Cyclone DDS has no flow controllers"},
      {"max_rate_hz", of_runtime},
      {"user_data", "it belongs to our readers and writers"}};
  return lost;
}

}  // namespace

const std::vector<Place>& places(Vendor vendor, bool writer) {
  static const Places of_fast_writer = fast_dds_writer();
  static const Places of_fast_reader = fast_dds_reader();
  static const Places of_cyclone_writer = cyclone_writer();
  static const Places of_cyclone_reader = cyclone_reader();
  if (vendor == Vendor::fast_dds) return writer ? of_fast_writer : of_fast_reader;
  return writer ? of_cyclone_writer : of_cyclone_reader;
}

std::string why_lost(Vendor vendor, const std::string& policy) {
  const auto& lost = vendor == Vendor::fast_dds ? lost_to_fast_dds() : lost_to_cyclone();
  const auto found = lost.find(policy);
  return found != lost.end() ? found->second : "";
}

}  // namespace tocsin::qos_tool
