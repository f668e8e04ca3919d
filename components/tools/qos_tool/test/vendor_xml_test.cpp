// SPDX-License-Identifier: Apache-2.0
// There and back, and what is said to be lost. Fast DDS's own reading: fast_dds_xml_test.
#include "vendor_xml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "foundation/error.hpp"
#include "policy_values.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Profiles = std::map<std::string, QosProfile>;

/// The values that a vendor's file keeps; what it loses has its default.
Values kept(Vendor vendor, QosProfile profile) {
  Values values = value_map(effective(std::move(profile)));
  const Values defaults = value_map(effective({}));
  for (auto& [policy, value] : values) {
    if (!why_lost(vendor, policy).empty()) value = defaults.at(policy);
  }
  if (values["heartbeat_response_delay_s"] == "0") values["heartbeat_response_delay_s"] = "0.005";
  if (vendor == Vendor::cyclone) {
    for (const char* own :
         {"heartbeat_response_delay_s", "publish_mode", "liveliness_announcement_s"}) {
      values[own] = value_map({}).at(own);
    }
  }
  return values;
}

QosProfile there_and_back(Vendor vendor, const QosProfile& profile) {
  return import_xml(export_xml(vendor, {{"p", profile}}).xml, "test").profiles.at("p");
}

/// A valid profile with drawn values.
QosProfile drawn(std::minstd_rand& random) {
  const auto one_of = [&random](std::initializer_list<const char*> words) {
    return std::string(*(words.begin() + random() % words.size()));
  };
  Values values{{"reliability", one_of({"reliable", "best_effort"})},
                {"deadline_s", one_of({".inf", "0.25", "3"})},
                {"liveliness", one_of({"automatic", "manual_by_participant", "manual_by_topic"})},
                {"liveliness_lease_s", one_of({".inf", "1.5", "20"})},
                {"ownership", one_of({"shared", "exclusive"})},
                {"partition", one_of({"[]", "[a]", "[a, 'b*']"})},
                {"history", one_of({"keep_last", "keep_all"})},
                {"depth", one_of({"1", "17"})},
                {"lifespan_s", one_of({".inf", "0.3", "12"})},
                {"max_samples", one_of({"0", "200"})},
                {"heartbeat_period_s", one_of({"0.1", "3"})},
                {"heartbeat_piggyback", one_of({"true", "false"})},
                {"memory_policy", one_of({"dynamic", "dynamic_reusable"})},
                {"publish_mode", one_of({"automatic", "asynchronous"})}};
  if (values["reliability"] == "reliable") {
    values["durability"] = one_of({"volatile", "transient_local"});
    values["requested_reliability"] = one_of({"offered", "best_effort"});
  }
  if (values["ownership"] == "exclusive") values["ownership_strength"] = one_of({"0", "9"});
  return profile_of(values, "drawn");
}

TEST(VendorXml, DrawnProfilesComeBackFromBothFormats) {
  std::minstd_rand random(7);
  for (int i = 0; i < 300; ++i) {
    const QosProfile profile = drawn(random);
    for (const Vendor vendor : {Vendor::fast_dds, Vendor::cyclone}) {
      EXPECT_EQ(value_map(there_and_back(vendor, profile)), kept(vendor, profile))
          << export_xml(vendor, {{"p", profile}}).xml;
    }
  }
}

TEST(VendorXml, WhatWasExportedIsImportedWithoutLoss) {
  const QosProfiles shipped(TOCSIN_REPOSITORY "/config/qos.yaml");
  for (const Vendor vendor : {Vendor::fast_dds, Vendor::cyclone}) {
    const Exported exported = export_xml(vendor, shipped.all());
    const Imported back = import_xml(exported.xml, "test");
    EXPECT_EQ(back.vendor, vendor);
    EXPECT_THAT(back.lost, IsEmpty());
    EXPECT_EQ(back.profiles.size(), shipped.all().size());
  }
  EXPECT_THAT(export_xml(Vendor::fast_dds, shipped.all()).lost, IsEmpty());
}

