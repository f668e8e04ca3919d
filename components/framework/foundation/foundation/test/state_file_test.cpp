// SPDX-License-Identifier: Apache-2.0
#include "foundation/state_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace tocsin {
namespace {

class StateFileTest : public ::testing::Test {
 protected:
  StateFileTest() { std::filesystem::remove(path_); }
  ~StateFileTest() override { std::filesystem::remove(path_); }

  [[nodiscard]] std::string bytes() const {
    std::ostringstream text;
    text << std::ifstream(path_, std::ios::binary).rdbuf();
    return text.str();
  }
  void damage(std::size_t at) const {
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file.put('#');
  }

  const std::string path_ = ::testing::TempDir() + "state_" + std::to_string(::getpid());
};

TEST_F(StateFileTest, HasNothingBeforeTheFirstSave) {
  EXPECT_FALSE(StateFile(path_).load());
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(StateFileTest, AnotherProcessFindsTheNewestText) {
  {
    StateFile sut(path_);
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(sut.save("text " + std::to_string(i)));
  }
  StateFile successor(path_);
  EXPECT_EQ(successor.load(), "text 4");
  ASSERT_TRUE(successor.save("text 5"));
  EXPECT_EQ(StateFile(path_).load(), "text 5");
}

TEST_F(StateFileTest, NeedsNoRoomAfterTheFirstSave) {
  StateFile sut(path_);
  ASSERT_TRUE(sut.save("a"));
  const std::size_t size = bytes().size();
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(sut.save(std::string(StateFile::longest, 'b')));
  EXPECT_EQ(bytes().size(), size);
}

TEST_F(StateFileTest, KeepsTheTextBeforeWhenTheLastWriteWasCutAnywhere) {
  for (std::size_t at = 0; at < 60; ++at) {
    std::filesystem::remove(path_);
    StateFile sut(path_);
    ASSERT_TRUE(sut.save("the first"));   // in the second slot
    ASSERT_TRUE(sut.save("the second"));  // in the first one
    damage(at);
    const auto text = sut.load();
    ASSERT_TRUE(text) << at;
    // 42 is the end of the line, 53 the padding
    EXPECT_TRUE(*text == "the first" || at == 42 || at >= 53) << at << " " << *text;
  }
}

TEST_F(StateFileTest, RefusesATextThatIsTooLong) {
  StateFile sut(path_);
  ASSERT_TRUE(sut.save("kept"));
  EXPECT_FALSE(sut.save(std::string(StateFile::longest + 1, 'x')));
  EXPECT_EQ(sut.load(), "kept");
}

TEST_F(StateFileTest, TakesAFileOfSomethingElseForNone) {
  for (const char* garbage : {"", "garbage", "ffffffffffffffff ffffffffffffffff ffffffff\n"}) {
    std::ofstream(path_) << garbage << std::string(1024, ' ');
    EXPECT_FALSE(StateFile(path_).load()) << garbage;
  }
  StateFile sut(path_);
  EXPECT_TRUE(sut.save("now"));
  EXPECT_EQ(sut.load(), "now");
}

TEST_F(StateFileTest, SaysWhenItCannotBeWritten) {
  EXPECT_FALSE(StateFile("/nowhere/state").save("x"));
  EXPECT_FALSE(StateFile("/dev/full").save("x"));  // a disk without room
}

TEST_F(StateFileTest, KeepsNothingWithoutAPath) {
  StateFile sut("");
  EXPECT_TRUE(sut.save("x"));
  EXPECT_FALSE(sut.load());
  EXPECT_FALSE(sut.keeps());
  EXPECT_TRUE(StateFile("/nowhere/file").keeps());
}

}  // namespace
}  // namespace tocsin
