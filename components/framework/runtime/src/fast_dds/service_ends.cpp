// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/service_ends.hpp"

#include <algorithm>
#include <cstring>

#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "rtps/this_host.hpp"
#include "runtime/fast_dds/names.hpp"

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;

/// Numbers of calls with a header begin here, so that they are none of Fast DDS.
constexpr std::int64_t first_headed = std::int64_t{1} << 62;

/// What ROS 2's services offer and ask for.
QosProfile service_qos(int depth, const TypeInfo& type) {
  QosProfile qos;
  qos.reliability = Reliability::reliable;
  qos.depth = depth;
  qos.heartbeat_period_s = 0.2;
  qos.user_data = with_type_hash("", type.ros_hash);
  return qos;
}

RawEnd request_end(const std::string& ros_namespace, const ServiceEndpoint& endpoint) {
  return {service_topics(ros_namespace, service_name(endpoint)).request, endpoint.request->name,
          service_qos(endpoint.depth, *endpoint.request)};
}

RawEnd reply_end(const std::string& ros_namespace, const ServiceEndpoint& endpoint) {
  return {service_topics(ros_namespace, service_name(endpoint)).reply, endpoint.response->name,
          service_qos(endpoint.depth, *endpoint.response)};
}

rtps::GUID_t guid_of(const Gid& gid) {
  rtps::GUID_t guid;
  const auto* const rest = gid.data() + rtps::GuidPrefix_t::size;
  std::copy(gid.data(), rest, guid.guidPrefix.value);
  std::copy_n(rest, rtps::EntityId_t::size, guid.entityId.value);
  return guid;
}

std::int64_t number_of(const rtps::SampleIdentity& identity) {
  return static_cast<std::int64_t>(identity.sequence_number().to64long());
}

rtps::SequenceNumber_t sequence_of(std::int64_t number) {
  return {static_cast<std::int32_t>(number >> 32), static_cast<std::uint32_t>(number)};
}

bool is_known(const rtps::GUID_t& guid) { return guid != rtps::GUID_t::unknown(); }

}  // namespace

MatchedParticipants::Prefix MatchedParticipants::prefix_of(const Gid& gid) {
  Prefix prefix;
  std::copy_n(gid.begin(), prefix.size(), prefix.begin());
  return prefix;
}

void MatchedParticipants::count(const Gid& end, bool there) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if ((ends_[end] += there ? 1 : -1) <= 0) ends_.erase(end);
}

bool MatchedParticipants::has(const Prefix& participant) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(ends_.begin(), ends_.end(),
                     [&](const auto& one) { return prefix_of(one.first) == participant; });
}

std::vector<Gid> MatchedParticipants::ends() const {
  std::vector<Gid> all;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& one : ends_) all.push_back(one.first);
  return all;
}

DdsServer::DdsServer(FastDdsParticipant& participant, const std::string& ros_namespace,
                     const ServiceEndpoint& endpoint, ServerReceiver& receiver)
    : participant_(participant),
      endpoint_(endpoint),
      receiver_(receiver),
      replies_(participant, reply_end(ros_namespace, endpoint),
               [this](const rtps::GUID_t& client, bool there) {
                 clients_.count(gid_of(client), there);
                 if (there) receiver_.wake();
               }),
      requests_(participant, request_end(ros_namespace, endpoint),
                [this](const auto& bytes, const dds::SampleInfo& info) { take(*bytes, info); }) {}

/// Called by threads of Fast DDS.
void DdsServer::take(const Bytes& bytes, const dds::SampleInfo& info) {
  const rtps::GUID_t& writer = info.sample_identity.writer_guid();
  const rtps::GUID_t& related = info.related_sample_identity.writer_guid();
  ServiceRequest request;
  request.id.participant = MatchedParticipants::prefix_of(gid_of(writer));
  const std::string announced = participant_.remote_ends().writer(writer).user_data;
  if (is_known(related) || correlation_of(gid_of(writer), announced) == Correlation::identity) {
    request.id.client = gid_of(is_known(related) ? related : writer);
    request.id.number = number_of(info.sample_identity);
    request.message = decode(*endpoint_.request, bytes);
  } else if (const auto headed = take_header(bytes)) {
    request.id.correlation = Correlation::header;
    std::memcpy(request.id.client.data(), &headed->header.client, sizeof headed->header.client);
    request.id.number = headed->header.number;
    request.message = decode(*endpoint_.request, headed->bytes);
  }
  if (request.message) receiver_.receive(std::move(request));
}

