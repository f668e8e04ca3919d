// SPDX-License-Identifier: Apache-2.0
// The XML that is exported, as Fast DDS's own parser reads it, is what the runtime gives Fast DDS
// for the same profile: all policies of both ends, compared by Fast DDS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "runtime/fast_dds/version.hpp"
#include "runtime/middleware/fast_dds_qos.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "vendor_xml.hpp"

namespace tocsin::qos_tool {
namespace {

namespace dds = eprosima::fastdds::dds;
using ::testing::IsEmpty;

constexpr Vendor installed = fast_dds::version >= 3 ? Vendor::fast_dds_3 : Vendor::fast_dds;

/// Domain that no participant of a test speaks on: nothing is written.
constexpr int domain = 95;

/// The policies of both kinds of ends that differ. Partitions are the publisher's and subscriber's;
/// Fast DDS 2.9.1 notes those of an XML file as a property of the end, too.
template <class Qos>
std::vector<std::string> differences(Qos read, const Qos& used) {
  read.properties() = used.properties();
  std::vector<std::string> found;
  const auto compare = [&found](const char* policy, bool same) {
    if (!same) found.emplace_back(policy);
  };
  compare("reliability", read.reliability() == used.reliability());
  compare("durability", read.durability() == used.durability());
  compare("deadline", read.deadline() == used.deadline());
  compare("liveliness", read.liveliness() == used.liveliness());
  compare("ownership", read.ownership() == used.ownership());
  compare("lifespan", read.lifespan() == used.lifespan());
  compare("history", read.history() == used.history());
  compare("resource_limits", read.resource_limits() == used.resource_limits());
  compare("user_data", read.user_data() == used.user_data());
  compare("data_sharing", read.data_sharing() == used.data_sharing());
  compare("endpoint", read.endpoint() == used.endpoint());
  if (found.empty() && !(read == used)) found.emplace_back("a policy that is not compared alone");
  return found;
}

class FastDdsXml : public ::testing::Test {
 protected:
  void SetUp() override {
    participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, dds::PARTICIPANT_QOS_DEFAULT);
    ASSERT_NE(participant_, nullptr);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  }
  void TearDown() override {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  static void load(const std::string& xml) {
    ASSERT_EQ(dds::DomainParticipantFactory::get_instance()->load_XML_profiles_string(xml.c_str(),
                                                                                      xml.size()),
              dds::RETCODE_OK)
        << xml;
  }
  void expect_same(const std::string& name, const QosProfile& profile) {
    dds::DataWriterQos writer;
    ASSERT_EQ(publisher_->get_datawriter_qos_from_profile(name, writer), dds::RETCODE_OK);
    EXPECT_THAT(differences(writer, writer_qos(profile)), IsEmpty()) << name;
    EXPECT_EQ(writer.reliable_writer_qos().disable_heartbeat_piggyback,
              !profile.heartbeat_piggyback);
    dds::DataReaderQos reader;
    ASSERT_EQ(subscriber_->get_datareader_qos_from_profile(name, reader), dds::RETCODE_OK);
    const auto used = reader_qos(requested({"", "", Scope::host}, profile));
    EXPECT_THAT(differences(reader, used), IsEmpty()) << name;
    dds::PublisherQos holder;
    ASSERT_EQ(participant_->get_publisher_qos_from_profile(name, holder), dds::RETCODE_OK);
    EXPECT_EQ(holder.partition().getNames(), profile.partition) << name;
  }

  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
};

TEST_F(FastDdsXml, TheShippedProfilesAreReadAsTheRuntimeUsesThem) {
  const QosProfiles shipped(TOCSIN_REPOSITORY "/config/qos.yaml");
  load(export_xml(installed, shipped.all()).xml);
  for (const auto& [name, profile] : shipped.all()) expect_same(name, profile);
}

TEST_F(FastDdsXml, EveryPolicyThatItKnowsIsReadAsTheRuntimeUsesIt) {
  QosProfile strange;
  strange.durability = Durability::transient_local;
  strange.deadline_s = 0.29;
  strange.liveliness = Liveliness::manual_by_topic;
  strange.liveliness_lease_s = 3.7;
  strange.ownership = Ownership::exclusive;
  strange.ownership_strength = 12;
  strange.partition = {"a", "b*"};
  strange.history = History::keep_all;
  strange.depth = 9;
  strange.lifespan_s = 1.25;
  strange.max_samples = 77;
  strange.allocated_samples = 5;
  strange.extra_samples = 6;
  strange.memory_policy = MemoryPolicy::dynamic;
  strange.max_blocking_time_s = 0.35;
  strange.initial_heartbeat_delay_s = 0.02;
  strange.heartbeat_period_s = 0.11;
  strange.nack_response_delay_s = 0.01;
  strange.nack_suppression_s = 0.03;
  strange.heartbeat_piggyback = false;
  strange.initial_acknack_delay_s = 0.04;
  strange.heartbeat_response_delay_s = 0.06;
  strange.liveliness_announcement_s = 0.9;
  strange.publish_mode = PublishMode::asynchronous;
  strange.user_data = "who=me;";
  load(export_xml(installed, {{"strange", strange}}).xml);
  expect_same("strange", strange);
}

}  // namespace
}  // namespace tocsin::qos_tool
