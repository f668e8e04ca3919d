// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/remote_ends.hpp"

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

TEST_F(RemoteEndsTest, AnEndOfAnotherTypeOrLayoutIsNamedWithItsParticipantWhileItIsThere) {
  const struct {
    AnnouncedEnd remote;
    AnnouncedEnd own;
    const char* other_type;
    bool other_layout;
  } cases[] = {
      {{"rt/odom", "Odom", "0a", true}, own_reader, "", false},
      {{"rt/odom", "Odom", "0b", true}, own_reader, "Odom with another layout (gcs_main)", true},
      {{"rt/odom", "Twist", "", false}, own_writer, "Twist (gcs_main)", false},
      {{"rt/odom", "Odom", "", true}, own_reader, "", false},  // tells no layout
      {{"rt/goal", "Goal", "0b", true}, own_reader, "", false},
      {{"rt/odom", "Twist", "0b", false}, own_reader, "", false}};
  for (const auto& [remote, own, other_type, other_layout] : cases) {
    sut.add(guid(7, 1), remote);
    EXPECT_EQ(sut.other_type(own), other_type);
    const bool asked = remote.type == own.type && remote.topic == own.topic;
    EXPECT_EQ(asked && sut.has_other_layout(guid(7, 1), own), other_layout);
    sut.remove(guid(7, 1));
    EXPECT_EQ(sut.other_type(own), "") << other_type;
    EXPECT_FALSE(sut.has_other_layout(guid(7, 1), own));
  }
}

TEST_F(RemoteEndsTest, TheEndsOfAParticipantThatIsGoneAreForgottenAndNoOthers) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "0b", true});
  sut.add(guid(8, 1), {"rt/odom", "Odom", "0c", true});
  sut.remove(guid(7, 0).guidPrefix);
  EXPECT_EQ(sut.other_type(own_reader), "Odom with another layout (unnamed participant)");
}

AnnouncedEnd with_reliability(AnnouncedEnd end, Reliability reliability) {
  end.qos.reliability = reliability;
  return end;
}

TEST_F(RemoteEndsTest, AReaderThatRequestsMoreIsNamedToTheWriter) {
  const AnnouncedEnd best_effort = with_reliability(own_writer, Reliability::best_effort);
  sut.add(guid(7, 1), with_reliability(own_reader, Reliability::best_effort));
  EXPECT_EQ(sut.misfit(best_effort), "");
  sut.add(guid(7, 2), own_reader);
  EXPECT_EQ(sut.misfit(best_effort), "reliability (gcs_main)");
  EXPECT_EQ(sut.misfit(own_writer), "");
}

TEST_F(RemoteEndsTest, AWriterThatOffersLessIsNamedToTheReader) {
  AnnouncedEnd weak = with_reliability(own_writer, Reliability::best_effort);
  AnnouncedEnd strict = own_reader;
  strict.qos.durability = Durability::transient_local;
  sut.add(guid(7, 1), weak);
  EXPECT_EQ(sut.misfit(strict), "reliability, durability (gcs_main)");
}

TEST_F(RemoteEndsTest, AMisfitThatIsGoneIsForgotten) {
  const AnnouncedEnd best_effort = with_reliability(own_writer, Reliability::best_effort);
  sut.add(guid(7, 1), own_reader);
  sut.remove(guid(7, 1));
  EXPECT_EQ(sut.misfit(best_effort), "");
  sut.add(guid(7, 1), own_reader);
  sut.remove(guid(7, 0).guidPrefix);
  EXPECT_EQ(sut.misfit(best_effort), "");
}

TEST_F(RemoteEndsTest, EndsThatAreNotMeantToMatchAreNoMisfit) {
  const AnnouncedEnd best_effort = with_reliability(own_writer, Reliability::best_effort);
  AnnouncedEnd elsewhere = own_reader;
  elsewhere.qos.partition = {"left"};
  sut.add(guid(7, 1), elsewhere);
  sut.add(guid(7, 2), {"rt/goal", "Odom", "0a", false});
  sut.add(guid(7, 3), own_writer);
  sut.add(guid(7, 4), {"rt/odom", "Twist", "", false});  // another type is another complaint
  EXPECT_EQ(sut.misfit(best_effort), "");
}

TEST_F(RemoteEndsTest, ADurationThatWentOverTheWireIsTheSame) {
  AnnouncedEnd writer = own_writer;
  AnnouncedEnd reader = own_reader;
  writer.qos.deadline_s = 0.3;
  reader.qos.deadline_s = 0.3 - 1e-9;
  sut.add(guid(7, 1), reader);
  EXPECT_EQ(sut.misfit(writer), "");
  reader.qos.deadline_s = 0.3 - 1e-5;
  sut.add(guid(7, 1), reader);
  EXPECT_EQ(sut.misfit(writer), "deadline (gcs_main)");
}

TEST_F(RemoteEndsTest, AWriterIsKnownByItsParticipantAndWhatItAnnounces) {
  sut.add(guid(7, 1), {"rt/odom", "Odom", "0a", true, {}, "mine;tocsinlayout=0a;"});
  EXPECT_EQ(sut.writer(guid(7, 1)).name, "gcs_main");
  EXPECT_EQ(sut.writer(guid(7, 1)).user_data, "mine;tocsinlayout=0a;");
  EXPECT_EQ(sut.writer(guid(8, 1)).name, "");
  EXPECT_EQ(sut.writer(guid(8, 1)).user_data, "");
}

