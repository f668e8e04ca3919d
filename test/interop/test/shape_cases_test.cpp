// SPDX-License-Identifier: Apache-2.0
// How a case's output is judged.
#include "shape_cases.hpp"

#include <gtest/gtest.h>

namespace tocsin::interop {
namespace {

using Lines = std::vector<std::string>;

/// The output of a subscriber with samples of these sizes.
Lines samples(const std::vector<int>& sizes, const char* color = "BLUE") {
  Lines lines{"Create topic: Square", "Create reader for topic: Square"};
  for (const int size : sizes) {
    lines.push_back(std::string("Square     ") + color + "       001 002 [" + std::to_string(size) +
                    "]");
  }
  return lines;
}

Code judged(const std::vector<int>& sizes, Check check) {
  return code_of_subscriber(samples(sizes), check);
}

TEST(ShapeCases, APublisherIsJudgedByTheStepsItReached) {
  EXPECT_EQ(code_of_publisher({}, false), Code::not_created);
  Lines lines{"Create topic: Square", "Create writer for topic: Square color: BLUE"};
  EXPECT_EQ(code_of_publisher(lines, false), Code::reader_not_matched);
  lines.emplace_back("on_publication_matched() topic: 'Square'");
  EXPECT_EQ(code_of_publisher(lines, false), Code::ok);
  lines.emplace_back("on_offered_deadline_missed() topic: 'Square'");
  EXPECT_EQ(code_of_publisher(lines, false), Code::ok);
  EXPECT_EQ(code_of_publisher(lines, true), Code::deadline_missed);
  EXPECT_EQ(code_of_publisher({"   x = not supported"}, false), Code::unsupported);
}

TEST(ShapeCases, ASubscriberIsJudgedByItsSamples) {
  EXPECT_EQ(code_of_subscriber({}, Check::received), Code::not_created);
  EXPECT_EQ(judged({}, Check::received), Code::data_not_received);
  EXPECT_EQ(judged({20}, Check::received), Code::ok);
  EXPECT_EQ(judged({3, 4, 9}, Check::in_order), Code::ok);
  EXPECT_EQ(judged({3, 5, 4}, Check::in_order), Code::data_not_correct);
  EXPECT_EQ(judged({3, 4, 5}, Check::no_losses), Code::ok);
  EXPECT_EQ(judged({3, 4, 6}, Check::no_losses), Code::data_not_correct);
  EXPECT_EQ(judged({3, 4, 4}, Check::no_losses), Code::data_not_correct);
  EXPECT_EQ(judged({1, 20}, Check::at_most_20), Code::ok);
  EXPECT_EQ(judged({1, 21}, Check::at_most_20), Code::data_not_correct);
  EXPECT_EQ(judged({1, 2}, Check::first_kept), Code::ok);
  EXPECT_EQ(judged({2, 3}, Check::first_kept), Code::data_not_correct);
  EXPECT_EQ(judged({2, 3}, Check::first_gone), Code::ok);
  EXPECT_EQ(judged({1, 2}, Check::first_gone), Code::data_not_correct);
}

/// A sample of this size, with its stamp and when it was read.
struct Stamped {
  int size;
  int stamp_ms;
  int read_ms;
};

Code judged(const std::vector<Stamped>& all, Check check, int limit) {
  Lines lines = samples({});
  for (const Stamped& one : all) {
    lines.push_back("Square BLUE 001 002 [" + std::to_string(one.size) + "] @" +
                    std::to_string(one.stamp_ms) + "000000 " + std::to_string(one.read_ms) +
                    "000000");
  }
  lines.insert(lines.begin(), "Create reader for topic: Square");
  return code_of_subscriber(lines, check, limit);
}

struct Judged {
  Check check;
  int limit;
  Code code;
};
constexpr Judged apart{Check::separated, 1000, Code::ok};
constexpr Judged not_apart{Check::separated, 1000, Code::data_not_correct};
constexpr Judged brief{Check::short_lived, 250, Code::ok};
constexpr Judged not_brief{Check::short_lived, 250, Code::data_not_correct};
constexpr Judged newest{Check::newest_kept, 2, Code::ok};
constexpr Judged not_newest{Check::newest_kept, 2, Code::data_not_correct};

struct Row {
  const char* what;
  Judged as;
  std::vector<Stamped> seen;
};
const Row rows[] = {
    {"late writer", apart, {{1, 0, 1}, {2, 9, 9}, {11, 1009, 1009}, {14, 2500, 2501}}},
    {"too close", not_apart, {{1, 0, 1}, {2, 9, 9}, {11, 1008, 1009}}},
    {"nothing dropped", not_apart, {{1, 0, 1}, {2, 9, 9}, {3, 1009, 1009}}},
    {"a run of one", brief, {{1, 0, 90}, {5, 400, 500}, {8, 800, 1000}, {9, 900, 1000}}},
    {"too old", not_brief, {{1, 0, 90}, {5, 400, 500}, {8, 624, 1000}, {9, 900, 1000}}},
    {"one late in twelve",
     brief,
     {{1, 0, 90},
      {5, 400, 500},
      {6, 500, 550},
      {10, 900, 1300},
      {15, 1400, 1500},
      {16, 1500, 1550},
      {20, 1900, 2000},
      {21, 2000, 2050},
      {25, 2400, 2500},
      {26, 2500, 2550},
      {30, 2900, 3000},
      {31, 3000, 3050}}},
    {"none expired", not_brief, {{1, 0, 90}, {2, 80, 90}, {3, 380, 500}, {4, 480, 500}}},
    {"never two", not_brief, {{1, 0, 90}, {5, 400, 500}, {8, 900, 1000}}},
    {"a full history", newest, {{1, 0, 1}, {2, 50, 51}, {5, 200, 400}, {6, 250, 400}}},
    {"a loss", not_newest, {{1, 0, 1}, {2, 50, 51}, {5, 200, 400}}},
};

TEST(ShapeCases, CasesOfTimeAreJudgedByStamps) {
  for (const Row& row : rows) {
    EXPECT_EQ(judged(row.seen, row.as.check, row.as.limit), row.as.code) << row.what;
  }
}

TEST(ShapeCases, SizesAndColoursTellHowManyPublishersAreHeard) {
  EXPECT_EQ(judged({20, 20, 20, 30}, Check::sizes), Code::receiving_from_one)
      << "the weaker one was heard before the stronger was known";
  EXPECT_EQ(judged({20, 30, 20, 30}, Check::sizes), Code::receiving_from_both);
  EXPECT_EQ(judged({1, 2}, Check::colors), Code::receiving_from_one);
  Lines both = samples({1});
  const Lines red = samples({1}, "RED");
  both.insert(both.end(), red.begin(), red.end());
  EXPECT_EQ(code_of_subscriber(both, Check::colors), Code::receiving_from_both);
}

TEST(ShapeCases, TheEndsOfAllInstancesAreWanted) {
  Lines lines = samples({1});
  for (int i = 0; i < 3; ++i) lines.emplace_back("Square BLUE NOT_ALIVE_DISPOSED_INSTANCE_STATE");
  EXPECT_EQ(code_of_subscriber(lines, Check::disposed), Code::data_not_correct);
  EXPECT_FALSE(is_enough(lines, Check::disposed));
  lines.emplace_back("Square BLUE3 NOT_ALIVE_DISPOSED_INSTANCE_STATE");
  EXPECT_EQ(code_of_subscriber(lines, Check::disposed), Code::ok);
  EXPECT_TRUE(is_enough(lines, Check::disposed));
}

TEST(ShapeCases, EveryCaseHasACodeForEachOfItsPrograms) {
  EXPECT_EQ(shape_cases().size(), 48U);
  for (const ShapeCase& one : shape_cases()) {
    EXPECT_EQ(one.apps.size(), one.expected.size()) << one.name;
  }
}

}  // namespace
}  // namespace tocsin::interop
