// SPDX-License-Identifier: Apache-2.0
#include "csv_tables/bag_tables.hpp"

#include <gmock/gmock.h>

#include "bag/bag_writer.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/encode.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using String = std_msgs::msg::String;

/// Two writers of /a/b and one message of a type that nobody knows.
void write_bag(const std::string& path) {
  bag::BagWriter writer(path, {});
  const std::size_t known = writer.add(bag::make_topic("rt/a/b", type_info<String>().name));
  bag::Topic other;
  other.name = "/scan";
  other.type = "foreign_msgs/msg/Scan";
  const std::size_t unknown = writer.add(other);
  String text;
  text.data("hello");
  const auto bytes = encode(type_info<String>(), &text);
  (void)writer.write(known, {4, 2'000'000'000, 1'000'000'000, bytes.data(), bytes.size(), 9});
  (void)writer.write(known, {1, 3'000'000'000, 2'500'000'000, bytes.data(), bytes.size(), 12});
  (void)writer.write(unknown, {7, 4'000'000'000, 4'000'000'000, bytes.data(), 4});
}

TEST(BagTables, HaveARowForEachMessageAndOneForItsFields) {
  const TemporaryFolder folder;
  write_bag(folder.path("bag"));
  const BagTables sut({folder.path("bag")});
  EXPECT_EQ(sut.messages(),
            "receive_s,send_s,topic,writer,sequence,bytes\n"
            "2.000000000,1.000000000,a/b,9,4,14\n"
            "3.000000000,2.500000000,a/b,12,1,14\n"
            "4.000000000,4.000000000,scan,0,7,4\n");
  EXPECT_EQ(sut.of("a/b"),
            "receive_s,send_s,sequence,data\n2.000000000,1.000000000,4,hello\n"
            "3.000000000,2.500000000,1,hello\n");
  EXPECT_EQ(sut.of("scan"), "") << "a type that nobody knows";
  EXPECT_EQ(sut.of("none"), "");
}

TEST(BagTables, AreOfTheTopicsThatAreWanted) {
  const TemporaryFolder folder;
  write_bag(folder.path("bag"));
  const BagTables sut({folder.path("bag")},
                      [](const std::string& topic) { return topic == "scan"; });
  EXPECT_THAT(sut.messages(), Not(HasSubstr("a/b")));
  EXPECT_THAT(sut.topics(), IsEmpty());
}

TEST(BagTables, BytesThatAreNoSuchMessageHaveTheirRowOfMessagesOnly) {
  const TemporaryFolder folder;
  {
    bag::BagWriter writer(folder.path("bag"), {});
    const std::size_t topic = writer.add(bag::make_topic("rt/a", type_info<String>().name));
    const std::vector<std::uint8_t> bytes{0, 1, 0, 0, 0xff, 0xff, 0xff, 0x7f};
    (void)writer.write(topic, {1, 1, 1, bytes.data(), bytes.size()});
  }
  const BagTables sut({folder.path("bag")});
  EXPECT_THAT(sut.messages(), HasSubstr(",a,0,1,8\n"));
  EXPECT_EQ(sut.of("a"), "");
}

TEST(ReadMessages, GivesThoseOfAPartInTheOrderOfTheirTimes) {
  const TemporaryFolder folder;
  write_bag(folder.path("bag"));
  bag::BagReader reader(folder.path("bag"));
  bag::Selection part;
  part.from_ns = 3'000'000'000;
  std::vector<std::string> got;
  read_messages(reader, part, [&got](const BagMessage& one) {
    got.push_back(one.about.topic + " " + std::to_string(one.about.sequence));
    EXPECT_EQ(one.type != nullptr, one.content != nullptr);
  });
  EXPECT_THAT(got, ElementsAre("a/b 1", "scan 7"));
}

TEST(RecordedBags, AreThoseOfARecorderThatWasStartedAgainInTheirOrder) {
  const TemporaryFolder folder;
  EXPECT_THAT(recorded_bags(folder.path()), IsEmpty());
  write_bag(folder.path("bag"));
  write_bag(folder.path("bag_2"));
  EXPECT_THAT(recorded_bags(folder.path()), ElementsAre(folder.path("bag"), folder.path("bag_2")));
  const BagTables sut(recorded_bags(folder.path()));
  EXPECT_THAT(sut.of("a/b"), HasSubstr("3.000000000,2.500000000,1,hello\n2.000000000"));
}

TEST(IsBag, AFolderOfABagOrAnMcapFile) {
  const TemporaryFolder folder;
  write_bag(folder.path("bag"));
  EXPECT_TRUE(is_bag(folder.path("bag")));
  EXPECT_TRUE(is_bag(folder.path("bag/bag_0.mcap")));
  EXPECT_FALSE(is_bag(folder.path()));
  EXPECT_FALSE(is_bag(folder.write("a.csv", "x")));
  EXPECT_FALSE(is_bag("/no/such.mcap"));
}

TEST(BagTables, RefuseWhatIsNoBag) { EXPECT_THROW(BagTables({"/no/such/bag"}), ConfigError); }

}  // namespace
}  // namespace tocsin
