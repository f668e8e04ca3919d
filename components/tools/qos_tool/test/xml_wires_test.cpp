// SPDX-License-Identifier: Apache-2.0
// What the participants of another maker's file do on the network.
#include "xml_wires.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace tocsin::qos_tool {
namespace {

std::vector<Wire> wires(Vendor vendor, const std::string& xml) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(xml.c_str()), tinyxml2::XML_SUCCESS) << xml;
  return wires_of(vendor, *document.RootElement());
}

/// A participant of Fast DDS with this in <rtps>, beside a transport `u` of 1400 bytes and one `v`
/// of default size.
Wire fast_dds(const std::string& rtps) {
  const auto found = wires(
      Vendor::fast_dds,
      "<dds><profiles><transport_descriptors>"
      "<transport_descriptor><transport_id>u</transport_id><maxMessageSize>1400</maxMessageSize>"
      "</transport_descriptor><transport_descriptor><transport_id>v</transport_id>"
      "</transport_descriptor></transport_descriptors>"
      "<participant profile_name='p'><rtps>" +
          rtps + "</rtps></participant></profiles></dds>");
  EXPECT_EQ(found.size(), 1U);
  EXPECT_EQ(found.at(0).whose, "participant p");
  return found.at(0);
}

Wire cyclone(const std::string& domain) {
  return wires(Vendor::cyclone, "<CycloneDDS><Domain>" + domain + "</Domain></CycloneDDS>").at(0);
}

TEST(FastDdsWires, WithoutAParticipantAreThoseOfTheLibrary) {
  for (const char* xml : {"<dds/>", "<dds><profiles/></dds>", "<profiles/>"}) {
    const auto found = wires(Vendor::fast_dds, xml);
    ASSERT_EQ(found.size(), 1U) << xml;
    EXPECT_EQ(found[0].message_bytes, 65'500);
    EXPECT_TRUE(found[0].multicast);
    EXPECT_EQ(found[0].lease_s, 20);
  }
}

TEST(FastDdsWires, AParticipantThatSaysNothingHasTheLibrarysDefaults) {
  const Wire wire = fast_dds("");
  EXPECT_EQ(wire.message_bytes, 65'500);
  EXPECT_TRUE(wire.multicast);
  EXPECT_EQ(wire.lease_s, 20);
}

TEST(FastDdsWires, TheLeaseIsRead) {
  const auto lease = [](const std::string& duration) {
    return fast_dds("<builtin><discovery_config><leaseDuration>" + duration +
                    "</leaseDuration></discovery_config></builtin>")
        .lease_s;
  };
  EXPECT_EQ(lease("<sec>60</sec>"), 60);
  EXPECT_TRUE(std::isinf(lease("<sec>DURATION_INFINITY</sec>")));
  EXPECT_EQ(lease("<sec>soon</sec>"), 20) << "Fast DDS would refuse the file";
}

TEST(FastDdsWires, NamedPeersReplaceTheGroupUnlessItIsNamed) {
  const std::string peers = "<initialPeersList><locator/></initialPeersList>";
  EXPECT_FALSE(fast_dds("<builtin>" + peers + "</builtin>").multicast);
  EXPECT_TRUE(
      fast_dds("<builtin>" + peers + "<metatrafficMulticastLocatorList/></builtin>").multicast);
}

TEST(FastDdsWires, OwnTransportsBoundTheMessageWhenThereAreNoOthers) {
  const auto with = [](const std::string& transports, const char* builtin) {
    return fast_dds("<userTransports>" + transports + "</userTransports><useBuiltinTransports>" +
                    builtin + "</useBuiltinTransports>")
        .message_bytes;
  };
  const std::string u = "<transport_id>u</transport_id>";
  EXPECT_EQ(with(u, "false"), 1400);
  EXPECT_EQ(with(u, "true"), 65'500) << "the built-in ones send, too";
  EXPECT_EQ(with(u + "<transport_id>v</transport_id>", "false"), 65'500);
  EXPECT_EQ(with("<transport_id>w</transport_id>", "false"), 65'500) << "nobody describes it";
}

TEST(FastDdsWires, EachParticipantHasItsOwn) {
  const auto found = wires(Vendor::fast_dds,
                           "<profiles><participant profile_name='a'/><data_writer/>"
                           "<participant profile_name='b'/></profiles>");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].whose, "participant b");
}

TEST(CycloneWires, AQosFileSaysNothingOfThem) {
  const auto found = wires(Vendor::cyclone, "<dds><qos_library name='l'/></dds>");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].message_bytes, 14'720);
  EXPECT_TRUE(found[0].multicast);
  EXPECT_EQ(found[0].lease_s, 10);
}

TEST(CycloneWires, AConfigurationIsRead) {
  EXPECT_EQ(cyclone("<General><MaxMessageSize>1400B</MaxMessageSize></General>").message_bytes,
            1400);
  EXPECT_EQ(cyclone("<General><MaxMessageSize>64 kB</MaxMessageSize></General>").message_bytes,
            65'536);
  EXPECT_EQ(cyclone("<General/>").message_bytes, 14'720);
  EXPECT_FALSE(cyclone("<General><AllowMulticast>false</AllowMulticast></General>").multicast);
  EXPECT_TRUE(cyclone("<General><AllowMulticast>spdp</AllowMulticast></General>").multicast);
  EXPECT_EQ(cyclone("<Discovery><LeaseDuration>30s</LeaseDuration></Discovery>").lease_s, 30);
}

}  // namespace
}  // namespace tocsin::qos_tool
