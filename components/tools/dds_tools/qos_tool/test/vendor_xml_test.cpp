// SPDX-License-Identifier: Apache-2.0
// What the formats cannot say. Fast DDS's own reading: fast_dds_xml_test; DDS-XML:
// cyclone_xml_test.
#include "vendor_xml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::qos_tool {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(VendorXml, TheShippedProfilesLoseNothingOnFastDds) {
  const QosProfiles shipped(TOCSIN_REPOSITORY "/config/qos.yaml");
  EXPECT_THAT(export_xml(Vendor::fast_dds, shipped.all()).lost, IsEmpty());
}

TEST(VendorXml, AnExportSaysWhatTheFormatCannotSay) {
  QosProfile profile;
  profile.max_rate_hz = 20;
  profile.minimum_separation_s = 0.5;
  profile.heartbeat_period_s = 1;
  profile.partition = {"", "a"};
  EXPECT_THAT(export_xml(Vendor::fast_dds, {{"p", profile}}).lost,
              ElementsAre(HasSubstr("p.max_rate_hz: 20 is lost"),
                          HasSubstr("p.minimum_separation_s: 0.5 is lost"),
                          HasSubstr("the partition without name is lost")));
  EXPECT_THAT(export_xml(Vendor::cyclone, {{"p", profile}}).lost,
              ElementsAre(HasSubstr("p.heartbeat_period_s: 1 is lost"),
                          HasSubstr("p.max_rate_hz: 20 is lost")));
}

}  // namespace
}  // namespace tocsin::qos_tool
