// SPDX-License-Identifier: Apache-2.0
#include "documents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "signed_text.hpp"

namespace tocsin::keystore {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::int64_t now_s = 1'795'000'000;

TEST(Documents, APermissionSaysWhoMayDoWhatAndUntilWhen) {
  const Grant grant{"CN=/uxv1", now_s, now_s + 86'400, {{"rt/location", "rt/*"}, {"rt/goal"}}};
  const std::string text = permissions_xml(grant);
  EXPECT_THAT(text, HasSubstr("<subject_name>CN=/uxv1</subject_name>"));
  EXPECT_THAT(text, HasSubstr("<default>DENY</default>"));
  const auto read = grant_in(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->subject, "CN=/uxv1");
  EXPECT_EQ(read->from_s, now_s);
  EXPECT_EQ(read->until_s, now_s + 86'400);
  EXPECT_THAT(read->permissions.publish, ElementsAre("rt/location", "rt/*"));
  EXPECT_THAT(read->permissions.subscribe, ElementsAre("rt/goal"));
  EXPECT_THAT(text, HasSubstr("<min>0</min><max>230</max>")) << "as Cyclone DDS takes them";
}

TEST(Documents, WhoMayDoNothingHasNoEmptyList) {
  const std::string text = permissions_xml({"CN=/uxv1", 0, 1, {}});
  EXPECT_THAT(text, Not(HasSubstr("<topics>")));
  const auto read = grant_in(text);
  ASSERT_TRUE(read);
  EXPECT_THAT(read->permissions.publish, IsEmpty());
}

TEST(Documents, WhatIsNoPermissionIsNotRead) {
  for (const char* text : {"", "<dds>", "<dds><permissions/></dds>", "not xml", "<a></b>"}) {
    EXPECT_FALSE(grant_in(text)) << text;
  }
}

TEST(Documents, UnknownDatesAreNotRead) {
  std::string text = permissions_xml({"CN=/uxv1", 0, 1, {}});
  text.replace(text.find("1970"), 4, "soon");
  EXPECT_FALSE(grant_in(text));
}

TEST(Documents, ADateIsOfUtc) { EXPECT_EQ(date_text(0), "1970-01-01T00:00:00Z"); }

TEST(Documents, GovernanceLetsNobodyInWhoIsUnknownAndHidesWhatIsSaid) {
  const std::string text = governance_xml();
  EXPECT_THAT(text, HasSubstr("<allow_unauthenticated_participants>false<"));
  EXPECT_THAT(text, HasSubstr("<enable_join_access_control>true<"));
  EXPECT_THAT(text, HasSubstr("<enable_read_access_control>true<"));
  EXPECT_THAT(text, HasSubstr("<enable_write_access_control>true<"));
  EXPECT_THAT(text, HasSubstr("<discovery_protection_kind>ENCRYPT<"));
  EXPECT_THAT(text, HasSubstr("<liveliness_protection_kind>ENCRYPT<"));
  EXPECT_THAT(text, HasSubstr("<data_protection_kind>ENCRYPT<"));
}

TEST(Documents, GovernanceLeavesTheWriterOfAPacketReadable) {
  const std::string text = governance_xml();
  EXPECT_THAT(text, HasSubstr("<metadata_protection_kind>SIGN<"));
  EXPECT_THAT(text, HasSubstr("<rtps_protection_kind>NONE<"));
  EXPECT_THAT(text, HasSubstr("<topic_expression>*<"));
}

TEST(SignedText, IsTheTextForWhoeverKnowsTheAuthority) {
  const Authority authority = make_authority("one", now_s, 1);
  const std::string document = sign(governance_xml(), authority);
  EXPECT_EQ(verified(document, *authority.certificate, now_s), governance_xml());
}

TEST(SignedText, ChangedOrOfAnotherAuthorityItIsRefused) {
  const Authority authority = make_authority("one", now_s, 1);
  const Authority other = make_authority("one", now_s, 1);
  std::string document = sign(governance_xml(), authority);
  EXPECT_FALSE(verified(document, *other.certificate, now_s));
  document.replace(document.find("ENCRYPT"), 7, "NONE   ");
  EXPECT_FALSE(verified(document, *authority.certificate, now_s));
  for (const char* text : {"", "no document", "MIME-Version: 1.0\n"}) {
    EXPECT_FALSE(verified(text, *authority.certificate, now_s)) << text;
  }
}

TEST(SignedText, OfAnAuthorityThatHasExpiredItIsRefused) {
  const Authority authority = make_authority("one", now_s, 1);
  const std::string document = sign("text", authority);
  EXPECT_FALSE(verified(document, *authority.certificate, now_s + 2 * 86'400));
}

}  // namespace
}  // namespace tocsin::keystore
