// SPDX-License-Identifier: Apache-2.0
#include "player.hpp"

#include <chrono>
#include <utility>

#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "writer_qos.hpp"

namespace tocsin::bag_tool {
namespace {

constexpr const char* clock_type = "rosgraph_msgs::msg::dds_::Clock_";

/// As it was on the wire; a type of plain DDS keeps its name.
std::string type_on_wire(const std::string& ros_type_name) {
  try {
    return wire_type(ros_type_name);
  } catch (const ConfigError&) {
    return ros_type_name;
  }
}

}  // namespace

std::pair<std::string, std::string> remapping(const std::string& text) {
  const std::size_t between = text.find(":=");
  const bool good = between != std::string::npos && between > 0 && between + 2 < text.size();
  if (!good) {
    throw ConfigError("--remap: '" + printable(text) + "' is not OLD_TOPIC:=NEW_TOPIC");
  }
  return {absolute(text.substr(0, between)), absolute(text.substr(between + 2))};
}

std::vector<std::uint8_t> encoded_clock(std::int64_t ns) {
  constexpr std::int64_t ns_per_s = 1'000'000'000;
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};  // CDR, little endian
  for (const std::int64_t part : {ns / ns_per_s, ns % ns_per_s}) {
    for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(part >> (8 * i)));
  }
  return bytes;
}

Player::Player(HostGraph& graph, const PlayOrder& order)
    : graph_(graph), order_(order), choice_(order.topics), reader_(order.bag) {
  selection_.from_ns = later(reader_.about().start_ns, order_.start_offset_s);
  selection_.to_ns = later(selection_.from_ns, order_.duration_s);
  selection_.wanted = [this](const bag::Topic& topic) {
    return topic.serialization_format == "cdr" && choice_.contains(topic.name);
  };
  make_writings();
}

void Player::make_writings() {
  bool any = false;
  for (const auto& [topic, count] : reader_.topics()) {
    writings_.emplace_back();
    if (count == 0 || !selection_.wanted(topic)) continue;
    const auto renamed = order_.remap.find(topic.name);
    RawTopic raw;
    raw.name = wire_topic(renamed == order_.remap.end() ? topic.name : renamed->second);
    raw.type = type_on_wire(topic.type);
    writings_.back() = graph_.write(raw, writer_qos(topic.offered_qos));
    any = true;
  }
  if (!any) throw ConfigError(order_.bag + ": has no message of encoding cdr of these topics");
  if (order_.clock_hz > 0) {
    QosProfile qos;  // as a ROS time source: best effort, the last one
    qos.reliability = Reliability::best_effort;
    clock_ = graph_.write({"rt/clock", clock_type, false, false}, qos);
  }
}

std::uint64_t Player::run() {
  sleep_until_stopped(std::chrono::steady_clock::now() + seconds(order_.delay_s));
  do {
    const std::uint64_t before = written_;
    play_once();
    if (written_ == before) break;  // nothing lies in the part that was asked for
  } while (order_.loop && !is_stopped());
  return written_;
}

void Player::play_once() {
  const Time begin = std::chrono::steady_clock::now();
  const Pace pace(order_.rate, selection_.from_ns, begin);
  next_clock_ = begin;
  const auto stream = reader_.messages(selection_);
  while (const auto one = stream->next()) {
    wait(pace, pace.due(one->message.log_time_ns));
    if (is_stopped()) return;
    const bag::Message& message = one->message;
    bytes_.assign(message.data, message.data + message.size);
    if (writings_[one->topic]->write(bytes_)) {
      ++written_;
    } else {
      ++refused_;
    }
  }
}

void Player::wait(const Pace& pace, Time due) {
  while (clock_ && next_clock_ <= due && !is_stopped()) {
    sleep_until_stopped(next_clock_);
    (void)clock_->write(encoded_clock(pace.recorded_time_ns(next_clock_)));
    next_clock_ += seconds(1 / order_.clock_hz);
  }
  sleep_until_stopped(due);
}

}  // namespace tocsin::bag_tool
