// SPDX-License-Identifier: Apache-2.0
#include "page/page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "page/figure.hpp"
#include "page/html.hpp"
#include "page/toy_results.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The page of a toy experiment.
std::string page_of(const ToyResults& toy) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(write_page(toy.folder()), 0);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(), HasSubstr("report.html"));
  return toy.read("out/report.html");
}

/// The page of the toy experiment as it is; drawing it takes a second, so that tests share it.
struct Shared {
  ToyResults toy;
  std::string page = page_of(toy);
};
const Shared& shared() {
  static const Shared one;
  return one;
}

/// The page with real runs beside it.
const std::string& page_with_real_runs() {
  static const std::string page = [] {
    const ToyResults toy;
    toy.add_real();
    return page_of(toy);
  }();
  return page;
}

TEST(Page, IsWholeAndNeedsNothingElse) {
  const std::string& sut = shared().page;
  EXPECT_THAT(sut, AllOf(HasSubstr("</html>"), HasSubstr("<svg"), HasSubstr("0.1.0+toy")));
  EXPECT_THAT(sut, Not(HasSubstr("<!-- figure")));
  EXPECT_THAT(sut, Not(HasSubstr("src=")));
  EXPECT_TRUE(
      std::filesystem::exists(shared().toy.path("out/figures/fig43_main_a_near_camera_none.png")));
}

TEST(Page, IsTheSameEachTime) {
  const std::string first = shared().page;
  EXPECT_EQ(first, page_of(shared().toy));
}

TEST(Page, JudgesByTheIntervals) {
  const std::string& sut = shared().page;
  EXPECT_THAT(sut, HasSubstr("Mission A: TOCP-DSP <span class=\"yes\">beats</span> no policy on "
                             "probe_per_max: 52.0 against 72.0 %"));
  EXPECT_THAT(sut, HasSubstr("TOCP-DSP <span class=\"open\">does not beat</span> no policy on "
                             "high_latency_p99"));
}

TEST(Page, PutsTheThesisBesideOurs) {
  EXPECT_THAT(shared().page, HasSubstr("<td>TOCP-DSP</td><td>10.0</td><td>52.0 [49.5, 54.5]</td>"));
}

TEST(Page, DefinesEveryMetric) {
  const std::string& sut = shared().page;
  for (const MetricText& text : metric_texts()) {
    EXPECT_THAT(sut, HasSubstr(std::string("<td>") + text.name + "</td>"));
  }
}

TEST(Page, ComparesSimulatedAndRealWhenBothAreThere) {
  EXPECT_THAT(shared().page, Not(HasSubstr("Simulated against real")));
  EXPECT_THAT(page_with_real_runs(),
              AllOf(HasSubstr("Simulated against real"),
                    HasSubstr("mean QNI, all pairs, within 2.00 over at least 20 paired runs; "
                              "real minus simulated 1.00")));
}

TEST(Page, LeavesOutPairsOfMissionsThatWereNotDone) {
  EXPECT_THAT(page_with_real_runs(),
              AllOf(HasSubstr("pairs left out: none 1."), HasSubstr("over 11 pairs"),
                    HasSubstr("over 12 pairs"), HasSubstr("so far, over too few pairs")));
}

TEST(Page, ShowsSensitivityOfSetsOfThatKind) {
  const ToyResults toy(with(toy_text, "kind: thesis", "kind: sensitivity"));
  const std::string sut = page_of(toy);
  EXPECT_THAT(sut, HasSubstr("alpha=3 network_monitor.window=10"));
  EXPECT_THAT(sut, Not(HasSubstr("figures 43 to 52")));
}

TEST(Figure, DrawsLinesInOrder) {
  const std::string sut = Figure("f", "It's a title")
                              .axes("time [s]", "QNI [%]")
                              .line("one", {1, std::nan(""), 3}, 2)
                              .line("two", {4}, 2)
                              .script();
  EXPECT_THAT(sut, HasSubstr("$data0 << EOD\n0 1 \n2 NaN \n4 3 \nEOD\n"));
  EXPECT_THAT(sut, HasSubstr("set ylabel \"QNI [%]\" noenhanced"));
  EXPECT_THAT(sut, HasSubstr("title \"one\""));
  EXPECT_THAT(sut, HasSubstr("set title \"It's a title\""));
  EXPECT_THAT(sut, HasSubstr("set output \"f.svg\""));
}

TEST(Figure, DrawsEveryKindWithoutComplaint) {
  const TemporaryFolder folder;
  Figure figure("all", "All kinds");
  figure.axes("x", "y").band({1, 2}, {3, 4}, 1).line("", {2, 3}, 1);
  Figure boxes("boxes", "Boxes");
  figure.line("nothing", {NAN, NAN}, 1).points("", {}, {}).band({NAN}, {NAN}, 1);
  boxes.box("a", {1, 2, 3, 4}).box("none", {}).interval("i", 2, 1, 3).interval("n", 2, NAN, NAN);
  Figure empty("empty", "Nothing");
  Figure marks("marks", "Marks");
  marks.categories({"a", "b"}).marks("one", {{1, 0, 2, 3}, {2, NAN, NAN, 1}}, -0.2);
  marks.marks("none", {{NAN, NAN, NAN, 0}}, 0);
  try {
    draw({figure, boxes, empty, marks}, folder.path());
  } catch (const EnvironmentError& error) {
    ADD_FAILURE() << error.what();
  }
  EXPECT_THAT(folder.read("boxes.svg"), HasSubstr("</svg>"));
}

TEST(Figure, PutsMarksOfAPolicyBesideTheirCategories) {
  const std::string sut = Figure("m", "Marks")
                              .categories({"first", "second"})
                              .marks("one", {{5, 4, 6, 3}, {7, NAN, NAN, 1}}, 0.25)
                              .script();
  EXPECT_THAT(sut, HasSubstr("1.25 5 4 6 \n2.25 7 7 7 \nEOD"));
  EXPECT_THAT(sut, HasSubstr("\"first\" 1, \"second\" 2"));
}

TEST(Draw, SaysThatGnuplotFailed) {
  const TemporaryFolder folder;
  EXPECT_THROW(draw({Figure("bad", "Bad").with("no such command")}, folder.path()),
               EnvironmentError);
}

TEST(Html, EscapesWhatItIsGiven) {
  EXPECT_EQ(html::escape("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
}

TEST(Html, RoundsToThreeDigits) {
  EXPECT_EQ(html::number(1234.5), "1234");
  EXPECT_EQ(html::number(12.345), "12.3");
  EXPECT_EQ(html::number(1.2345), "1.23");
  EXPECT_EQ(html::number(-0.12345), "-0.123");
  EXPECT_EQ(html::number(std::nan("")), "-");
  EXPECT_EQ(html::number(Estimate{2, 1, 3, 5}), "2.00 [1.00, 3.00]");
  EXPECT_EQ(html::number(Estimate{2, std::nan(""), std::nan(""), 1}), "2.00");
}

}  // namespace
}  // namespace tocsin::experiment