TEST_F(RemoteEndsTest, TellsWhatEachEndOfATopicAnnounces) {
  sut.add(guid(7, 1), {"ros_discovery_info", "Info", "", true, {}, "typehash=a;"});
  sut.add(guid(8, 1), {"ros_discovery_info", "Info", "", false, {}, ""});
  sut.add(guid(8, 2), {"rt/odom", "Odom", "", false, {}, "other"});
  EXPECT_EQ(sut.user_data_of("ros_discovery_info"), (std::vector<std::string>{"typehash=a;", ""}));
  sut.remove(guid(7, 1));
  EXPECT_EQ(sut.user_data_of("ros_discovery_info"), std::vector<std::string>{""});
  EXPECT_TRUE(sut.user_data_of("rt/nothing").empty());
}

TEST_F(RemoteEndsTest, TellsWhichTopicsOfAKindAreWritten) {
  sut.add(guid(7, 1), {"rq/dockRequest", "Dock", "", true});
  sut.add(guid(7, 2), {"rq/undockRequest", "Dock", "", false});
  sut.add(guid(7, 3), {"rt/odom", "Odom", "", true});
  EXPECT_EQ(sut.written_topics("rq/"), std::vector<std::string>{"rq/dockRequest"});
  EXPECT_TRUE(sut.written_topics("rr/").empty());
}

TEST_F(RemoteEndsTest, AParticipantOfRos2IsOneWithAnEnclaveThatIsNoneOfOurs) {
  EXPECT_FALSE(sut.has_ros2());
  sut.add(guid(8, 0).guidPrefix, "ours", participant_user_data);
  sut.add(guid(9, 0).guidPrefix, "plain DDS", "mine=1;");
  EXPECT_FALSE(sut.has_ros2());
  sut.add(guid(10, 0).guidPrefix, "/", "enclave=/;");
  EXPECT_TRUE(sut.has_ros2());
  sut.remove(guid(10, 0).guidPrefix);
  EXPECT_FALSE(sut.has_ros2());
}

TEST_F(RemoteEndsTest, KnowsTheHashThatAnEndOfATopicAndTypeHasAnnounced) {
  const std::string hash = "RIHS01_" + std::string(64, 'a');
  sut.add(guid(7, 1), {"rt/odom", "Odom", "", true, {}, "mine=1;"});
  EXPECT_EQ(sut.type_hash("rt/odom", "Odom"), "");
  sut.add(guid(8, 1), {"rt/odom", "Odom", "", false, {}, "typehash=" + hash + ";"});
  EXPECT_EQ(sut.type_hash("rt/odom", "Odom"), hash);
  EXPECT_EQ(sut.type_hash("rt/odom", "Other"), "");
  EXPECT_EQ(sut.type_hash("rt/other", "Odom"), "");
}

TEST(UserData, ThoseOfTwoVehiclesDoNotFindEachOther) {
  const std::string one = participant_data_for("uxv1");
  const std::string eleven = participant_data_for("uxv11");
  const std::string all = participant_data_for("");
  EXPECT_EQ(all, participant_user_data);
  EXPECT_FALSE(find_each_other(one, eleven));
  EXPECT_FALSE(find_each_other(eleven, one));
  EXPECT_TRUE(find_each_other(one, one));
  for (const std::string& site : {all, std::string("enclave=/;"), std::string()}) {
    EXPECT_TRUE(find_each_other(one, site)) << site;
    EXPECT_TRUE(find_each_other(site, one)) << site;
  }
}

TEST(UserData, TellsTheHashOfATypeThatHasOne) {
  EXPECT_EQ(with_type_hash("tocsinlayout=0a;", "RIHS01_ab"), "tocsinlayout=0a;typehash=RIHS01_ab;");
  EXPECT_EQ(with_type_hash("mine", "RIHS01_ab"), "mine;typehash=RIHS01_ab;");
  EXPECT_EQ(with_type_hash("mine", ""), "mine");
}

TEST(UserData, IsJoinedWithOneSemicolonBetween) {
  EXPECT_EQ(joined("a=1", "b=2;"), "a=1;b=2;");
  EXPECT_EQ(joined("a=1;", "b=2;"), "a=1;b=2;");
  EXPECT_EQ(joined("", "b=2;"), "b=2;");
  EXPECT_EQ(joined("a=1", ""), "a=1");
}

TEST(LayoutInUserData, IsFoundAgainBesideWhatTheProfileAskedFor) {
  EXPECT_EQ(with_layout("", "0a"), "tocsinlayout=0a;");
  EXPECT_EQ(with_layout("typehash=x", "0a"), "typehash=x;tocsinlayout=0a;");
  EXPECT_EQ(with_layout("typehash=x;", "0a"), "typehash=x;tocsinlayout=0a;");
  EXPECT_EQ(with_layout("mine", ""), "mine");
  EXPECT_EQ(layout_in("typehash=x;tocsinlayout=0a;more=1;"), "0a");
  EXPECT_EQ(layout_in("tocsinlayout=0a"), "0a");
  EXPECT_EQ(layout_in("typehash=x;"), "");
}

}  // namespace
}  // namespace tocsin
