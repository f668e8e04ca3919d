// SPDX-License-Identifier: Apache-2.0
#include "../src/remote_ends.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

RemoteEnds::Guid guid(std::uint8_t process, std::uint8_t entity) {
  RemoteEnds::Guid guid;
  guid.guidPrefix.value[0] = process;
  guid.entityId.value[0] = entity;
  return guid;
}

const AnnouncedEnd own_reader{"rt/odom", "Odom", "0a", false};
const AnnouncedEnd own_writer{"rt/odom", "Odom", "0a", true};

class RemoteEndsTest : public ::testing::Test {
 protected:
  RemoteEndsTest() { sut.add(guid(7, 0).guidPrefix, "gcs_main"); }
  RemoteEnds sut;
};

TEST_F(RemoteEndsTest, AWriterOfTheSameLayoutFits) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "0a", true});
  EXPECT_EQ(sut.other_type(own_reader), "");
  EXPECT_FALSE(sut.has_other_layout(guid(7, 1), own_reader));
}

TEST_F(RemoteEndsTest, AWriterOfAnotherLayoutIsNamedWithItsParticipant) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "0b", true});
  EXPECT_EQ(sut.other_type(own_reader), "Odom with another layout (gcs_main)");
  EXPECT_TRUE(sut.has_other_layout(guid(7, 1), own_reader));
}

TEST_F(RemoteEndsTest, AReaderOfAnotherTypeIsNamedToTheWriter) {
  sut.add(guid(7, 1), {"rt/odom", "Twist", "", false});
  EXPECT_EQ(sut.other_type(own_writer), "Twist (gcs_main)");
}

TEST_F(RemoteEndsTest, AnEndThatDoesNotTellItsLayoutFitsByItsTypeName) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "", true});
  EXPECT_EQ(sut.other_type(own_reader), "");
  EXPECT_FALSE(sut.has_other_layout(guid(7, 1), own_reader));
}

TEST_F(RemoteEndsTest, OtherTopicsAndEndsOfTheSameKindDoNotMatter) {
  sut.add(guid(7, 1), {"rt/goal", "Goal", "0b", true});
  sut.add(guid(7, 2), {"rt/odom", "Twist", "0b", false});
  EXPECT_EQ(sut.other_type(own_reader), "");
}

TEST_F(RemoteEndsTest, AnEndThatIsGoneIsForgotten) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "0b", true});
  sut.remove(guid(7, 1));
  EXPECT_EQ(sut.other_type(own_reader), "");
  EXPECT_FALSE(sut.has_other_layout(guid(7, 1), own_reader));
}

TEST_F(RemoteEndsTest, TheEndsOfAParticipantThatIsGoneAreForgottenAndNoOthers) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "0b", true});
  sut.add(guid(8, 1), {"rt/odom", "Odom", "0c", true});
  sut.remove(guid(7, 0).guidPrefix);
  EXPECT_EQ(sut.other_type(own_reader), "Odom with another layout (unnamed participant)");
}

TEST(LayoutInUserData, IsFoundAgainBesideWhatTheProfileAskedFor) {
  EXPECT_EQ(with_layout("", "0a"), "tocsin_layout=0a;");
  EXPECT_EQ(with_layout("typehash=x", "0a"), "typehash=x;tocsin_layout=0a;");
  EXPECT_EQ(with_layout("typehash=x;", "0a"), "typehash=x;tocsin_layout=0a;");
  EXPECT_EQ(with_layout("mine", ""), "mine");
  EXPECT_EQ(layout_in("typehash=x;tocsin_layout=0a;more=1;"), "0a");
  EXPECT_EQ(layout_in("tocsin_layout=0a"), "0a");
  EXPECT_EQ(layout_in("typehash=x;"), "");
}

}  // namespace
}  // namespace tocsin