void DdsServer::reply(const CallId& id, const std::shared_ptr<const void>& message) {
  Bytes bytes = encode(*endpoint_.response, message.get());
  if (clients_.has(id.participant)) {
    send(id, bytes);
    return;
  }
  if (waiting_.size() == static_cast<std::size_t>(endpoint_.depth)) waiting_.pop_front();
  waiting_.emplace_back(id, std::move(bytes));
}

void DdsServer::flush() {
  for (auto it = waiting_.begin(); it != waiting_.end();) {
    if (!clients_.has(it->first.participant)) {
      ++it;
      continue;
    }
    send(it->first, it->second);
    it = waiting_.erase(it);
  }
}

void DdsServer::send(const CallId& id, const Bytes& message) {
  rtps::WriteParams params;
  if (id.correlation == Correlation::identity) {
    params.related_sample_identity().writer_guid(guid_of(id.client));
    params.related_sample_identity().sequence_number(sequence_of(id.number));
    (void)replies_.write(message, params);
    return;
  }
  CycloneHeader header;
  std::memcpy(&header.client, id.client.data(), sizeof header.client);
  header.number = id.number;
  (void)replies_.write(with_header(message, header), params);
}

DdsClient::DdsClient(FastDdsParticipant& participant, const std::string& ros_namespace,
                     const ServiceEndpoint& endpoint, ClientReceiver& receiver)
    : participant_(participant),
      endpoint_(endpoint),
      receiver_(receiver),
      id_(fresh_source()),
      last_headed_(first_headed),
      replies_(
          participant, reply_end(ros_namespace, endpoint),
          [this](const auto& bytes, const dds::SampleInfo& info) { take(*bytes, info); },
          [this](const rtps::GUID_t& server, bool there) {
            reply_writers_.count(gid_of(server), there);
            receiver_.wake();
          }),
      requests_(participant, request_end(ros_namespace, endpoint),
                [this](const rtps::GUID_t& server, bool there) {
                  request_readers_.count(gid_of(server), there);
                  receiver_.wake();
                }) {}

/// One whose two ends are both matched.
std::optional<Gid> DdsClient::server() const {
  for (const Gid& reader : request_readers_.ends()) {
    if (reply_writers_.has(MatchedParticipants::prefix_of(reader))) return reader;
  }
  return std::nullopt;
}

std::optional<std::int64_t> DdsClient::send(const std::shared_ptr<const void>& message) {
  const auto asked = server();
  if (!asked) return std::nullopt;
  const Bytes bytes = encode(*endpoint_.request, message.get());
  const std::string announced = participant_.remote_ends().writer(guid_of(*asked)).user_data;
  return correlation_of(*asked, announced) == Correlation::header ? send_headed(bytes)
                                                                  : send_identified(bytes);
}

std::optional<std::int64_t> DdsClient::send_identified(const Bytes& message) {
  rtps::WriteParams params;
  params.related_sample_identity().writer_guid(guid_of(replies_.gid()));
  if (!requests_.write(message, params)) return std::nullopt;
  return number_of(params.sample_identity());
}

std::optional<std::int64_t> DdsClient::send_headed(const Bytes& message) {
  rtps::WriteParams params;
  if (!requests_.write(with_header(message, {id_, last_headed_ + 1}), params)) return std::nullopt;
  return ++last_headed_;
}

/// Called by threads of Fast DDS.
void DdsClient::take(const Bytes& bytes, const dds::SampleInfo& info) {
  const Gid related = gid_of(info.related_sample_identity.writer_guid());
  if (related == replies_.gid() || related == requests_.gid()) {
    hand_over(bytes, number_of(info.related_sample_identity));
    return;
  }
  if (is_known(info.related_sample_identity.writer_guid())) return;  // it answers somebody else
  const auto headed = take_header(bytes);
  if (headed && headed->header.client == id_) hand_over(headed->bytes, headed->header.number);
}

void DdsClient::hand_over(const Bytes& bytes, std::int64_t number) {
  if (auto message = decode(*endpoint_.response, bytes)) {
    receiver_.receive({std::move(message), number});
  }
}

}  // namespace tocsin
