// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <mutex>
#include <string>

#include "fast_dds/discovery_listener.hpp"
#include "fast_dds/fast_dds_transport.hpp"
#include "foundation/time.hpp"
#include "idl_support/type_info.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {

/// A Fast DDS participant. Each writer has a publisher and each reader a subscriber of its own, so
/// that partitions, which are theirs, can change with one end. Deletes all that it made.
/// Thread-safe.
class FastDdsParticipant {
 public:
  /// Throws EnvironmentError when Fast DDS cannot create it.
  explicit FastDdsParticipant(ParticipantOptions options);
  ~FastDdsParticipant();
  FastDdsParticipant(const FastDdsParticipant&) = delete;
  FastDdsParticipant& operator=(const FastDdsParticipant&) = delete;

  /// `topic` is the DDS name, with `rt/`. The listener and the profile must outlive the endpoint.
  /// Throws EnvironmentError when Fast DDS refuses.
  eprosima::fastdds::dds::DataWriter* create_writer(
      const std::string& topic, const TypeInfo& type, const QosProfile& qos,
      eprosima::fastdds::dds::DataWriterListener& listener);
  eprosima::fastdds::dds::DataReader* create_reader(
      const std::string& topic, const TypeInfo& type, const QosProfile& qos,
      eprosima::fastdds::dds::DataReaderListener& listener);
  /// Gives an end what of the profile can change while it exists. False when Fast DDS refused it.
  [[nodiscard]] bool change(eprosima::fastdds::dds::DataWriter* writer, const QosProfile& qos);
  [[nodiscard]] bool change(eprosima::fastdds::dds::DataReader* reader, const QosProfile& qos);
  /// Waits until reliable readers have what it wrote, as long as ParticipantOptions::farewell
  /// lasts: a reader that hears of the end first drops what comes after. Then it is gone.
  void remove(eprosima::fastdds::dds::DataWriter* writer);
  void remove(eprosima::fastdds::dds::DataReader* reader);
  /// Whether a writer is one of this participant's own.
  [[nodiscard]] bool owns(const eprosima::fastdds::rtps::GUID_t& writer) const {
    return writer.guidPrefix == prefix_;
  }
  [[nodiscard]] const eprosima::fastdds::rtps::GuidPrefix_t& prefix() const { return prefix_; }
  [[nodiscard]] const eprosima::fastdds::rtps::GUID_t& guid() const { return participant_->guid(); }
  /// Another instance of a peer has taken the place of this one: see RtpsFilter.
  void supersede(const eprosima::fastdds::rtps::GuidPrefix_t& participant);
  [[nodiscard]] const RemoteEnds& remote_ends() const { return remote_ends_; }

 private:
  eprosima::fastdds::dds::Topic* topic(const std::string& name, const TypeInfo& type);
  /// The user data of an end: on a host with the hash of its type, where somebody knows it.
  [[nodiscard]] std::string announcement(const std::string& topic, const TypeInfo& type,
                                         const std::string& user_data) const;
  void say_farewell(eprosima::fastdds::dds::DataWriter& writer);

  const ParticipantOptions options_;
  RemoteEnds remote_ends_{options_.on_end, options_.on_participant};
  DiscoveryListener discovery_listener_{
      remote_ends_,
      options_.enclave.empty() ? Acquaintance::at_once : Acquaintance::when_authenticated,
      options_.filter};
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::rtps::GuidPrefix_t prefix_;
  std::mutex mutex_;
  std::atomic<Duration> farewell_;
};

}  // namespace tocsin
