// SPDX-License-Identifier: Apache-2.0
#include "datagram_socket.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::kobuki {
namespace {

namespace fs = std::filesystem;

class DatagramSocketTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_.path("control");
};

TEST_F(DatagramSocketTest, AnswersWhoHasAPath) {
  DatagramSocket sut(path_);
  DatagramSocket asking(folder_.path("asking"));
  asking.send(path_, "get");
  const auto question = sut.receive();
  ASSERT_TRUE(question);
  EXPECT_EQ(question->text, "get");
  EXPECT_EQ(question->sender, folder_.path("asking"));
  sut.send(question->sender, "battery=100");
  const auto answer = asking.receive();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->text, "battery=100");
  EXPECT_FALSE(asking.receive());
}

TEST_F(DatagramSocketTest, WhoHasNoPathIsHeardButCannotBeAnswered) {
  DatagramSocket sut(path_);
  DatagramSocket nameless;
  nameless.send(path_, std::string("a\0b", 3));
  const auto heard = sut.receive();
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->text, std::string("a\0b", 3)) << "as it came";
  EXPECT_EQ(heard->sender, "");
  sut.send(heard->sender, "lost without notice");
}

TEST_F(DatagramSocketTest, KeepsTheOrderAndTheBordersOfMessages) {
  DatagramSocket sut(path_);
  DatagramSocket sender;
  for (const char* text : {"one", "", "three"}) sender.send(path_, text);
  EXPECT_EQ(sut.receive()->text, "one");
  EXPECT_EQ(sut.receive()->text, "");
  EXPECT_EQ(sut.receive()->text, "three");
}

TEST_F(DatagramSocketTest, IsGoneWithItsOwnerAndWhatIsSentThenIsLost) {
  { const DatagramSocket sut(path_); }
  EXPECT_FALSE(fs::exists(path_));
  DatagramSocket().send(path_, "x");
  DatagramSocket().send(std::string(200, 'x'), "a path that no socket can have");
}

TEST_F(DatagramSocketTest, RefusesAPathThatIsInUseOrTakenOrTooLong) {
  const DatagramSocket living(path_);
  EXPECT_THROW(DatagramSocket{path_}, ConfigError);
  EXPECT_TRUE(fs::exists(path_)) << "the living one's";
  EXPECT_THROW(DatagramSocket{folder_.write("file", "precious")}, ConfigError);
  EXPECT_EQ(folder_.read("file"), "precious");
  EXPECT_THROW(DatagramSocket{folder_.path("no/such/folder")}, ConfigError);
  EXPECT_THROW(DatagramSocket{"/tmp/" + std::string(103, 'x')}, ConfigError);
}

}  // namespace
}  // namespace tocsin::kobuki
