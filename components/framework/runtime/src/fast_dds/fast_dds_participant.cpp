// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/fast_dds_participant.hpp"

#include <chrono>
#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <utility>

#include "fast_dds/cdr_topic_type.hpp"
#include "foundation/error.hpp"
#include "graph/ros_graph.hpp"
#include "idl_support/type_registry.hpp"
#include "runtime/fast_dds/settings.hpp"
#include "runtime/middleware/fast_dds_qos.hpp"
#include "runtime/middleware/idl_libraries.hpp"
#include "transport/packet_filter.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

/// Empty when no library here has the type.
std::string known_hash(const char* type) {
  const TypeInfo* const known = find_type(type);
  return known != nullptr ? known->ros_hash : "";
}

template <class Qos>
Qos in_partition(Qos qos, const std::vector<std::string>& partition) {
  qos.partition().clear();
  for (const std::string& name : partition) qos.partition().push_back(name.c_str());
  return qos;
}

/// Fast DDS 2.9.1 does not announce a list that becomes empty; the partition without name is the
/// same.
std::vector<std::string> announced(const std::vector<std::string>& partition) {
  return partition.empty() ? std::vector<std::string>{""} : partition;
}

/// Fast DDS hands these out as const, and changes and deletes only through what is not.
dds::Publisher* publisher_of(dds::DataWriter* writer) {
  return const_cast<dds::Publisher*>(writer->get_publisher());
}
dds::Subscriber* subscriber_of(dds::DataReader* reader) {
  return const_cast<dds::Subscriber*>(reader->get_subscriber());
}

/// Fast DDS takes settings from the environment, too, where people keep those of ROS 2: by
/// $ROS_DISCOVERY_SERVER each participant here would look for that server alone, and find nobody.
/// When this library is loaded, before there are threads.
[[maybe_unused]] const bool environment_is_ignored = []() noexcept {
  for (const char* variable :
       {"ROS_DISCOVERY_SERVER", "ROS_SUPER_CLIENT", "FASTDDS_ENVIRONMENT_FILE",
        "FASTDDS_BUILTIN_TRANSPORTS", "FASTDDS_STATISTICS", "FASTDDS_DEFAULT_PROFILES_FILE",
        "FASTRTPS_DEFAULT_PROFILES_FILE"}) {
    ::unsetenv(variable);
  }
  return ::setenv("SKIP_DEFAULT_XML_FILE", "1", 1) == 0;  // one of that name in this folder
}();

/// Packets, not calls, between the participants of this process: what mends discovery after a lease
/// (AckNackCounts) and what bounds it (PacketFilter) stand before the sockets.
void deliver_by_packets() {
  static const bool done = [] {
    fast_dds::deliver_by_packets();
    return true;
  }();
  (void)done;
}

Keys keys_of(const TypeInfo& type) { return type.longest_key > 0 ? Keys::some : Keys::none; }

ParticipantOptions with_filter(ParticipantOptions options) {
  options.filter = packet_filter(options);
  return options;
}

template <class Qos>
void announce(const std::string& user_data, Qos& qos) {
  qos.user_data().data_vec({user_data.begin(), user_data.end()});
}

/// Moves what holds an end; false when Fast DDS refused it.
template <class Holder>
bool move_to(Holder* holder, const std::vector<std::string>& partition) {
  const auto before = holder->get_qos().partition().getNames();
  if (before == partition || before == announced(partition)) return true;
  return holder->set_qos(in_partition(holder->get_qos(), announced(partition))) == dds::RETCODE_OK;
}

}  // namespace

FastDdsParticipant::FastDdsParticipant(ParticipantOptions options)
    : options_(with_filter(std::move(options))), farewell_(options_.farewell) {
  deliver_by_packets();
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

std::string FastDdsParticipant::announcement(const std::string& topic, const TypeInfo& type,
                                             const std::string& user_data) const {
  const bool on_link = !options_.peers.empty();    // where each announcement takes air
  const bool as_given = topic == discovery_topic;  // a hash there says which gids it takes
  if (on_link || as_given || !type_hash_in(user_data).empty()) return user_data;
  std::string hash = known_hash(type.name);
  if (hash.empty()) hash = remote_ends_.type_hash(topic, type.name);
  if (hash.empty()) {
    load_idl_libraries();  // what a router carries is of any package
    hash = known_hash(type.name);
  }
  return with_type_hash(user_data, hash);
}

dds::DataWriter* FastDdsParticipant::create_writer(const std::string& name, const TypeInfo& type,
                                                   const QosProfile& profile,
                                                   dds::DataWriterListener& listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto* const publisher =
      participant_->create_publisher(in_partition(dds::PUBLISHER_QOS_DEFAULT, profile.partition));
  dds::DataWriterQos qos = writer_qos(profile, keys_of(type));
  announce(announcement(name, type, profile.user_data), qos);
  auto* const writer = publisher->create_datawriter(topic(name, type), qos, &listener);
  if (writer != nullptr) return writer;
  participant_->delete_publisher(publisher);
  throw EnvironmentError("DDS writer of " + name + " cannot be created");
}

dds::DataReader* FastDdsParticipant::create_reader(const std::string& name, const TypeInfo& type,
                                                   const QosProfile& profile,
                                                   dds::DataReaderListener& listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto* const subscriber =
      participant_->create_subscriber(in_partition(dds::SUBSCRIBER_QOS_DEFAULT, profile.partition));
  dds::DataReaderQos qos = reader_qos(profile, keys_of(type));
  announce(announcement(name, type, profile.user_data), qos);
  auto* const reader = subscriber->create_datareader(topic(name, type), qos, &listener);
  if (reader != nullptr) return reader;
  participant_->delete_subscriber(subscriber);
  throw EnvironmentError("DDS reader of " + name + " cannot be created");
}

bool FastDdsParticipant::change(dds::DataWriter* writer, const QosProfile& profile) {
  dds::DataWriterQos qos = writer->get_qos();
  qos.deadline().period = dds_duration(profile.deadline_s);
  qos.lifespan().duration = dds_duration(profile.lifespan_s);
  qos.ownership_strength().value = static_cast<std::uint32_t>(profile.ownership_strength);
  return writer->set_qos(qos) == dds::RETCODE_OK &&
         move_to(publisher_of(writer), profile.partition);
}

bool FastDdsParticipant::change(dds::DataReader* reader, const QosProfile& profile) {
  dds::DataReaderQos qos = reader->get_qos();
  qos.deadline().period = dds_duration(profile.deadline_s);
  return reader->set_qos(qos) == dds::RETCODE_OK &&
         move_to(subscriber_of(reader), profile.partition);
}

void FastDdsParticipant::say_farewell(dds::DataWriter& writer) {
  const Duration left = farewell_;
  if (left <= Duration::zero()) return;
  const auto begin = std::chrono::steady_clock::now();
  (void)writer.wait_for_acknowledgments(dds_duration(to_seconds(left)));
  farewell_ = left - (std::chrono::steady_clock::now() - begin);
}

void FastDdsParticipant::remove(dds::DataWriter* writer) {
  say_farewell(*writer);
  dds::Publisher* const publisher = publisher_of(writer);
  publisher->delete_datawriter(writer);
  participant_->delete_publisher(publisher);
}

void FastDdsParticipant::remove(dds::DataReader* reader) {
  dds::Subscriber* const subscriber = subscriber_of(reader);
  subscriber->delete_datareader(reader);
  participant_->delete_subscriber(subscriber);
}

void FastDdsParticipant::supersede(const rtps::GuidPrefix_t& participant) {
  if (options_.filter) options_.filter->supersede(participant);
}

}  // namespace tocsin
