// SPDX-License-Identifier: Apache-2.0
// The gnuplot program of each kind of figure, the document that holds them, and HTML.
#include "page/figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "page/document.hpp"
#include "report/gnuplot.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Figure figure() { return {"name", "Title"}; }
std::string script(const Figure& figure) { return figure.script(); }

TEST(FigureScript, IsDrawnByGnuplotAsBothKindsOfFile) {
  const TemporaryFolder folder;
  const std::string texts = script(figure().axes("time's [s]", "QNI \"%\"").line("a`b", {1, 2}, 1));
  try {
    report::run_gnuplot(texts + script(Figure("empty", "Nothing")), folder.path());
  } catch (const EnvironmentError& error) {
    GTEST_SKIP() << error.what();
  }
  EXPECT_THAT(folder.read("name.svg"), AllOf(HasSubstr("time's [s]"), HasSubstr("a`b")));
  EXPECT_NE(folder.read("name.png"), "");
  EXPECT_NE(folder.read("empty.svg"), "") << "a plot of nothing is drawn, too";
}

TEST(FigureLine, HasAPointEachStepAndAGapWhereNothingIs) {
  EXPECT_THAT(script(figure().line("one", {5, NAN, 7}, 6)),
              HasSubstr("$data0 << EOD\n0 5 \n6 NaN \n12 7 \nEOD\n"));
}

TEST(FigureBand, EndsWithTheShorterOfItsBounds) {
  EXPECT_THAT(script(figure().band({1, 2, 3}, {4}, 1)), HasSubstr("<< EOD\n0 1 4 \nEOD"));
}

TEST(FigureBand, IsNoneWithoutBounds) {
  EXPECT_THAT(script(figure().band({NAN}, {1}, 1)), Not(HasSubstr("filledcurves")));
  EXPECT_THAT(script(figure().band({1}, {NAN}, 1)), Not(HasSubstr("filledcurves")));
}

TEST(FigureBox, HasQuartilesMedianAndWhiskersByNearestRank) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  // Place, 25 %, 5 %, 95 %, 75 %, median.
  EXPECT_THAT(script(figure().box("a", values)), HasSubstr("<< EOD\n1 25 5 95 75 50 \nEOD"));
}

TEST(FigureBox, LeavesOutRunsWithoutAnAnswer) {
  EXPECT_THAT(script(figure().box("a", {NAN, 4, NAN})), HasSubstr("<< EOD\n1 4 4 4 4 4 \nEOD"));
}

TEST(FigureBox, KeepsThePlaceOfAPolicyWithoutValues) {
  const std::string sut = script(figure().box("none", {}).box("b", {4}));
  EXPECT_THAT(sut, HasSubstr("\"none\" 1, \"b\" 2"));
  EXPECT_THAT(sut, HasSubstr("<< EOD\n2 4 4 4 4 4 \nEOD"));
}

TEST(FigureInterval, IsAMeanWithItsBounds) {
  EXPECT_THAT(script(figure().interval("a", 5, 4, 7)), HasSubstr("<< EOD\n1 5 4 7 \nEOD"));
}

TEST(FigureInterval, IsAPointWithoutBoundsAndNothingWithoutMean) {
  EXPECT_THAT(script(figure().interval("a", 5, NAN, NAN)), HasSubstr("<< EOD\n1 5 5 5 \nEOD"));
  EXPECT_THAT(script(figure().interval("a", NAN, NAN, NAN)), Not(HasSubstr("EOD")));
}

TEST(FigureMarks, LeaveOutACategoryWithoutAMean) {
  const std::string sut =
      script(figure().categories({"a", "b"}).marks("one", {{NAN, NAN, NAN, 0}, {3, 2, 4, 9}}, 0));
  EXPECT_THAT(sut, HasSubstr("<< EOD\n2 3 2 4 \nEOD"));
}

TEST(FigurePoints, ArePairs) {
  const std::string sut = script(figure().points("", {1, 2}, {3, 4}).diagonal());
  EXPECT_THAT(sut, HasSubstr("<< EOD\n1 3 \n2 4 \nEOD"));
}

TEST(FigurePoints, AreNoneWithoutOneCoordinate) {
  EXPECT_THAT(script(figure().points("", {1}, {NAN})), Not(HasSubstr("EOD")));
}

TEST(DocumentTest, KeepsTheOrderOfTextAndFigures) {
  Document sut;
  sut.heading(2, "One & two");
  sut.figure(figure(), "A caption.");
  sut.paragraph("After <i>it</i>.");
  EXPECT_EQ(sut.text(),
            "<h2>One &amp; two</h2>\n<figure><!-- figure name --><figcaption>A caption."
            "</figcaption></figure>\n<p>After <i>it</i>.</p>\n");
  ASSERT_EQ(sut.figures().size(), 1U);
  EXPECT_EQ(sut.figures()[0].title(), "Title");
}

TEST(DocumentTest, PutsTheDrawingInWithoutItsXmlHead) {
  const TemporaryFolder folder;
  folder.write("name.svg", "<?xml version=\"1.0\"?>\n<svg>drawn</svg>\n");
  Document sut;
  sut.figure(figure(), "c");
  EXPECT_THAT(sut.body(folder.path()),
              AllOf(HasSubstr("<figure><svg>drawn</svg>\n<figcaption>c"), Not(HasSubstr("xml"))));
}

TEST(DocumentTest, SaysWhichFigureWasNotDrawn) {
  const TemporaryFolder folder;
  Document sut;
  sut.figure(figure(), "c");
  try {
    (void)sut.body(folder.path());
    FAIL() << "no error";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("name.svg: gnuplot has not drawn it"));
  }
}

TEST(HtmlTable, HasHeadsInItsFirstRowOnly) {
  EXPECT_EQ(html::table({{"a", "b"}, {"1", "2"}}),
            "<table>\n<tr><th>a</th><th>b</th></tr>\n<tr><td>1</td><td>2</td></tr>\n</table>\n");
}

TEST(HtmlTable, BreaksProseButNotMarkup) {
  const std::string prose(61, 'x');
  EXPECT_THAT(html::table({{"h"}, {prose}}), HasSubstr("<td class=\"text\">" + prose));
  EXPECT_THAT(html::table({{"h"}, {prose.substr(1)}}), HasSubstr("<td>x"));
  EXPECT_THAT(html::table({{"h"}, {"<b>" + prose + "</b>"}}), HasSubstr("<td><b>"));
}

TEST(HtmlNumber, HasThreeDigitsAtEachSize) {
  EXPECT_EQ(html::number(0), "0");
  EXPECT_EQ(html::number(0.9994), "0.999");
  EXPECT_EQ(html::number(1), "1.00");
  EXPECT_EQ(html::number(9.99), "9.99");
  EXPECT_EQ(html::number(10), "10.0");
  EXPECT_EQ(html::number(99.9), "99.9");
  EXPECT_EQ(html::number(100), "100");
  EXPECT_EQ(html::number(-100), "-100");
  EXPECT_EQ(html::number(HUGE_VAL), "-");
}

}  // namespace
}  // namespace tocsin::experiment
