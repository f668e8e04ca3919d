// SPDX-License-Identifier: Apache-2.0
#include "shape_bus.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "foundation/temporary_folder.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::shapes {
namespace {

constexpr const char* profile_name = "shape";

/// The profile as a QoS file has it.
std::string qos_text(const QosProfile& qos) {
  std::string text = fmt::format(
      "{}: {{reliability: {}, durability: {}, history: {}, depth: {}, ownership: {}, "
      "heartbeat_period_s: 0.1, minimum_separation_s: {}",
      profile_name, word_of(qos.reliability), word_of(qos.durability), word_of(qos.history),
      qos.depth, word_of(qos.ownership), qos.minimum_separation_s);
  if (qos.exclusive()) text += fmt::format(", ownership_strength: {}", qos.ownership_strength);
  if (std::isfinite(qos.deadline_s)) text += fmt::format(", deadline_s: {}", qos.deadline_s);
  if (std::isfinite(qos.lifespan_s)) text += fmt::format(", lifespan_s: {}", qos.lifespan_s);
  if (!qos.partition.empty()) text += fmt::format(", partition: ['{}']", qos.partition.front());
  return text + "}\n";
}

}  // namespace

const TypeInfo& shape_type() {
  static const TypeInfo type = [] {
    TypeInfo renamed = type_info<ShapeType>();
    renamed.name = "ShapeType";
    return renamed;
  }();
  return type;
}

std::unique_ptr<Bus> make_shape_bus(const ShapeOptions& options) {
  const TemporaryFolder folder;
  BusOptions made;
  made.name = "tocsin_shapes";
  made.host_domain = options.domain;
  made.plain_names = true;
  made.qos_file = folder.path() + "/qos.yaml";
  std::ofstream(made.qos_file) << qos_text(options.qos);
  return make_fast_dds_bus(made);
}

Endpoint shape_endpoint(const char* topic) {
  return {{topic, profile_name, Scope::host}, &shape_type()};
}

ShapeType message_of(const Shape& shape) {
  ShapeType message;
  message.color(shape.color);
  message.x(shape.x);
  message.y(shape.y);
  message.shapesize(shape.size);
  message.additional_payload_size(shape.payload);
  return message;
}

Shape shape_of(const ShapeType& message) {
  return {message.color(), message.x(), message.y(), message.shapesize(),
          message.additional_payload_size()};
}

namespace {

/// An event of an end, by its names at a writer and at a reader.
struct Event {
  bool has_happened;
  const char* at_writer;
  const char* at_reader;
  std::string text;
};

void tell(const EndpointHealth& end, const Event& event) {
  if (!event.has_happened) return;
  say(fmt::format("{}() topic: '{}'  type: 'ShapeType' : {}",
                  end.writer ? event.at_writer : event.at_reader, end.topic, event.text));
}

}  // namespace

void EventPrinter::look(Bus& bus) {
  for (const EndpointHealth& one : bus.host_control().health()) {
    Seen& seen = seen_[one.topic];
    tell(one, {one.matched != seen.matched, "on_publication_matched", "on_subscription_matched",
               fmt::format("matched {} (change = {})", one.matched, one.matched - seen.matched)});
    tell(one, {one.incompatible_qos != seen.incompatible, "on_offered_incompatible_qos",
               "on_requested_incompatible_qos", one.incompatible_policy});
    tell(one, {one.deadlines_missed != seen.deadlines, "on_offered_deadline_missed",
               "on_requested_deadline_missed", fmt::format("(total = {})", one.deadlines_missed)});
    seen = {one.matched, one.incompatible_qos, one.deadlines_missed};
  }
}

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

}  // namespace tocsin::shapes
