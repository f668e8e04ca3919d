// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/fast_dds_participant.hpp"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <utility>

#include "fast_dds/cdr_topic_type.hpp"
#include "fast_dds/fast_dds_qos.hpp"
#include "fast_dds/shared_memory_leftovers.hpp"
#include "foundation/error.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;

template <class Qos>
Qos in_partition(Qos qos, const std::vector<std::string>& partition) {
  for (const std::string& name : partition) qos.partition().push_back(name.c_str());
  return qos;
}

}  // namespace

FastDdsParticipant::FastDdsParticipant(ParticipantOptions options) : options_(std::move(options)) {
  if (options_.shared_memory) remove_shared_memory_leftovers();
  participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<std::uint32_t>(options_.domain), participant_qos(options_), &discovery_listener_,
      dds::StatusMask::none());
  options_.reception->release();
  if (participant_ == nullptr) {
    throw EnvironmentError("DDS participant " + options_.name + " in domain " +
                           std::to_string(options_.domain) + " cannot be created on " +
                           options_.address + " (is the address there, are ports free?)");
  }
  prefix_ = participant_->guid().guidPrefix;
}

FastDdsParticipant::~FastDdsParticipant() {
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

dds::Topic* FastDdsParticipant::topic(const std::string& name, const TypeInfo& type) {
  if (dds::TopicDescription* found = participant_->lookup_topicdescription(name)) {
    return static_cast<dds::Topic*>(found);
  }
  dds::TypeSupport support(new CdrTopicType(type));
  support.register_type(participant_);
  return participant_->create_topic(name, type.name, dds::TOPIC_QOS_DEFAULT);
}

dds::Publisher* FastDdsParticipant::publisher(const Partition& partition) {
  auto& found = publishers_[partition];
  if (found == nullptr) {
    found = participant_->create_publisher(in_partition(dds::PUBLISHER_QOS_DEFAULT, partition));
  }
  return found;
}

dds::Subscriber* FastDdsParticipant::subscriber(const Partition& partition) {
  auto& found = subscribers_[partition];
  if (found == nullptr) {
    found = participant_->create_subscriber(in_partition(dds::SUBSCRIBER_QOS_DEFAULT, partition));
  }
  return found;
}

dds::DataWriter* FastDdsParticipant::create_writer(const std::string& name, const TypeInfo& type,
                                                   const QosProfile& profile,
                                                   dds::DataWriterListener& listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return publisher(profile.partition)
      ->create_datawriter(topic(name, type), writer_qos(profile), &listener);
}

dds::DataReader* FastDdsParticipant::create_reader(const std::string& name, const TypeInfo& type,
                                                   const QosProfile& profile,
                                                   dds::DataReaderListener& listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return subscriber(profile.partition)
      ->create_datareader(topic(name, type), reader_qos(profile), &listener);
}

void FastDdsParticipant::remove(dds::DataWriter* writer) {
  // Fast DDS hands out its publisher as const, and deletes only through a publisher that is not.
  if (writer == nullptr) return;
  const_cast<dds::Publisher*>(writer->get_publisher())->delete_datawriter(writer);
}

void FastDdsParticipant::remove(dds::DataReader* reader) {
  if (reader == nullptr) return;
  const_cast<dds::Subscriber*>(reader->get_subscriber())->delete_datareader(reader);
}

}  // namespace tocsin
