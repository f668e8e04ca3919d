// SPDX-License-Identifier: Apache-2.0
// The page that report/ makes of a folder of results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "command_line/run_to_end.hpp"
#include "report/toy_results.hpp"

namespace tocsin::experiment {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Ended python(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"/usr/bin/python3", "-B"});
  return run_to_end(arguments, {"", "/"});
}

Ended report(const std::string& folder) { return python({TOCSIN_SOURCE_DIR "/report", folder}); }

std::string page_of(const ToyResults& toy) {
  const Ended ended = report(toy.folder());
  EXPECT_EQ(ended.code, 0) << ended.output;
  return toy.read("out/report.html");
}

/// One set of each kind, two fits; with real runs, the first of which was not done.
const std::string every_kind =
    "fits: 2\n" + std::string(toy_text) +
    "  - {name: all, title: More, missions: [a], payloads: [camera], seeds: 2}\n"
    "  - {name: swept, kind: sensitivity, title: Sensitivity, missions: [a], payloads: [camera], "
    "seeds: 2}\n";

/// The headings, verdicts and rows of tables of the page, without definitions and settings.
std::string told_by(const std::string& page) {
  const std::regex part("<(h2|h3|li|th|td)( class=\"text\")?>([^]*?)</\\1>");
  std::string text;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t picture = std::min(page.find("<svg", at), page.size());
    const std::string piece = page.substr(at, picture - at);
    for (std::sregex_iterator it(piece.begin(), piece.end(), part), end; it != end; ++it) {
      const bool cell = (*it)[1] == "td" || (*it)[1] == "th";
      text += cell ? "|" : "\n" + (*it)[1].str() + " ";
      text += (*it)[3];
      if (cell && it->suffix().str().rfind("</tr>", 0) == 0) text += "\n";
    }
    at = picture == page.size() ? picture : page.find("</svg>", picture);
  }
  return text.substr(0, text.find("\nh2 What is measured"));
}

TEST(Report, TellsTheGoldenNumbers) {
  const ToyResults toy(every_kind);
  toy.add_real();
  const std::string golden = TOCSIN_SOURCE_DIR "/test/report/golden.txt";
  std::ostringstream wanted;
  wanted << std::ifstream(golden).rdbuf();
  const std::string told = told_by(page_of(toy)) + "\n";
  EXPECT_EQ(told, wanted.str()) << "with TOCSIN_WRITE_GOLDEN it is written anew";
  if (std::getenv("TOCSIN_WRITE_GOLDEN") != nullptr) std::ofstream(golden) << told;
}

TEST(Report, IsWholeWithoutRunsThatFailedAndTheSameEachTime) {
  const ToyResults toy;
  toy.write("out/series/main.a.near.camera.none.2.csv", "failure \nsec");
  const std::string sut = page_of(toy);
  EXPECT_THAT(
      sut, AllOf(HasSubstr("1 runs failed"), HasSubstr("main.a.near.camera.none.2: damaged file")));
  EXPECT_THAT(sut, AllOf(HasSubstr("</html>"), HasSubstr("<svg"), HasSubstr("0.1.0+toy")));
  EXPECT_THAT(sut, Not(HasSubstr("src=")));
  for (const char* metric : words_of(Metric{})) {
    EXPECT_THAT(sut, HasSubstr(std::string("<td>") + metric + "</td>"));
  }
  EXPECT_TRUE(std::filesystem::exists(toy.path("out/figures/fig43_main_a_near_camera_none.png")));
  EXPECT_EQ(page_of(toy), sut);
}

TEST(Report, SaysThatRealRunsHaveNoPairYet) {
  const ToyResults toy;
  toy.add_real();
  std::filesystem::remove(toy.path("out/runs.csv"));
  EXPECT_THAT(page_of(toy), HasSubstr("no simulated runs of these seeds yet"));
}

TEST(Report, HasOneLineForWhatItCannotRead) {
  const ToyResults toy;
  EXPECT_EQ(report("/tmp").code, 2);
  EXPECT_THAT(report("/tmp").output, HasSubstr("/tmp: holds no results of tocsin experiment run"));
  toy.write("out/runs.csv", with(toy.read("out/runs.csv"), "qni_min", "qni_least"));
  const Ended ended = report(toy.folder());
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output, HasSubstr("runs.csv: column qni_least is no metric"));
}

TEST(Report, SaysWhatIsNotInstalled) {
  const Ended ended = python({"-S", TOCSIN_SOURCE_DIR "/report", "/tmp"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.output, HasSubstr("(packages python3-jinja2, python3-matplotlib"));
}

TEST(Report, EstimatesAsItsOwnTestsSay) {
  const Ended ended = python({TOCSIN_SOURCE_DIR "/test/report/inference_test.py"});
  EXPECT_EQ(ended.code, 0) << ended.output;
}

}  // namespace
}  // namespace tocsin::experiment
