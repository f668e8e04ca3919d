// SPDX-License-Identifier: Apache-2.0
#include "report/gnuplot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::report {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::string& script, const std::string& folder) {
  try {
    run_gnuplot(script, folder);
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "no error";
}

class GnuplotTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (error_of("", folder_.path()) != "no error") GTEST_SKIP() << "no gnuplot";
  }
  TemporaryFolder folder_;
};

TEST(GnuplotText, IsAWordWhateverItHolds) {
  EXPECT_EQ(gnuplot_text("QNI [%]"), "\"QNI [%]\"");
  EXPECT_EQ(gnuplot_text("it's \"a\\b\""), "\"it's \\\"a\\\\b\\\"\"");
  EXPECT_EQ(gnuplot_text("a\nb`"), "\"a b\\140\"");
}

TEST(GnuplotColour, DiffersFromItsNeighboursAndNeverEnds) {
  EXPECT_EQ(gnuplot_colour(0), "rgb '#0072b2'");
  EXPECT_NE(gnuplot_colour(0), gnuplot_colour(1));
  EXPECT_EQ(gnuplot_colour(7), gnuplot_colour(0));
}

TEST_F(GnuplotTest, RunsAScriptInAFolderWhoseNameNeedsQuotes) {
  (void)folder_.write("it's here/points.dat", "0 0\n1 1\n");
  run_gnuplot("set terminal svg\nset output 'a.svg'\nplot 'points.dat'\n",
              folder_.path("it's here"));
  EXPECT_THAT(folder_.read("it's here/a.svg"), HasSubstr("<svg"));
}

TEST_F(GnuplotTest, TellsWhatGnuplotSaid) {
  EXPECT_THAT(error_of("plot 'none.dat'\n", folder_.path()), HasSubstr("none.dat"));
}

TEST_F(GnuplotTest, ATextIsDrawnAndNeverRun) {
  for (const char* text :
       {"`echo a >made`", "'; system 'echo a >made' #", "\"; system \"echo a >made\" #"}) {
    run_gnuplot("set terminal svg\nset output 'a.svg'\nset title " + gnuplot_text(text) +
                    " noenhanced\nplot x\n",
                folder_.path());
    EXPECT_EQ(folder_.read("made"), "") << text;
    EXPECT_THAT(folder_.read("a.svg"), HasSubstr("echo a >made")) << text;
  }
  run_gnuplot("set title \"`echo a >made`\"\n", folder_.path());
  EXPECT_EQ(folder_.read("made"), "a\n") << "it is needed: gnuplot runs it when it stands bare";
}

}  // namespace
}  // namespace tocsin::report
