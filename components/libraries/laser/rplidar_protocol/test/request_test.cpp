// SPDX-License-Identifier: Apache-2.0
#include "rplidar_protocol/request.hpp"

#include <gtest/gtest.h>

namespace tocsin::rplidar {
namespace {

/// As Slamtec's protocol prints them.
TEST(Request, HasTheBytesOfTheProtocol) {
  EXPECT_EQ(request(Command::scan), (Bytes{0xA5, 0x20}));
  EXPECT_EQ(request(Command::stop), (Bytes{0xA5, 0x25}));
  EXPECT_EQ(request(Command::get_health), (Bytes{0xA5, 0x52}));
  EXPECT_EQ(request(Command::express_scan),
            (Bytes{0xA5, 0x82, 0x05, 0x00, 0x00, 0x00, 0x00, 0x00, 0x22}));
  EXPECT_EQ(motor_request(660), (Bytes{0xA5, 0xF0, 0x02, 0x94, 0x02, 0xC1}));
}

std::vector<Request> read(const Bytes& bytes, std::size_t portion) {
  RequestReader reader;
  std::vector<Request> found;
  for (std::size_t at = 0; at < bytes.size(); at += portion) {
    reader.add(ByteView{bytes.data(), bytes.size()}.part(at, std::min(portion, bytes.size() - at)));
    while (const auto one = reader.next()) found.push_back(*one);
  }
  return found;
}

TEST(RequestReader, FindsRequestsHoweverTheyAreCut) {
  Bytes bytes;
  for (const Bytes& one : {request(Command::stop), motor_request(660),
                           request(Command::express_scan), request(Command::get_info)}) {
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  for (const std::size_t portion : {1U, 2U, 3U, 100U}) {
    const auto found = read(bytes, portion);
    ASSERT_EQ(found.size(), 4U) << portion;
    EXPECT_EQ(found[0].command, Command::stop);
    EXPECT_EQ(found[1].command, Command::set_motor_pwm);
    EXPECT_EQ(found[1].motor_duty, 660);
    EXPECT_EQ(found[2].command, Command::express_scan);
    EXPECT_EQ(found[3].command, Command::get_info);
  }
}

TEST(RequestReader, PassesOverWhatIsNone) {
  EXPECT_TRUE(read({0x00, 0xA5, 0x33, 0x25}, 1).empty()) << "no such command";
  Bytes damaged = motor_request(660);
  damaged.back() ^= 1;
  EXPECT_TRUE(read(damaged, 100).empty());
  damaged.push_back(0xA5);
  damaged.push_back(0x20);
  EXPECT_EQ(read(damaged, 1).size(), 1U);
}

}  // namespace
}  // namespace tocsin::rplidar
