// SPDX-License-Identifier: Apache-2.0
// The cases of the OMG's DDS interoperability suite: `tocsin shapes` against the same program on
// Cyclone DDS, in both directions. All cases run beside each other, a domain for each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <future>
#include <sstream>
#include <thread>

#include "foundation/child_process.hpp"
#include "shape_cases.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::seconds;
using std::chrono::steady_clock;
using ::testing::IsEmpty;

/// Below 102, from where Linux may give a domain's ports to a participant of another domain.
constexpr int first_domain = 81;
constexpr int at_once = 6;  // small machines

/// One program of a case. Ended by SIGINT, as the suite does.
class Program {
 public:
  Program(Side side, const std::string& arguments, int domain) {
    ChildSetup setup;
    setup.command = {side == Side::ours ? TOCSIN_SHAPES : CYCLONE_SHAPES, "-d",
                     std::to_string(domain)};
    std::istringstream words(arguments);
    for (std::string word; words >> word;) setup.command.push_back(word);
    if (setup.command.back() == "--cft") setup.command.emplace_back("shapesize <= 20");
    setup.streams = ChildSetup::Streams::piped;
    child_ = start_child(setup);
  }
  ~Program() {
    ::kill(child_.pid, SIGKILL);
    (void)wait_for_child(child_.pid);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// The lines so far.
  const std::vector<std::string>& output() {
    std::array<char, 65536> bytes{};
    for (;;) {
      const auto count = ::read(child_.output.get(), bytes.data(), bytes.size());
      if (count == 0) ended_ = true;
      if (count <= 0) break;
      rest_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
      lines_.push_back(rest_.substr(0, end));
      rest_.erase(0, end + 1);
    }
    return lines_;
  }
  [[nodiscard]] bool has_ended() {
    (void)output();
    return ended_;
  }

 private:
  Child child_;
  std::string rest_;
  bool ended_ = false;
  std::vector<std::string> lines_;
};

bool comes_late(Check check) { return check == Check::first_kept || check == Check::first_gone; }

/// A case whose publisher ends by itself is over soon after it.
class Patience {
 public:
  [[nodiscard]] bool is_over(Program& publisher) {
    if (!publisher.has_ended()) return false;
    if (ended_ == steady_clock::time_point{}) ended_ = steady_clock::now();
    return steady_clock::now() > ended_ + seconds(3);
  }

 private:
  steady_clock::time_point ended_{};
};

std::vector<Code> awaited(const ShapeCase& its, Side publisher) {
  const Departure other = departure(its, publisher);
  return other.why.empty() ? its.expected : other.codes;
}

/// Runs a case until its subscriber has enough and has come to what is awaited, or for a minute,
/// and tells what its programs came to.
std::vector<Code> run(const ShapeCase& its, Side publisher, int domain) {
  const std::vector<Code> wanted = awaited(its, publisher);
  const Side other = publisher == Side::ours ? Side::cyclone : Side::ours;
  std::vector<std::unique_ptr<Program>> programs;
  for (std::size_t i = 0; i + 1 < its.apps.size(); ++i) {
    programs.push_back(std::make_unique<Program>(publisher, its.apps[i], domain));
  }
  if (comes_late(its.check)) {
    (void)within(seconds(10), [&] { return programs[0]->output().size() > 20; });
  }
  Program subscriber(other, its.apps.back(), domain);
  const bool expects_silence = wanted.back() == Code::data_not_received;
  Patience patience;
  const auto come_to = [&] {
    return code_of_subscriber(subscriber.output(), its.check, its.limit);
  };
  (void)within(expects_silence ? seconds(4) : seconds(60), [&] {
    return (is_enough(subscriber.output(), its.check) && come_to() == wanted.back()) ||
           patience.is_over(*programs[0]);
  });
  std::vector<Code> codes;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const bool prints = its.apps[i].find(" -w") != std::string::npos;
    const auto code = [&] { return code_of_publisher(programs[i]->output(), prints); };
    (void)within(seconds(15), [&] { return code() == wanted[i]; });
    codes.push_back(code());
  }
  codes.push_back(come_to());
  return codes;
}

std::string text_of(const std::vector<Code>& codes) {
  std::string text;
  for (const Code code : codes) text += (text.empty() ? "" : ", ") + std::string(word_of(code));
  return text;
}

std::string described(const ShapeCase& its, Side publisher) {
  std::string text = its.name + (publisher == Side::ours ? ", we publish" : ", Cyclone publishes");
  for (const std::string& app : its.apps) text += "\n  " + app;
  return text;
}

/// Empty: it came to what was awaited.
std::string failure(const ShapeCase& its, Side publisher, int domain) {
  const auto wanted = awaited(its, publisher);
  const auto codes = run(its, publisher, domain);
  if (codes == wanted) return "";
  return described(its, publisher) + "\n  came to " + text_of(codes) + " in place of " +
         text_of(wanted);
}

TEST(Shapes, EveryCaseOfTheSuiteComesToWhatIsAwaitedInBothDirections) {
  std::vector<std::pair<const ShapeCase*, Side>> runs;
  for (const ShapeCase& one : shape_cases()) {
    for (const Side side : {Side::ours, Side::cyclone}) runs.emplace_back(&one, side);
  }
  std::atomic<std::size_t> next{0};
  std::vector<std::string> failures(runs.size());
  const auto work = [&](int lane) {
    for (std::size_t i = next++; i < runs.size(); i = next++) {
      failures[i] = failure(*runs[i].first, runs[i].second, first_domain + lane);
    }
  };
  std::vector<std::thread> lanes;
  for (int lane = 0; lane < at_once; ++lane) lanes.emplace_back(work, lane);
  for (std::thread& lane : lanes) lane.join();
  for (const std::string& one : failures) EXPECT_EQ(one, "");
}

TEST(Shapes, WhatFastDdsDoesNotHaveIsSaidAsTheSuiteWantsIt) {
  for (const char* arguments :
       {"-P -t Square -x 2", "-S -t Square -D t", "-P -t Square -D p", "-S -t Square --ordered",
        "-P -t Square --coherent --access-scope g"}) {
    Program sut(Side::ours, arguments, first_domain + at_once);
    EXPECT_TRUE(eventually([&] {
      return code_of_publisher(sut.output(), false) == Code::unsupported;
    })) << arguments;
  }
}

}  // namespace
}  // namespace tocsin::interop
