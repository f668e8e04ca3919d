// SPDX-License-Identifier: Apache-2.0
#include "sample_log/consumer.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::sample_log {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using From = LogStart::From;

constexpr Time now{std::chrono::hours(1)};
constexpr std::int64_t wall_ns = 1'700'000'000'000'000'000;

class ConsumerTest : public ::testing::Test {
 protected:
  ConsumerTest() : log_(files_, {}, Instant{now, wall_ns}, LogUse::history) {
    log_.add({"odom", "/odom", {0, "some_msgs/msg/Type", "", ""}, {}});
    log_.add({"arm", "/arm/state", {0, "some_msgs/msg/Type", "", ""}, {}});
  }
  void append(std::uint64_t first, std::uint64_t last, const std::string& stream = "odom") {
    for (std::uint64_t i = first; i <= last; ++i) {
      (void)log_.append({{{stream_key(stream), 7, i}, 1000, {1, 2}}}, {now, wall_ns});
    }
  }
  [[nodiscard]] std::unique_ptr<Consumer> consumer(const std::string& name,
                                                   const std::string& topic = "/odom",
                                                   const LogStart& start = {
                                                       From::beginning}) const {
    return std::make_unique<Consumer>(folder_.path("log"), ConsumerName{topic, name}, start);
  }
  static std::vector<std::uint64_t> read(Consumer& from, std::size_t most = 1000) {
    std::vector<std::uint64_t> sequences;
    for (const LogSample& one : from.read(most)) sequences.push_back(one.id.sequence);
    return sequences;
  }
  [[nodiscard]] std::string error_of(const std::string& name) const {
    try {
      (void)consumer(name);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
  FolderFiles files_{folder_.path("log")};
  SampleLog log_;
};

TEST_F(ConsumerTest, GoesOnWhereItsNameHasCommitted) {
  append(1, 5);
  {
    const auto first = consumer("plot");
    EXPECT_FALSE(first->is_back());
    EXPECT_THAT(read(*first, 2), ElementsAre(1, 2));
    EXPECT_TRUE(first->commit());
    EXPECT_THAT(read(*first, 1), ElementsAre(3)) << "given, and not done with";
  }
  append(6, 6);
  const auto sut = consumer("plot");
  EXPECT_TRUE(sut->is_back());
  EXPECT_THAT(read(*sut), ElementsAre(3, 4, 5, 6));
  EXPECT_FALSE(sut->take_gap());
}

TEST_F(ConsumerTest, ANewNameMissesNothingFromItsFirstMomentOn) {
  append(1, 3);
  (void)consumer("plot", "/odom", {});
  append(4, 5);
  EXPECT_THAT(read(*consumer("plot", "/odom", {})), ElementsAre(4, 5));
}

TEST_F(ConsumerTest, IsOneProcessAtATime) {
  const auto first = consumer("plot");
  EXPECT_THAT(error_of("plot"), HasSubstr("another process is plot of /odom"));
  EXPECT_THAT(error_of("fit"), IsEmpty());
}

TEST_F(ConsumerTest, RefusesANameThatIsNone) {
  for (const char* const name : {"a/b", "..", "a b", "\xc3\xa4"}) {
    EXPECT_THAT(error_of(name), HasSubstr("is no name")) << name;
  }
  EXPECT_THAT(error_of(std::string(64, 'a')), IsEmpty());
  EXPECT_THAT(error_of(std::string(65, 'a')), HasSubstr("is no name"));
}

/// How many came twice; a test fails where one is missing.
int count_twice(const std::vector<std::uint64_t>& handled) {
  int twice = 0;
  EXPECT_EQ(handled.front(), 1U);
  for (std::size_t i = 1; i < handled.size(); ++i) {
    EXPECT_TRUE(handled[i] == handled[i - 1] || handled[i] == handled[i - 1] + 1)
        << handled[i - 1] << " was followed by " << handled[i];
    if (handled[i] == handled[i - 1]) ++twice;
  }
  return twice;
}

/// A consumer that handles each sample and commits it, and is killed again and again at any
/// instant: what it handled is all there is, and only the last sample of a life may come twice.
TEST_F(ConsumerTest, KilledAtAnyInstantItMissesNothing) {
  constexpr std::uint64_t all = 3000;
  constexpr int lives = 20;
  append(1, all);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::vector<std::uint64_t> handled;
  for (int life = 0; life < lives && (handled.empty() || handled.back() != all); ++life) {
    const pid_t child = ::fork();
    if (child == 0) {
      const auto sut = consumer("plot");
      for (;;) {
        for (const std::uint64_t one : read(*sut, 1)) {
          if (::write(ends[1], &one, sizeof one) != sizeof one) ::_exit(1);
        }
        (void)sut->commit();
      }
    }
    const std::size_t enough = handled.size() + 50 + 7 * static_cast<std::size_t>(life);
    std::uint64_t one = 0;
    while (handled.size() < enough && ::read(ends[0], &one, sizeof one) == sizeof one) {
      handled.push_back(one);
      if (one == all) break;
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    // What it had handled before it died.
    const std::uint64_t end = 0;
    ASSERT_EQ(::write(ends[1], &end, sizeof end), static_cast<ssize_t>(sizeof end));
    while (::read(ends[0], &one, sizeof one) == sizeof one && one != 0) handled.push_back(one);
  }
  ::close(ends[0]);
  ::close(ends[1]);
  EXPECT_LE(count_twice(handled), lives);
}

}  // namespace
}  // namespace tocsin::sample_log