TEST(VendorXml, AnExportSaysWhatTheFormatCannotSay) {
  QosProfile profile;
  profile.flow_controller = "radio";
  profile.minimum_separation_s = 0.5;
  profile.heartbeat_period_s = 1;
  profile.partition = {"", "a"};
  EXPECT_THAT(export_xml(Vendor::fast_dds, {{"p", profile}}).lost,
              ElementsAre(HasSubstr("p.flow_controller: radio is lost: Fast DDS 2.9.1 has flow"),
                          HasSubstr("p.minimum_separation_s: 0.5 is lost"),
                          HasSubstr("the partition without name is lost")));
  EXPECT_THAT(export_xml(Vendor::cyclone, {{"p", profile}}).lost,
              ElementsAre(HasSubstr("p.heartbeat_period_s: 1 is lost"),
                          HasSubstr("p.flow_controller: radio is lost")));
  EXPECT_EQ(there_and_back(Vendor::cyclone, profile).minimum_separation_s, 0.5);
}

/// Every policy has a place in a vendor's file or a reason why not.
TEST(VendorXml, NoPolicyIsForgotten) {
  for (const Vendor vendor : {Vendor::fast_dds, Vendor::cyclone}) {
    std::set<std::string> placed{"requested_reliability"};  // the reader's reliability
    for (const bool writer : {true, false}) {
      for (const Place& place : places(vendor, writer)) placed.insert(place.policy);
    }
    for (const PolicyValue& one : values_of({})) {
      EXPECT_NE(placed.count(one.policy) != 0, !why_lost(vendor, one.policy).empty()) << one.policy;
    }
  }
}

TEST(VendorXml, AbsentElementsAreTheVendorsDefaultsNotOurs) {
  const auto writer = import_xml(
      "<dds><profiles><data_writer profile_name='w'/>"
      "<data_reader profile_name='r'/></profiles></dds>",
      "test");
  EXPECT_THAT(writer.lost, IsEmpty());
  EXPECT_EQ(writer.profiles.at("w").durability, Durability::transient_local);
  EXPECT_EQ(writer.profiles.at("w").heartbeat_period_s, 3);
  EXPECT_EQ(writer.profiles.at("w").max_samples, 5000);
  EXPECT_EQ(writer.profiles.at("r").reliability, Reliability::best_effort);
  const auto cyclone = import_xml(
      "<dds><qos_library name='l'><qos_profile name='q'>"
      "<datawriter_qos/></qos_profile></qos_library></dds>",
      "test");
  EXPECT_EQ(cyclone.profiles.at("q").durability, Durability::volatile_kind);
  EXPECT_EQ(cyclone.profiles.at("q").reliability, Reliability::reliable);
}

TEST(VendorXml, AnImportSaysWhatItDoesNotTakeWithTheLine) {
  const auto read = import_xml(
      "<profiles>\n<data_writer profile_name='w'>\n<qos>\n<latencyBudget>\n<duration>\n"
      "<sec>1</sec></duration></latencyBudget>\n<durability><kind>TRANSIENT</kind></durability>\n"
      "<reliability><kind>SOME</kind>\n<max_blocking_time><sec>x</sec></max_blocking_time>"
      "</reliability></qos>\n<topic><resourceLimitsQos><max_instances>10</max_instances>"
      "</resourceLimitsQos></topic></data_writer>\n<participant profile_name='p'/></profiles>",
      "test");
  EXPECT_THAT(read.lost, AllOf(Contains(HasSubstr("w: <sec> in <duration> (line 6): no policy")),
                               Contains(HasSubstr("max_blocking_time (line 9): its value is not")),
                               Contains(HasSubstr("'some' is not one of: reliable, best_effort")),
                               Contains(HasSubstr("'transient' is not one of: volatile")),
                               Contains(HasSubstr("max_instances 10 (line 10): is always 1 here")),
                               Contains(HasSubstr("<participant> p (line 11)"))));
}

