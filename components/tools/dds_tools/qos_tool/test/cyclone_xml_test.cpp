// SPDX-License-Identifier: Apache-2.0
// The file that is exported for Cyclone DDS, element by element as OMG DDS-XML 1.0
// (formal/18-10-01, section 7.3.2) has them: an element for each policy, called as in the IDL of
// DDS 1.4, with its members; enumerators by their IDL names; durations as sec and nanosec. Cyclone
// DDS 0.10.2, which Debian has, reads no such files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vendor_xml.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Without the blanks between elements.
std::string packed(const std::string& xml) {
  std::string text;
  for (std::size_t at = 0; at < xml.size(); ++at) {
    const bool between = xml[at] == '\n' || (xml[at] == ' ' && !text.empty() && text.back() == '>');
    if (!between) text += xml[at];
  }
  return text;
}

std::string duration(const char* name, const char* sec, const char* nanosec) {
  return std::string("<") + name + "><sec>" + sec + "</sec><nanosec>" + nanosec + "</nanosec></" +
         name + ">";
}

constexpr const char* forever = "DURATION_INFINITE_SEC";
constexpr const char* forever_ns = "DURATION_INFINITE_NSEC";

QosProfile every_policy() {
  QosProfile profile;
  profile.durability = Durability::transient_local;
  profile.deadline_s = 0.5;
  profile.liveliness = Liveliness::manual_by_participant;
  profile.liveliness_lease_s = 3;
  profile.ownership = Ownership::exclusive;
  profile.ownership_strength = 7;
  profile.partition = {"a", "b*"};
  profile.depth = 4;
  profile.lifespan_s = 2;
  profile.requested_reliability = RequestedReliability::best_effort;
  return profile;
}

/// What both ends say of `every_policy`.
std::string of_both() {
  return "<durability><kind>TRANSIENT_LOCAL_DURABILITY_QOS</kind></durability>"
         "<deadline>" +
         duration("period", "0", "500000000") +
         "</deadline>"
         "<liveliness><kind>MANUAL_BY_PARTICIPANT_LIVELINESS_QOS</kind>" +
         duration("lease_duration", "3", "0") +
         "</liveliness>"
         "<ownership><kind>EXCLUSIVE_OWNERSHIP_QOS</kind></ownership>"
         "<history><kind>KEEP_LAST_HISTORY_QOS</kind><depth>4</depth></history>"
         "<resource_limits><max_samples>5</max_samples><max_instances>1</max_instances>"
         "<max_samples_per_instance>5</max_samples_per_instance></resource_limits>";
}

std::string reliability(const char* kind) {
  return std::string("<reliability><kind>") + kind + "_RELIABILITY_QOS</kind>" +
         duration("max_blocking_time", "0", "100000000") + "</reliability>";
}

constexpr const char* partition =
    "<partition><name><element>a</element><element>b*</element>"
    "</name></partition>";

TEST(CycloneXml, HasEveryPolicyInItsElement) {
  const Exported exported = export_xml(Vendor::cyclone, {{"p", every_policy()}});
  EXPECT_THAT(exported.lost, IsEmpty());
  const std::string xml = packed(exported.xml);
  EXPECT_THAT(xml, HasSubstr("<dds xmlns=\"http://www.omg.org/spec/DDS-XML\">"
                             "<qos_library name=\"tocsin\"><qos_profile name=\"p\">"));
  EXPECT_THAT(xml,
              HasSubstr("<datawriter_qos><lifespan>" + duration("duration", "2", "0") +
                        "</lifespan><ownership_strength><value>7</value></ownership_strength>" +
                        reliability("RELIABLE") + of_both() + "</datawriter_qos>"));
  EXPECT_THAT(xml, HasSubstr(reliability("BEST_EFFORT") + of_both() + "</datareader_qos>"));
  EXPECT_THAT(xml, HasSubstr(std::string("<publisher_qos>") + partition + "</publisher_qos>"));
  EXPECT_THAT(xml, HasSubstr(std::string("<subscriber_qos>") + partition + "</subscriber_qos>"));
}

TEST(CycloneXml, WhatIsForEverIsSaidByName) {
  const std::string xml = packed(export_xml(Vendor::cyclone, {{"p", {}}}).xml);
  EXPECT_THAT(xml, HasSubstr("<deadline>" + duration("period", forever, forever_ns)));
  EXPECT_THAT(xml, HasSubstr("<lifespan>" + duration("duration", forever, forever_ns)));
  EXPECT_THAT(xml, ::testing::Not(HasSubstr("partition")));
}

}  // namespace
}  // namespace tocsin::qos_tool
