// SPDX-License-Identifier: Apache-2.0
// bringup/gateway.yaml, shipped: what peers that are no part of it write on one host arrives on the
// other, over the emulated radio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::seconds;
using ::testing::StartsWith;

constexpr auto patience = seconds(60);
/// Nobody here knows it.
const RawTopic never{"rt/robot/never", "nobody_msgs::msg::dds_::Never_", true};
/// Domains of gateway.yaml.
constexpr int robot_domain = 0;
constexpr int station_domain = 1;

std::vector<std::uint8_t> never_message() {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};
  for (int i = 0; i < 251; ++i) bytes.push_back(static_cast<std::uint8_t>(7 * i));
  return bytes;
}

std::string to_hex(const std::vector<std::uint8_t>& bytes) {
  const std::string digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += digits[byte / digits.size()];
    text += digits[byte % digits.size()];
  }
  return text;
}

BusOptions on(int domain) {
  BusOptions options;
  options.name = "robot";
  options.host_domain = domain;
  return options;
}

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  std::string text;
  std::getline(in, text);
  return text;
}

TEST(Gateway, AMessageOfATypeThatNobodyKnowsArrivesByteForByte) {
  const TemporaryFolder folder;
  const Stack stack(
      {folder.write("gateway_on_one_computer.yaml", gateway_on_one_computer), "--seed", "1"});
  const auto run = [&](const char* process) { return stack.pid(process) != 0; };
  for (const char* const process : {"uxv/link", "uxv/recorder", "gcs/link", "gcs/recorder"}) {
    ASSERT_TRUE(Stack::eventually(patience, [&] { return run(process); })) << process << '\n'
                                                                           << stack.output();
  }
  const std::string file = folder.path("came");
  const Peer reader(stack.running("gcs/link"), [&] {
    const auto graph = make_host_graph(on(station_domain));
    const auto reading = graph->read(
        never, [&](RawSample&& sample) { std::ofstream(file) << to_hex(*sample.bytes) << '\n'; });
    for (;;) pause();
  });
  const Peer writer(stack.running("uxv/link"), [] {
    const auto graph = make_host_graph(on(robot_domain));
    const auto writing = graph->write(never);
    for (;;) {
      (void)writing->write(never_message());
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  });
  const std::string expected = to_hex(never_message());
  EXPECT_TRUE(Stack::eventually(patience, [&] { return text_of(file).size() >= expected.size(); }))
      << stack.output();
  // RTPS pads to a multiple of four.
  EXPECT_THAT(text_of(file), StartsWith(expected));
  EXPECT_LE(text_of(file).size(), expected.size() + 6);
}

/// Numbered pictures of 26 packets: all that were read, and the last of them.
struct Pictures {
  int read = 0;
  int first = 0;
  int last = 0;
};

Pictures pictures_in(const std::string& file) {
  std::ifstream in(file);
  Pictures pictures;
  for (int number = 0; in >> number; ++pictures.read) {
    if (pictures.read == 0) pictures.first = number;
    pictures.last = number;
  }
  return pictures;
}

/// One in sixteen pictures would come if a lost packet lost its picture.
TEST(Gateway, PicturesArriveThoughTheRadioLosesATenthOfItsPackets) {
  const TemporaryFolder folder;
  const Stack stack(
      {folder.write("gateway_on_one_computer.yaml", gateway_on_one_computer), "--seed", "1"});
  for (const char* const process : {"uxv/link", "gcs/link"}) {
    ASSERT_TRUE(Stack::eventually(patience, [&] { return stack.pid(process) != 0; }))
        << stack.output();
  }
  stack.control("radio.sock", "set mode bernoulli");
  stack.control("radio.sock", "set delay_s 0.005");
  stack.control("radio.sock", "set loss 0.1");
  const std::string file = folder.path("numbers");
  const Peer reader(stack.running("gcs/link"), [&] {
    const auto graph = make_host_graph(on(station_domain));
    std::ofstream out(file);
    const auto reading = graph->read(
        never, [&](RawSample&& sample) { out << int{(*sample.bytes)[4]} << std::endl; });
    for (;;) pause();
  });
  const Peer writer(stack.running("uxv/link"), [] {
    const auto graph = make_host_graph(on(robot_domain));
    const auto writing = graph->write(never);
    std::vector<std::uint8_t> picture(30'000);
    picture[1] = 1;  // little-endian CDR
    for (int number = 0; number < 256; ++number) {
      picture[4] = static_cast<std::uint8_t>(number);
      (void)writing->write(picture);
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
    }
    for (;;) pause();
  });
  const auto are_enough = [&] {
    const Pictures pictures = pictures_in(file);
    return pictures.last >= pictures.first + 40;
  };
  ASSERT_TRUE(Stack::eventually(2 * patience, are_enough)) << stack.output();
  const Pictures pictures = pictures_in(file);
  EXPECT_GE(pictures.read, 0.8 * (pictures.last - pictures.first + 1));
}

}  // namespace
}  // namespace tocsin
