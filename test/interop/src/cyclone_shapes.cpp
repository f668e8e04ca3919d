// SPDX-License-Identifier: Apache-2.0
// shape_main of the OMG's suite on Cyclone DDS 0.10.2: the other side of `tocsin shapes`.
#include <dds/dds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <random>
#include <thread>

#include "cyclone.hpp"
#include "foundation/time.hpp"
#include "shapes.h"
#include "shapes/shape.hpp"

namespace tocsin::interop {
namespace {

using shapes::Shape;
using shapes::ShapeOptions;

volatile std::sig_atomic_t over = 0;

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

dds_duration_t duration_of(double s) {
  return std::isinf(s) ? DDS_INFINITY : static_cast<dds_duration_t>(s * 1e9);
}

CycloneParticipant::Qos qos_of(const ShapeOptions& options) {
  const QosProfile& wanted = options.qos;
  auto qos = CycloneParticipant::qos();
  dds_qset_reliability(qos.get(),
                       wanted.reliable() ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(
      qos.get(), wanted.keeps_last() ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), wanted.keeps_all() ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST,
                   wanted.keeps_all() ? DDS_LENGTH_UNLIMITED : wanted.depth);
  if (wanted.keeps_last()) {
    dds_qset_durability_service(qos.get(), 0,
                                wanted.keeps_all() ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST,
                                wanted.keeps_all() ? DDS_LENGTH_UNLIMITED : wanted.depth,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  }
  dds_qset_deadline(qos.get(), duration_of(wanted.deadline_s));
  dds_qset_ownership(qos.get(),
                     wanted.exclusive() ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  if (options.publish) {
    dds_qset_ownership_strength(qos.get(), wanted.ownership_strength);
    dds_qset_lifespan(qos.get(), duration_of(wanted.lifespan_s));
    dds_qset_writer_data_lifecycle(qos.get(),
                                   options.final_state != shapes::FinalState::unregister);
  } else {
    dds_qset_time_based_filter(qos.get(), duration_of(wanted.minimum_separation_s));
  }
  return qos;
}

CycloneParticipant::Qos partition_of(const ShapeOptions& options) {
  auto qos = CycloneParticipant::qos();
  for (const std::string& name : options.qos.partition)
    dds_qset_partition1(qos.get(), name.c_str());
  return qos;
}

void tell(const char* event, const std::string& topic) {
  say(std::string(event) + "() topic: '" + topic + "'  type: 'ShapeType'");
}

shapes_msgs_ShapeType message_of(Shape& shape) {
  shapes_msgs_ShapeType message{};
  message.color = shape.color.data();
  message.x = shape.x;
  message.y = shape.y;
  message.shapesize = shape.size;
  message.additional_payload_size._buffer = shape.payload.data();
  message.additional_payload_size._length = static_cast<std::uint32_t>(shape.payload.size());
  message.additional_payload_size._maximum = message.additional_payload_size._length;
  return message;
}

Shape shape_of(const shapes_msgs_ShapeType& message) {
  const auto& bytes = message.additional_payload_size;
  return {message.color, message.x, message.y, message.shapesize,
          std::vector<std::uint8_t>(bytes._buffer, bytes._buffer + bytes._length)};
}

class Writer {
 public:
  Writer(const CycloneParticipant& cyclone, dds_entity_t publisher, const ShapeOptions& options,
         std::string topic)
      : topic_(std::move(topic)) {
    say("Create topic: " + topic_);
    const dds_entity_t type = cyclone.topic(shapes_msgs_ShapeType_desc, topic_, "ShapeType");
    say("Create writer for topic: " + topic_ + " color: " + options.color);
    writer_ = checked(dds_create_writer(publisher, type, qos_of(options).get(), nullptr));
  }
  void write(Shape shape, bool prints) {
    const shapes_msgs_ShapeType message = message_of(shape);
    (void)dds_write(writer_, &message);
    if (prints) say(shapes::sample_line(topic_, shape));
  }
  void end(Shape key, shapes::FinalState how) {
    const shapes_msgs_ShapeType message = message_of(key);
    if (how == shapes::FinalState::dispose) (void)dds_dispose(writer_, &message);
    if (how == shapes::FinalState::unregister) (void)dds_unregister_instance(writer_, &message);
  }
  void look() const {
    dds_publication_matched_status_t matched{};
    dds_offered_incompatible_qos_status_t incompatible{};
    dds_offered_deadline_missed_status_t missed{};
    (void)dds_get_publication_matched_status(writer_, &matched);
    (void)dds_get_offered_incompatible_qos_status(writer_, &incompatible);
    (void)dds_get_offered_deadline_missed_status(writer_, &missed);
    if (matched.total_count_change > 0) tell("on_publication_matched", topic_);
    if (incompatible.total_count_change > 0) tell("on_offered_incompatible_qos", topic_);
    if (missed.total_count_change > 0) tell("on_offered_deadline_missed", topic_);
  }

 private:
  const std::string topic_;
  dds_entity_t writer_ = 0;
};

class Reader {
 public:
  Reader(const CycloneParticipant& cyclone, dds_entity_t subscriber, const ShapeOptions& options,
         std::string topic)
      : topic_(std::move(topic)),
        filter_(shapes::ShapeFilter::of(options)),
        stamps_(options.stamps) {
    say("Create topic: " + topic_);
    const dds_entity_t type = cyclone.topic(shapes_msgs_ShapeType_desc, topic_, "ShapeType");
    say("Create reader for topic: " + topic_);
    reader_ = checked(dds_create_reader(subscriber, type, qos_of(options).get(), nullptr));
  }
  void print() const {
    const dds_time_t read_ns = dds_time();
    std::array<void*, 64> samples{};
    std::array<dds_sample_info_t, 64> infos{};
    for (;;) {
      const dds_return_t count =
          dds_take(reader_, samples.data(), infos.data(), samples.size(), samples.size());
      if (count <= 0) return;
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        print(*static_cast<const shapes_msgs_ShapeType*>(samples[i]), infos[i], read_ns);
      }
      (void)dds_return_loan(reader_, samples.data(), count);
    }
  }
  void look() const {
    dds_subscription_matched_status_t matched{};
    dds_requested_incompatible_qos_status_t incompatible{};
    dds_requested_deadline_missed_status_t missed{};
    (void)dds_get_subscription_matched_status(reader_, &matched);
    (void)dds_get_requested_incompatible_qos_status(reader_, &incompatible);
    (void)dds_get_requested_deadline_missed_status(reader_, &missed);
    if (matched.total_count_change > 0) tell("on_subscription_matched", topic_);
    if (incompatible.total_count_change > 0) tell("on_requested_incompatible_qos", topic_);
    if (missed.total_count_change > 0) tell("on_requested_deadline_missed", topic_);
  }

 private:
  void print(const shapes_msgs_ShapeType& message, const dds_sample_info_t& info,
             dds_time_t read_ns) const {
    if (info.valid_data) {
      const Shape shape = shape_of(message);
      if (!filter_.passes(shape)) return;
      const std::string stamps =
          stamps_ ? shapes::stamps_text(info.source_timestamp, read_ns) : std::string();
      say(shapes::sample_line(topic_, shape) + stamps);
    } else if (info.instance_state != DDS_IST_ALIVE) {
      say(shapes::instance_line(topic_, message.color,
                                info.instance_state == DDS_IST_NOT_ALIVE_DISPOSED
                                    ? "NOT_ALIVE_DISPOSED_INSTANCE_STATE"
                                    : "NOT_ALIVE_NO_WRITERS_INSTANCE_STATE"));
    }
  }

  const std::string topic_;
  const shapes::ShapeFilter filter_;
  const bool stamps_;
  dds_entity_t reader_ = 0;
};

/// Calls `look` until `s` are over.
template <class Look>
void wait(double s, const Look& look) {
  const auto end = std::chrono::steady_clock::now() + seconds(s);
  do {
    look();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  } while (std::chrono::steady_clock::now() < end && over == 0);
}

void publish(const ShapeOptions& options) {
  const CycloneParticipant cyclone(options.domain);
  const dds_entity_t publisher =
      checked(dds_create_publisher(cyclone.entity(), partition_of(options).get(), nullptr));
  Writer writer(cyclone, publisher, options, options.topic);
  shapes::ShapeMotion motion(options, std::random_device{}());
  for (int i = 0; over == 0 && (options.iterations == 0 || i < options.iterations); ++i) {
    for (const Shape& shape : motion.next()) writer.write(shape, options.print_written);
    wait(options.write_period_s, [&writer] { writer.look(); });
  }
  for (int i = 0; i < options.instances; ++i) {
    Shape key;
    key.color = shapes::numbered(options.color, i);
    writer.end(key, options.final_state);
  }
  wait(1, [&writer] { writer.look(); });
}

void subscribe(const ShapeOptions& options) {
  const CycloneParticipant cyclone(options.domain);
  const dds_entity_t subscriber =
      checked(dds_create_subscriber(cyclone.entity(), partition_of(options).get(), nullptr));
  const Reader reader(cyclone, subscriber, options, options.topic);
  while (over == 0) {
    reader.print();
    wait(options.read_period_s, [&reader] { reader.look(); });
  }
}

}  // namespace
}  // namespace tocsin::interop

int main(int argc, char** argv) {
  for (const int number : {SIGINT, SIGTERM}) {
    std::signal(number, [](int) { tocsin::interop::over = 1; });
  }
  try {
    const auto options = tocsin::shapes::parse_options(argc, argv);
    if (!options) return 0;
    if (!options->unsupported.empty()) {
      tocsin::interop::say("    " + options->unsupported + " = not supported");
      return 2;
    }
    options->publish ? tocsin::interop::publish(*options) : tocsin::interop::subscribe(*options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