/// Fast DDS's writers are transient local where nothing is said, best effort or not.
TEST(VendorXml, PoliciesThatContradictEachOtherHereHaveTheirDefaultsAndAreSaid) {
  const auto read = import_xml(
      "<profiles><data_writer profile_name='w'><qos><reliability><kind>BEST_EFFORT</kind>"
      "</reliability></qos><topic><historyQos><depth>0</depth></historyQos></topic></data_writer>"
      "</profiles>",
      "t");
  EXPECT_EQ(read.profiles.at("w").durability, Durability::volatile_kind);
  EXPECT_EQ(read.profiles.at("w").depth, 1);
  EXPECT_THAT(read.lost,
              ElementsAre(HasSubstr("depth: 0 is outside [1, 10000]"),
                          HasSubstr("w: durability transient_local: transient_local needs")));
}

TEST(VendorXml, AnImportRefusesWhatIsNoFileOfEither) {
  const auto refused = [](const std::string& text) -> std::string {
    try {
      (void)import_xml(text, "f.xml");
      return "";
    } catch (const ConfigError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refused("no xml"), HasSubstr("f.xml: is no XML"));
  EXPECT_THAT(refused(""), HasSubstr("f.xml: is no XML"));
  EXPECT_THAT(refused("<html/>"), HasSubstr("<html> is neither"));
  EXPECT_THAT(refused("<profiles><data_writer>"), HasSubstr("f.xml: is no XML (line 1)"));
}

TEST(VendorXml, ReadersThatRequestOtherThanWritersOfferAreSaid) {
  const auto read = import_xml(
      "<profiles><data_writer profile_name='w'/><data_reader profile_name='w'/></profiles>", "t");
  EXPECT_EQ(read.profiles.at("w").requested_reliability, RequestedReliability::best_effort);
  EXPECT_THAT(read.lost, ElementsAre("w: its readers have durability volatile; ours have what "
                                     "writers have, transient_local"));
}

TEST(VendorXml, QosFilesOfImportsAreReadByTheRuntime) {
  QosProfile profile;
  profile.partition = {"a, b", ""};
  profile.deadline_s = 0.5;
  EXPECT_EQ(qos_file({{"p", profile}}), "p: {deadline_s: 0.5, partition: [\"a, b\", \"\"]}\n");
}

TEST(VendorXml, TellsWhatParticipantsOfAFileDoOnTheNetwork) {
  const auto wire = [](const std::string& text) { return import_xml(text, "t").wires.at(0); };
  EXPECT_EQ(wire("<dds><profiles/></dds>").message_bytes, 65'500);
  EXPECT_TRUE(wire("<dds><profiles/></dds>").multicast);
  const Wire careful = wire(
      "<dds><profiles><transport_descriptors><transport_descriptor><transport_id>u</transport_id>"
      "<maxMessageSize>1400</maxMessageSize></transport_descriptor></transport_descriptors>"
      "<participant profile_name='p'><rtps><builtin><discovery_config><leaseDuration><sec>60</sec>"
      "</leaseDuration></discovery_config><initialPeersList/></builtin><userTransports>"
      "<transport_id>u</transport_id></userTransports><useBuiltinTransports>false"
      "</useBuiltinTransports></rtps></participant></profiles></dds>");
  EXPECT_EQ(careful.whose, "participant p");
  EXPECT_EQ(careful.message_bytes, 1400);
  EXPECT_FALSE(careful.multicast);
  EXPECT_EQ(careful.lease_s, 60);
  const Wire cyclone = wire(
      "<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast>"
      "<MaxMessageSize>1400B</MaxMessageSize></General><Discovery><LeaseDuration>30s"
      "</LeaseDuration></Discovery></Domain></CycloneDDS>");
  EXPECT_EQ(cyclone.message_bytes, 1400);
  EXPECT_FALSE(cyclone.multicast);
  EXPECT_EQ(cyclone.lease_s, 30);
}

}  // namespace
}  // namespace tocsin::qos_tool
