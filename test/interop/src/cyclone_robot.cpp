// SPDX-License-Identifier: Apache-2.0
#include "cyclone_robot.hpp"

#include <dds/ddsi/ddsi_serdata.h>

#include <chrono>
#include <cstdint>
#include <fstream>
#include <thread>
#include <vector>

#include "cyclone.hpp"
#include "geometry_msgs.h"
#include "robot.h"
#include "sensor_msgs.h"

namespace tocsin::interop {
namespace {

constexpr auto period = std::chrono::milliseconds(100);
/// Of a TurtleBot 4: a lidar of 720 rays and a camera of 30 kB.
constexpr std::size_t rays = 720;
constexpr std::size_t jpeg_bytes = 30'000;
constexpr const char* picture_type = "sensor_msgs::msg::dds_::CompressedImage_";

/// FNV-1a of 64 bits.
std::uint64_t hash_of(const std::vector<unsigned char>& bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ULL;
  return hash;
}

CycloneParticipant::Qos usual(bool reliable) {
  CycloneParticipant::Qos qos = CycloneParticipant::qos();
  dds_qset_reliability(qos.get(), reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, 10);
  return qos;
}

/// One topic at one side.
class Stream {
 public:
  Stream(const CycloneParticipant& participant, const dds_topic_descriptor_t& type,
         const char* name, const char* type_name, bool reliable)
      : name_(name), participant_(participant), qos_(usual(reliable)) {
    topic_ = participant.topic(type, name, type_name);
    reader_ = participant.reader(topic_, qos_);
  }
  void offer() { writer_ = participant_.writer(topic_, qos_); }
  void write(const void* message) const { (void)checked(dds_write(writer_, message)); }
  /// Tells what came, at its own side what was written.
  void tell(std::ofstream& log) const {
    ddsi_serdata* sample = nullptr;
    dds_sample_info_t info{};
    while (dds_takecdr(reader_, &sample, 1, &info, DDS_ANY_STATE) == 1) {
      std::vector<unsigned char> bytes(ddsi_serdata_size(sample));
      ddsi_serdata_to_ser(sample, 0, bytes.size(), bytes.data());
      ddsi_serdata_unref(sample);
      if (!info.valid_data) continue;
      log << name_ << ' ' << hash_of(bytes) << ' ' << bytes.size() << std::endl;
    }
  }

 private:
  const char* name_;
  const CycloneParticipant& participant_;
  CycloneParticipant::Qos qos_;
  dds_entity_t topic_ = 0;
  dds_entity_t reader_ = 0;
  dds_entity_t writer_ = 0;
};

/// Each differs from the one before it in many places.
void write_velocity(const Stream& stream, int number) {
  geometry_msgs_msg_Twist message{};
  message.linear.x = number;
  message.angular.z = -0.25 * number;
  stream.write(&message);
}

void write_scan(const Stream& stream, int number) {
  std::vector<float> ranges(rays);
  for (std::size_t i = 0; i < rays; ++i) {
    ranges[i] = static_cast<float>(number) + 0.001F * static_cast<float>(i);
  }
  std::string frame = "rplidar_link";
  robot_LaserScan message{};
  message.header.stamp.sec = number;
  message.header.frame_id = frame.data();
  message.ranges._length = message.intensities._length = rays;
  message.ranges._buffer = message.intensities._buffer = ranges.data();
  stream.write(&message);
}

void write_picture(const Stream& stream, int number) {
  std::vector<std::uint8_t> data(jpeg_bytes);
  for (std::size_t i = 0; i < data.size(); ++i) {
    data[i] = static_cast<std::uint8_t>(7 * i + static_cast<std::size_t>(number));
  }
  std::string frame = "oakd_rgb_camera_optical_frame";
  std::string format = "jpeg";
  sensor_msgs_msg_CompressedImage message{};
  message.header.stamp.sec = number;
  message.header.frame_id = frame.data();
  message.format = format.data();
  message.data._length = jpeg_bytes;
  message.data._buffer = data.data();
  stream.write(&message);
}

}  // namespace

void be_cyclone_robot(Side side, int domain, const RobotLogs& logs) {
  const CycloneParticipant participant(domain);
  Stream velocity(participant, geometry_msgs_msg_Twist_desc, velocities,
                  "geometry_msgs::msg::dds_::Twist_", true);
  Stream scan(participant, robot_LaserScan_desc, scans, "sensor_msgs::msg::dds_::LaserScan_",
              false);
  Stream picture(participant, sensor_msgs_msg_CompressedImage_desc, pictures, picture_type, false);
  const bool is_robot = side == Side::robot;
  if (is_robot) scan.offer(), picture.offer();
  if (!is_robot) velocity.offer();
  std::ofstream sent(logs.sent);
  std::ofstream heard(logs.heard);
  for (int number = 1;; ++number) {
    if (is_robot) {
      write_scan(scan, number);
      write_picture(picture, number);
    } else {
      write_velocity(velocity, number);
    }
    velocity.tell(is_robot ? heard : sent);
    scan.tell(is_robot ? sent : heard);
    picture.tell(is_robot ? sent : heard);
    std::this_thread::sleep_for(period);
  }
}

}  // namespace tocsin::interop
