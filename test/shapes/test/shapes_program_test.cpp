// SPDX-License-Identifier: Apache-2.0
// The program as the suite starts it. What it prints beside another one: shapes_test of
// test/interop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include "foundation/child_process.hpp"
#include "plain_reader.hpp"

namespace tocsin::shapes {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

class Program {
 public:
  Program(const std::string& arguments, int domain) {
    ChildSetup setup;
    setup.command = {SHAPES_PROGRAM, "-d", std::to_string(domain)};
    std::istringstream words(arguments);
    for (std::string word; words >> word;) setup.command.push_back(word);
    setup.streams = ChildSetup::Streams::piped;
    child_ = start_child(setup);
  }
  ~Program() { (void)end(); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] std::string output() {
    std::array<char, 65536> bytes{};
    for (auto count = ::read(child_.output.get(), bytes.data(), bytes.size()); count > 0;
         count = ::read(child_.output.get(), bytes.data(), bytes.size())) {
      text_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text_;
  }
  /// Ends it as the suite does; its exit code.
  int end() {
    if (child_.pid <= 0) return code_;
    ::kill(child_.pid, SIGINT);
    return wait();
  }
  int wait() {
    code_ = wait_for_child(child_.pid);
    child_.pid = -1;
    return code_;
  }

 private:
  Child child_;
  std::string text_;
  int code_ = -1;
};

/// Takes until `is_over` holds; whether it came to hold.
template <class Condition>
bool take_until(PlainReader& reader, const Condition& is_over) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(15);
  while (!is_over()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    reader.take_all();
  }
  return true;
}

TEST(ShapesProgram, APublisherThatEndsLeavesNoInstanceAliveAtAReaderOfFastDds) {
  PlainReader reader(225, "Square");
  Program publisher("-P -t Square -r -c RED --num-instances 2", 225);
  ASSERT_TRUE(take_until(reader, [&] { return reader.samples() >= 4; }));
  EXPECT_EQ(publisher.end(), 0);
  EXPECT_TRUE(take_until(reader, [&] { return reader.ends().size() >= 2; }));
  EXPECT_THAT(reader.ends(), Each(dds::NOT_ALIVE_NO_WRITERS_INSTANCE_STATE));
}

TEST(ShapesProgram, ExitCodesAreThoseOfShapeMain) {
  EXPECT_EQ(Program("-P", 224).wait(), 1);
  EXPECT_EQ(Program("-S -t Square --cft x", 224).wait(), 1);
  Program unsupported("-P -t Square --coherent", 224);
  EXPECT_EQ(unsupported.wait(), 2);
  EXPECT_THAT(unsupported.output(), HasSubstr("not supported"));
}

}  // namespace
}  // namespace tocsin::shapes
