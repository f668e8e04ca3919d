// SPDX-License-Identifier: Apache-2.0
#include "foreign_robot.hpp"

#include <chrono>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <memory>
#include <stdexcept>
#include <thread>

#include "crossing.hpp"
#include "idl_support/encode.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/nav_msgs.hpp"
#include "ros_idl/sensor_msgs.hpp"
#include "runtime/testing/bytes_type.hpp"

namespace tocsin::bench {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;
using Bytes = std::vector<std::uint8_t>;
using std::chrono::nanoseconds;
using std::chrono::steady_clock;

/// Encapsulation header.
constexpr std::size_t head = 4;
constexpr double ns_per_s = 1e9;

void append(Bytes& bytes, std::uint32_t number) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof number);
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

/// sensor_msgs/msg/LaserScan, which our IDL does not have: header with an empty frame_id, seven
/// floats, ranges and intensities.
Bytes laser_scan() {
  constexpr std::uint32_t rays = 720;
  Bytes bytes{0, 1, 0, 0};
  for (const std::uint32_t word : {0U, 0U, 1U, 0U}) append(bytes, word);  // stamp, "" padded
  for (int i = 0; i < 7; ++i) append(bytes, 0);
  for (int list = 0; list < 2; ++list) {
    append(bytes, rays);
    for (std::uint32_t i = 0; i < rays; ++i) append(bytes, 0);
  }
  return bytes;
}

/// A message of the stream; its first eight bytes are free for the time of its write.
Bytes message_of(const Stream& stream) {
  const std::string type = stream.type;
  const auto coded = [](const auto& message) {
    return encode(type_info<std::decay_t<decltype(message)>>(), &message);
  };
  if (type.find("Twist_") != std::string::npos) return coded(geometry_msgs::msg::Twist());
  if (type.find("Odometry_") != std::string::npos) return coded(nav_msgs::msg::Odometry());
  if (type.find("LaserScan_") != std::string::npos) return laser_scan();
  constexpr std::size_t jpeg_bytes = 30'000;
  sensor_msgs::msg::CompressedImage image;
  image.format("jpeg");
  image.data().resize(jpeg_bytes);
  return coded(image);
}

/// Twist begins with a double, the others with the stamp of their header.
bool begins_with_double(const Stream& stream) { return stream.to_robot; }

void put_time(const Stream& stream, std::int64_t now_ns, Bytes& bytes) {
  if (begins_with_double(stream)) {
    const double now_s = static_cast<double>(now_ns) / ns_per_s;
    std::memcpy(bytes.data() + head, &now_s, sizeof now_s);
    return;
  }
  const auto sec = static_cast<std::int32_t>(now_ns / 1'000'000'000);
  const auto nanosec = static_cast<std::uint32_t>(now_ns % 1'000'000'000);
  std::memcpy(bytes.data() + head, &sec, sizeof sec);
  std::memcpy(bytes.data() + head + sizeof sec, &nanosec, sizeof nanosec);
}

std::int64_t time_in(const Stream& stream, const Bytes& bytes) {
  if (begins_with_double(stream)) {
    double sent_s = 0;
    std::memcpy(&sent_s, bytes.data() + head, sizeof sent_s);
    return static_cast<std::int64_t>(sent_s * ns_per_s);
  }
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  std::memcpy(&sec, bytes.data() + head, sizeof sec);
  std::memcpy(&nanosec, bytes.data() + head + sizeof sec, sizeof nanosec);
  return sec * std::int64_t{1'000'000'000} + nanosec;
}

class Listener : public dds::DataReaderListener {
 public:
  Listener(const Stream& stream, RobotLog& log, StreamLog& own)
      : stream_(stream), log_(log), own_(own) {}
  void on_data_available(dds::DataReader* reader) override {
    Bytes bytes;
    dds::SampleInfo info;
    while (reader->take_next_sample(&bytes, &info) == dds::RETCODE_OK) {
      if (info.valid_data && bytes.size() >= 2 * head + head) take(bytes);
    }
  }

 private:
  void take(const Bytes& bytes) {
    const std::int64_t sent_ns = time_in(stream_, bytes);
    own_.heard.fetch_add(1);
    if (sent_ns < log_.from_ns || sent_ns >= log_.until_ns) return;
    const std::uint32_t at = own_.arrived.load();
    if (at == StreamLog::most) return;
    own_.arrived_ns[at] = wall_now_ns();
    own_.latency_ns[at] = own_.arrived_ns[at] - sent_ns;
    own_.bytes.fetch_add(bytes.size());
    own_.arrived.store(at + 1);
  }
  const Stream& stream_;
  RobotLog& log_;
  StreamLog& own_;
};

dds::DomainParticipant* join(const Place& place) {
  dds::DomainParticipantQos qos;
  if (!place.peer.empty()) {
    rtps::Locator_t peer;  // the radio carries no multicast
    peer.kind = LOCATOR_KIND_UDPv4;
    rtps::IPLocator::setIPv4(peer, place.peer);
    qos.wire_protocol().builtin.initialPeersList.push_back(peer);
  }
  auto* const participant = dds::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<std::uint32_t>(place.domain), qos);
  if (participant == nullptr) throw std::runtime_error("no participant");
  return participant;
}

/// The defaults of ROS 2: depth 10, or 5 of sensors.
template <class Qos>
Qos usual(const Stream& stream) {
  Qos qos;
  qos.reliability().kind =
      stream.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = stream.reliable ? 10 : 5;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  return qos;
}

/// A stream that is written here.
struct Writing {
  const Stream* stream;
  StreamLog* log;
  dds::DataWriter* writer;
  Bytes message;
  steady_clock::time_point next;
};

void write(Writing& one, const RobotLog& log) {
  const std::int64_t now_ns = wall_now_ns();
  put_time(*one.stream, now_ns, one.message);
  (void)one.writer->write(&one.message);
  if (now_ns >= log.from_ns && now_ns < log.until_ns) one.log->written.fetch_add(1);
  one.next += nanoseconds(std::int64_t{1'000'000'000} / one.stream->hz);
}

}  // namespace

void be_foreign(const Place& place, bool robot, RobotLog& log) {
  auto* const participant = join(place);
  auto* const publisher = participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  auto* const subscriber = participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  std::vector<std::unique_ptr<Listener>> listeners;
  std::vector<Writing> writings;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const Stream& stream = streams[i];
    StreamLog& own = log.of[i];
    dds::TypeSupport(new testing::BytesType(stream.type)).register_type(participant);
    auto* const topic =
        participant->create_topic(stream.topic, stream.type, dds::TOPIC_QOS_DEFAULT);
    if (stream.to_robot == robot) {
      listeners.push_back(std::make_unique<Listener>(stream, log, own));
      (void)subscriber->create_datareader(topic, usual<dds::DataReaderQos>(stream),
                                          listeners.back().get());
    } else {
      writings.push_back({&stream, &own,
                          publisher->create_datawriter(topic, usual<dds::DataWriterQos>(stream)),
                          message_of(stream), steady_clock::now()});
    }
  }
  for (;;) {
    Writing* first = &writings.front();
    for (Writing& one : writings) first = one.next < first->next ? &one : first;
    std::this_thread::sleep_until(first->next);
    write(*first, log);
  }
}

}  // namespace tocsin::bench
