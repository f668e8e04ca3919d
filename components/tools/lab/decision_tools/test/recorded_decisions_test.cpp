// SPDX-License-Identifier: Apache-2.0
// Recordings of transmission_state: whose rows, what was decided, and that it is decided again.
#include "recorded_decisions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "decide.hpp"
#include "decide_report.hpp"
#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::tools {
namespace {

using ::testing::HasSubstr;

const std::string head =
    "receive_s,sequence,stamp.sec,stamp.nanosec,role,active,reason,pause_samples,qni\n";

decision::PolicyParams tocp_dsp() {
  decision::PolicyParams params;
  params.policy = decision::PolicyKind::tocp_dsp;
  return params;
}

/// What a controller does, written down as the recorder does.
class Recorder {
 public:
  explicit Recorder(const decision::PolicyParams& params = tocp_dsp())
      : params_(params), policy_(decision::make_policy(params)) {}

  void sample(double at_s, double qni) {
    note(at_s, qni, policy_->on_sample({time(at_s), qni}, time(at_s)));
  }
  void deadline(double at_s) { note(at_s, NAN, policy_->on_deadline(time(at_s))); }
  void restart() {
    policy_ = decision::make_policy(params_);
    sequence_ = 0;
  }
  void lose() { ++sequence_; }
  void repeat() { text_ += row_; }
  [[nodiscard]] std::string text() const { return head + text_; }

