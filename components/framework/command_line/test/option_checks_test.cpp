// SPDX-License-Identifier: Apache-2.0
#include "command_line/option_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

/// A program of two verbs; `launch` has options.
struct Toy {
  Toy() {
    app.require_subcommand(1);
    CLI::App* const launch = app.add_subcommand("launch");
    launch->add_option("--seed", seed)->check(is_seed());
    launch->add_option("--rate", rate)->check(above_zero());
    launch->add_option("--delay", delay)->check(at_least_zero());
    app.add_subcommand("report");
  }
  /// "accepted", or why not.
  std::string answer(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());
    try {
      app.parse(words);
      return "accepted";
    } catch (const CLI::ParseError& error) {
      return usage_error(app, error);
    }
  }

  CLI::App app{"A toy", "toy"};
  int seed = 0;
  double rate = 1;
  double delay = 0;
};

std::string answer(const std::vector<std::string>& words) { return Toy().answer(words); }

TEST(OptionChecks, ASeedIsAWholeNumberFromZero) {
  EXPECT_EQ(answer({"launch", "--seed", "0"}), "accepted");
  EXPECT_EQ(answer({"launch", "--seed", "2147483647"}), "accepted");
  for (const char* wrong : {"-1", "1.5", "x", "2147483648", ""}) {
    EXPECT_EQ(answer({"launch", "--seed", wrong}),
              std::string("--seed: '") + wrong + "' is not a whole number from 0 to 2147483647");
  }
}

TEST(OptionChecks, NumbersAreRefusedInALineThatSaysWhatIsAllowed) {
  EXPECT_EQ(answer({"launch", "--rate", "1e-300"}), "accepted");
  EXPECT_EQ(answer({"launch", "--delay", "0"}), "accepted");
  EXPECT_EQ(answer({"launch", "--rate", "0"}), "--rate: '0' is not a number above 0");
  EXPECT_EQ(answer({"launch", "--delay", "-0.1"}),
            "--delay: '-0.1' is not a number from 0 upwards");
  EXPECT_EQ(answer({"launch", "--delay", "soon"}),
            "--delay: 'soon' is not a number from 0 upwards");
}

TEST(UsageError, AMisspeltOptionIsShownWithWhatIsLikeIt) {
  EXPECT_EQ(answer({"launch", "--sed", "1"}),
            "--sed: there is no such option; did you mean '--seed'?");
  EXPECT_EQ(answer({"launch", "--rtae=3"}),
            "--rtae: there is no such option; did you mean '--rate'?");
  EXPECT_EQ(answer({"launch", "--colour"}), "--colour: there is no such option; --help lists them");
}

TEST(UsageError, AMisspeltVerbIsShownWithWhatIsLikeIt) {
  EXPECT_EQ(answer({"lanch"}), "'lanch' is not a verb; did you mean 'launch'?");
  EXPECT_EQ(answer({"fly"}), "'fly' is not a verb; the verbs are: launch, report");
}

}  // namespace
}  // namespace tocsin
