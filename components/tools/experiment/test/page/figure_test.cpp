// SPDX-License-Identifier: Apache-2.0
// The gnuplot program of each kind of figure, the document that holds them, and HTML.
#include "page/figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "page/document.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Figure figure() { return {"name", "Title"}; }
std::string script(const Figure& figure) { return figure.script(); }

TEST(FigureScript, WritesBothKindsOfFile) {
  const std::string sut = script(figure());
  EXPECT_THAT(sut, AllOf(HasSubstr("set terminal svg"), HasSubstr("set output \"name.svg\""),
                         HasSubstr("set terminal pngcairo"), HasSubstr("set output \"name.png\""),
                         HasSubstr("unset output\n")));
}

TEST(FigureScript, BeginsAnewForEachFigure) {
  EXPECT_EQ(script(figure()).rfind("reset session\n", 0), 0U);
}

TEST(FigureScript, DrawsAnEmptyPlotOfNothing) {
  EXPECT_THAT(script(figure()), HasSubstr("plot [0:1] [0:1] 2 notitle"));
  EXPECT_THAT(script(figure().line("", {NAN, NAN}, 1)), HasSubstr("plot [0:1] [0:1] 2 notitle"));
}

TEST(FigureScript, NamesAxesWithTheirQuotes) {
  const std::string sut = script(figure().axes("time's [s]", "QNI [%]"));
  EXPECT_THAT(sut, HasSubstr("set xlabel \"time's [s]\" noenhanced\n"));
  EXPECT_THAT(sut, HasSubstr("set ylabel \"QNI [%]\" noenhanced\n"));
}

TEST(FigureScript, HasNoNameOfAnAxisThatHasNone) {
  EXPECT_THAT(script(figure().axes("", "y")), Not(HasSubstr("xlabel")));
}

TEST(FigureScript, TakesCommandsAsTheyAre) {
  EXPECT_THAT(script(figure().with("set logscale y")), HasSubstr("\nset logscale y\n"));
}

TEST(FigureLine, HasAPointEachStepAndAGapWhereNothingIs) {
  EXPECT_THAT(script(figure().line("one", {5, NAN, 7}, 6)),
              HasSubstr("$data0 << EOD\n0 5 \n6 NaN \n12 7 \nEOD\n"));
}

TEST(FigureLine, IsInTheLegendOnlyWithATitle) {
  EXPECT_THAT(script(figure().line("one", {1}, 1)), HasSubstr(" title \"one\""));
  EXPECT_THAT(script(figure().line("", {1}, 1)), HasSubstr(" notitle"));
}

TEST(FigureLine, HasAColourOfItsOwn) {
  const std::string sut = script(figure().line("a", {1}, 1).line("b", {2}, 1));
  EXPECT_THAT(sut, AllOf(HasSubstr("lc rgb '#0072b2' title \"a\""),
                         HasSubstr("lc rgb '#d55e00' title \"b\"")));
}

TEST(FigureLine, TakesTheFirstColourAgainAfterTheLast) {
  Figure sut = figure();
  for (int i = 0; i < 8; ++i) sut.line("line " + std::to_string(i), {1}, 1);
  EXPECT_THAT(script(sut), HasSubstr("lc rgb '#0072b2' title \"line 7\""));
}

TEST(FigureBand, IsInTheColourOfTheLineThatFollows) {
  const std::string sut = script(figure().band({1, 2}, {3, 4}, 10).line("one", {2, 3}, 10));
  EXPECT_THAT(sut, HasSubstr("0 1 3 \n10 2 4 \n"));
  EXPECT_THAT(sut, HasSubstr("noborder lc rgb '#0072b2' notitle"));
  EXPECT_THAT(sut, HasSubstr("lc rgb '#0072b2' title \"one\""));
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

TEST(FigureLabels, AreTurnedWhenTheyAreMany) {
  const std::vector<std::string> five(5, "label");
  const std::vector<std::string> six(6, "label");
  EXPECT_THAT(script(figure().categories(five)), Not(HasSubstr("rotate")));
  EXPECT_THAT(script(figure().categories(six)), HasSubstr("rotate by -30"));
}

TEST(FigureLabels, LeaveRoomOnBothSides) {
  EXPECT_THAT(script(figure().categories({"a", "b"})), HasSubstr("set xrange [0.3:2.7]"));
}

TEST(FigureMarks, LeaveOutACategoryWithoutAMean) {
  const std::string sut =
      script(figure().categories({"a", "b"}).marks("one", {{NAN, NAN, NAN, 0}, {3, 2, 4, 9}}, 0));
  EXPECT_THAT(sut, HasSubstr("<< EOD\n2 3 2 4 \nEOD"));
}

TEST(FigureMarks, OfNothingTakeNoColour) {
  const std::string sut = script(figure()
                                     .categories({"a"})
                                     .marks("one", {{NAN, NAN, NAN, 0}}, 0)
                                     .marks("two", {{3, 2, 4, 9}}, 0));
  EXPECT_THAT(sut, Not(HasSubstr("title \"one\"")));
  EXPECT_THAT(sut, HasSubstr("lc rgb '#0072b2' title \"two\""));
}

TEST(FigurePoints, ArePairs) {
  const std::string sut = script(figure().points("", {1, 2}, {3, 4}).diagonal());
  EXPECT_THAT(sut, HasSubstr("<< EOD\n1 3 \n2 4 \nEOD"));
  EXPECT_THAT(sut, HasSubstr("x with lines"));
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

TEST(HtmlPage, EscapesItsTitleAndNotItsBody) {
  const std::string sut = html::page("a & b", "<p>x</p>");
  EXPECT_THAT(sut, AllOf(HasSubstr("<title>a &amp; b</title>"), HasSubstr("<body>\n<p>x</p>")));
  EXPECT_EQ(sut.rfind("<!DOCTYPE html>", 0), 0U);
}

TEST(HtmlDetails, HideWhatIsInside) {
  EXPECT_EQ(html::details("a < b", "<p>x</p>"),
            "<details><summary>a &lt; b</summary>\n<p>x</p></details>\n");
  EXPECT_EQ(html::preformatted("a < b"), "<pre>a &lt; b</pre>\n");
}

}  // namespace
}  // namespace tocsin::experiment