 private:
  static Time time(double at_s) { return Time{seconds(at_s)}; }
  void note(double at_s, double qni, const decision::Evidence& evidence) {
    const auto ns = seconds(at_s).count();
    row_ = "0," + std::to_string(++sequence_) + "," + std::to_string(ns / 1'000'000'000) + "," +
           std::to_string(ns % 1'000'000'000) + ",uxv," +
           (evidence.state == decision::State::active ? "1," : "0,") + to_string(evidence.reason) +
           "," + std::to_string(evidence.age) + "," + (std::isnan(qni) ? "" : std::to_string(qni)) +
           "\n";
    text_ += row_;
  }
  decision::PolicyParams params_;
  std::unique_ptr<decision::Policy> policy_;
  int sequence_ = 0;
  std::string row_;
  std::string text_;
};

class RecordedDecisionsTest : public ::testing::Test {
 protected:
  QualityTrace read(const std::string& text, std::optional<Role> role = {}) const {
    return read_quality_trace(folder.write("transmission_state.csv", text), {"", role, 1});
  }
  std::string error_of(const std::string& text, std::optional<Role> role = {}) const {
    try {
      (void)read(text, role);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  DecidedTrace decide(const std::string& text, const std::vector<std::string>& set = {}) const {
    return decide_again(read(text), "", load_settings({{}, "", set, "tocp_dsp"}));
  }
  TemporaryFolder folder;
};

TEST_F(RecordedDecisionsTest, AskForTheRoleWhenThereAreTwo) {
  const std::string text = "receive_s,role,qni\n1,uxv,50\n1,gcs,60\n2,uxv,70\n";
  EXPECT_THAT(error_of(text), HasSubstr("transmission_state.csv: has decisions of the roles uxv "
                                        "and gcs; choose one by --host"));
  EXPECT_EQ(read(text, Role::uxv).qni, (std::vector<double>{50, 70}));
  EXPECT_EQ(read(text, Role::gcs).qni, std::vector<double>{60});
}

TEST_F(RecordedDecisionsTest, OfOneRoleNeedNoChoiceAndOfTheOtherThereAreNone) {
  const std::string text = "receive_s,role,qni\n1,gcs,60\n";
  EXPECT_EQ(read(text).role, Role::gcs);
  EXPECT_THAT(error_of(text, Role::uxv), HasSubstr("has no row with role uxv, only gcs"));
}

TEST_F(RecordedDecisionsTest, ARoleIsUxvOrGcsInEveryRow) {
  EXPECT_THAT(error_of("receive_s,role,qni\n1,gcs,60\n2,base,60\n"),
              HasSubstr("transmission_state.csv:3: role: 'base' is not uxv or gcs"));
}

TEST_F(RecordedDecisionsTest, ARoleNeedsAColumnOrARun) {
  EXPECT_THAT(error_of("qni\n1\n", Role::uxv),
              HasSubstr("--host uxv: the file has no column role"));
}

TEST_F(RecordedDecisionsTest, AreTimedByTheirStampToTheNanosecond) {
  const QualityTrace sut =
      read(head + "9,1,100,999999999,uxv,1,steady,0,50\n" + "20,2,102,1,uxv,1,steady,0,50\n");
  EXPECT_EQ(seconds(sut.time_s[1]), Duration{1'000'000'002});
}

TEST_F(RecordedDecisionsTest, AreDecidedAgainAsTheyWere) {
  Recorder run;
  for (int i = 0; i < 60; ++i) run.sample(i, i % 20 < 12 ? 80 + i % 7 : 35 + i % 5);
  const DecidedTrace sut = decide(run.text());
  const auto compared = compare_with_recording(sut);
  EXPECT_EQ(compared->recorded, 60U);
  EXPECT_EQ(compared->same, 60U);
  EXPECT_GE(compared->recorded_pauses, 3U);
  EXPECT_EQ(compared->recorded_pauses, summarize(sut).pauses);
  EXPECT_THAT(to_text(sut), HasSubstr("60 of 60 decisions are the recorded ones\n"));
}

TEST_F(RecordedDecisionsTest, WithOtherParametersNameTheFirstThatDiffers) {
  Recorder run;
  for (int i = 0; i < 20; ++i) run.sample(i, i < 10 ? 80 : 35);
  const DecidedTrace sut = decide(run.text(), {"alpha=100"});
  EXPECT_EQ(compare_with_recording(sut)->first_other, std::optional<std::size_t>(10));
  EXPECT_THAT(to_text(sut), HasSubstr("the first other one at 10.0 s: recorded passive, "
                                      "cusum_alarm; decided active, steady"));
}

/// A pause whose samples stop, so that it ends at its deadline, 180 s after it began.
Recorder pause_without_samples(double woken_after_s) {
  Recorder run;
  run.sample(0, 80);
  run.sample(1, 20);
  run.sample(2, 20);
  run.deadline(1 + 180 + woken_after_s);
  run.sample(181.5, 20);
  return run;
}

TEST_F(RecordedDecisionsTest, TakeTheEndOfAPauseForNoSample) {
  const DecidedTrace sut = decide(pause_without_samples(0.002).text());
  EXPECT_EQ(compare_with_recording(sut)->same, 5U);
  EXPECT_EQ(summarize(sut).samples, 4U);
  EXPECT_EQ(summarize(sut).missing, 0U);
  EXPECT_DOUBLE_EQ(sut.steps[3].time_s, 181.002);
}

TEST_F(RecordedDecisionsTest, APauseThatEndsSoonerNowEndsAtItsOwnDeadline) {
  const DecidedTrace sut = decide(pause_without_samples(0.002).text(), {"th_max_s=60"});
  EXPECT_DOUBLE_EQ(sut.steps[3].time_s, 61);
  EXPECT_EQ(sut.steps[3].evidence.reason, decision::Reason::forced_resume_time);
}

TEST_F(RecordedDecisionsTest, AnEndOfAPauseThatIsLaterNowIsNotTaken) {
  const DecidedTrace sut = decide(pause_without_samples(0.002).text(), {"th_max_s=1000"});
  ASSERT_EQ(sut.steps.size(), 4U);
  EXPECT_EQ(sut.steps[3].evidence.state, decision::State::passive);
}

TEST_F(RecordedDecisionsTest, ASampleThatCameBeforeTheControllerWokeDecides) {
  Recorder run;
  run.sample(1, 20);
  run.sample(1 + 180 + 0.003, 20);
  EXPECT_EQ(compare_with_recording(decide(run.text()))->same, 2U);
}

TEST_F(RecordedDecisionsTest, NoMeasurementIsASample) {
  Recorder run;
  run.sample(1, 20);
  run.sample(2, NAN);
  run.sample(1 + 180 + 0.003, NAN);  // the limit of silence is over when it comes
  const DecidedTrace sut = decide(run.text());
  EXPECT_EQ(compare_with_recording(sut)->same, 3U);
  EXPECT_EQ(summarize(sut).missing, 2U);
}

TEST_F(RecordedDecisionsTest, ARestartedControllerBeginsAnew) {
  Recorder run;
  for (int i = 0; i < 5; ++i) run.sample(i, 80);
  run.sample(5, 20);
  run.restart();
  for (int i = 6; i < 12; ++i) run.sample(i, 80);
  const DecidedTrace sut = decide(run.text());
  EXPECT_TRUE(sut.trace.recorded[6].restarted);
  EXPECT_EQ(sut.trace.unrecorded, 0U);
  EXPECT_EQ(compare_with_recording(sut)->same, 12U);
}

TEST_F(RecordedDecisionsTest, ARepeatedRowOfARestartedRecorderCountsOnce) {
  Recorder run;
  run.sample(0, 80);
  run.repeat();
  run.sample(1, 80);
  const QualityTrace sut = read(run.text());
  EXPECT_EQ(sut.qni.size(), 2U);
  EXPECT_FALSE(sut.recorded[1].restarted);
}

TEST_F(RecordedDecisionsTest, TellHowManyDidNotReachTheRecording) {
  Recorder run;
  run.lose();
  run.sample(0, 80);
  run.lose();
  run.lose();
  run.sample(3, 80);
  const DecidedTrace sut = decide(run.text());
  EXPECT_EQ(sut.trace.unrecorded, 3U);
  EXPECT_THAT(to_text(sut), HasSubstr("3 decisions of the run are not in this recording"));
}

TEST_F(RecordedDecisionsTest, NameFileLineAndValueOfBadRows) {
  const auto row = [](const std::string& sequence, const std::string& second) {
    return "0," + sequence + "," + second + ",0,uxv,1,steady,0,50\n";
  };
  EXPECT_EQ(error_of(head + row("1", "7") + row("2", "7")), "no error");
  EXPECT_THAT(
      error_of(head + row("1", "7.5") + row("2", "7.25")),
      HasSubstr("transmission_state.csv:3: stamp.sec: 7.25 is 0.250 s before the row above"));
  EXPECT_THAT(error_of(head + row("1", "")), HasSubstr(".csv:2: stamp.sec: must be a time"));
  EXPECT_THAT(error_of(head + row("1", "nan")), HasSubstr(".csv:2: stamp.sec: must be a time"));
  EXPECT_THAT(error_of(head + row("1e308", "1")), HasSubstr(".csv:2: sequence: '1e308' is not"));
  EXPECT_THAT(error_of(head + row("-1", "1")), HasSubstr(".csv:2: sequence: '-1' is not a whole"));
  EXPECT_THAT(error_of(head + row("", "1")), HasSubstr(".csv:2: sequence: '' is not a whole"));
}

TEST_F(RecordedDecisionsTest, AreComparedInJson) {
  Recorder run;
  run.sample(1500.25, 80);
  const auto sut = to_json(decide(run.text()), false);
  EXPECT_EQ(sut["role"], "uxv");
  EXPECT_EQ(sut["recorded"]["began_s"], 1500.25);
  EXPECT_EQ(sut["recorded"]["same"], 1);
  EXPECT_EQ(sut["parameters"].size(), 1U);  // --policy
}

/// A vehicle that drives out of a dead zone and into the next one, again and again.
std::string foresight_recording() {
  decision::PolicyParams params;
  params.policy = decision::PolicyKind::foresight;
  const auto policy = decision::make_policy(params);
  std::string text = "receive_s,sequence,stamp.sec,stamp.nanosec,role,active,reason,pause_samples,";
  text += "qni,outlook\n";
  for (int i = 0; i < 200; ++i) {
    decision::Outlook outlook;
    std::string list;
    while (outlook.size < decision::Outlook::most) {
      const bool is_dead = (i + static_cast<int>(outlook.size)) % 40 < 20;
      outlook.risk_percent[outlook.size++] = is_dead ? 95 : 2;
      list += (list.empty() ? "" : ",") + std::string(is_dead ? "95" : "2");
    }
    policy->foresee(outlook);
    const double qni = i % 40 < 20 ? 35 : 85;
    const Time now{std::chrono::seconds(i)};
    const auto evidence = policy->on_sample({now, qni}, now);
    text += "0," + std::to_string(i + 1) + "," + std::to_string(i) + ",0,uxv," +
            (evidence.state == decision::State::active ? "1," : "0,") + to_string(evidence.reason) +
            "," + std::to_string(evidence.age) + "," + std::to_string(qni) + ",\"[" + list +
            "]\"\n";
  }
  return text;
}

TEST_F(RecordedDecisionsTest, PolicyForesightDecidesAgainByTheOutlookThatItHad) {
  const std::string text = foresight_recording();
  const auto decided = decide_again(read(text), "", load_settings({{}, "", {}, "foresight"}));
  const auto compared = compare_with_recording(decided);
  ASSERT_TRUE(compared);
  EXPECT_EQ(compared->recorded, 200U);
  EXPECT_EQ(compared->same, 200U);
  EXPECT_GE(compared->recorded_pauses, 4U);
}

TEST_F(RecordedDecisionsTest, AnOutlookThatIsNoneIsNamed) {
  std::string text = foresight_recording();
  const std::string broken = text.replace(text.find("[95,"), 4, "[195,");
  EXPECT_THAT(error_of(broken), HasSubstr("'195' is not in [0, 100]"));
  EXPECT_THAT(error_of(text.replace(text.find("[195,"), 5, "[x,")),
              HasSubstr("is no list of at most 61 percentages"));
}

}  // namespace
}  // namespace tocsin::tools
