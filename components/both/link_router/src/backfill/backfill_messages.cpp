// SPDX-License-Identifier: Apache-2.0
#include "backfill/backfill_messages.hpp"

#include "foundation/ros_names.hpp"
#include "idl_support/type_definition.hpp"
#include "wire_names.hpp"

namespace tocsin {
namespace {

constexpr const char* topic_fact = "tocsin_topic";
constexpr const char* type_fact = "tocsin_type";
constexpr const char* user_data_fact = "tocsin_user_data";
constexpr int backfilled_depth = 1000;

std::string fact(const sample_log::LoggedStream& stream, const char* key) {
  const auto found = stream.facts.find(key);
  return found == stream.facts.end() ? "" : found->second;
}

}  // namespace

tocsin_msgs::msg::Backfill to_message(const router::BackfillBatch& batch) {
  tocsin_msgs::msg::Backfill message;
  message.session(batch.session);
  message.number(batch.number);
  for (const sample_log::LogEntry& entry : batch.samples) {
    tocsin_msgs::msg::StoredSample sample;
    sample.source(entry.id.source);
    sample.sequence_number(entry.id.sequence);
    sample.sent_ns(entry.sent_wall_ns);
    sample.data(entry.bytes);
    message.samples().push_back(std::move(sample));
  }
  return message;
}

router::BackfillBatch to_batch(const tocsin_msgs::msg::Backfill& message, std::uint64_t stream) {
  router::BackfillBatch batch{message.session(), message.number(), stream, {}};
  for (const tocsin_msgs::msg::StoredSample& sample : message.samples()) {
    batch.samples.push_back(
        {{stream, sample.source(), sample.sequence_number()}, sample.sent_ns(), sample.data()});
  }
  return batch;
}

bool is_sound(const tocsin_msgs::msg::Backfill& message) {
  return is_wire_name(message.topic(), "_/") && is_wire_name(message.type(), "_:");
}

tocsin_msgs::msg::LogRequest to_message(const router::HistoryRange& range) {
  tocsin_msgs::msg::LogRequest message;
  message.id(range.id);
  message.topic(range.topic);
  message.from_ns(range.from_ns);
  message.to_ns(range.to_ns);
  return message;
}

std::optional<router::HistoryRange> to_range(const tocsin_msgs::msg::LogRequest& message) {
  if (!is_wire_name(message.topic(), "_/")) return std::nullopt;
  return router::HistoryRange{message.id(), message.topic(), message.from_ns(), message.to_ns()};
}

sample_log::LoggedStream logged_stream(const std::string& name, const Flow& flow) {
  sample_log::LoggedStream stream;
  stream.name = name;
  stream.topic = "/" + flow.topic;
  stream.schema.name = ros_type(flow.type);
  if (auto definition = ros2msg_definition(flow.type)) {
    stream.schema.encoding = "ros2msg";
    stream.schema.data = std::move(*definition);
  }
  stream.facts = {
      {topic_fact, flow.topic}, {type_fact, flow.type}, {user_data_fact, flow.user_data}};
  return stream;
}

Flow flow_of(const sample_log::LoggedStream& stream) {
  Flow flow;
  flow.topic = fact(stream, topic_fact);
  flow.type = fact(stream, type_fact);
  flow.user_data = fact(stream, user_data_fact);
  return flow;
}

Flow backfilled(const Flow& flow) {
  Flow later;
  later.topic = flow.topic + "/backfilled";
  later.type = flow.type;
  later.user_data = flow.user_data;
  later.reliable = true;
  later.transient_local = true;
  later.depth = backfilled_depth;
  return later;
}

}  // namespace tocsin
