// SPDX-License-Identifier: Apache-2.0
#include "verbs.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "foundation/error.hpp"
#include "session_rig.hpp"

namespace tocsin::kobuki {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Verb = std::function<int(Session&)>;

int watch_plainly(Session& session) { return watch(session, false); }

/// How a verb ended.
struct Ended {
  int code = -1;  ///< -1 when it threw
  std::string error;
  std::string out;
};

Ended run(SessionRig& rig, const Verb& verb) {
  const auto session = rig.open();
  Ended ended;
  ::testing::internal::CaptureStdout();
  try {
    ended.code = verb(*session);
  } catch (const EnvironmentError& error) {
    ended.error = error.what();
  }
  ended.out = ::testing::internal::GetCapturedStdout();
  return ended;
}

/// The last page of a watch.
std::string last_page(const std::string& out) { return out.substr(out.rfind("Kobuki ")); }

TEST(Info, TellsWhatTheBaseAnswers) {
  SessionRig rig;
  const Ended ended = run(rig, info);
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("firmware  1.2.0"));
}

TEST(Info, EndsWithAnErrorWhenTheCableIsPulled) {
  for (int ms = 0; ms < 2000; ms += 100) {
    SessionRig pulled;
    pulled.deaf_at = SessionRig::start;  // so that it waits for answers
    pulled.unplug_at = SessionRig::start + std::chrono::milliseconds(ms);
    EXPECT_EQ(run(pulled, info).error, "/dev/test: the port was lost: is its cable out?") << ms;
  }
}

TEST(Info, EndsWithAnErrorWhenNoRequestIsAnswered) {
  SessionRig rig;
  rig.deaf_at = SessionRig::start;
  const Ended ended = run(rig, info);
  EXPECT_EQ(ended.error, "/dev/test: the base sends, but answers no request");
  EXPECT_THAT(ended.out, HasSubstr("firmware  unknown"));
  EXPECT_THAT(ended.out, Not(HasSubstr("firmware before 1.2")));
}

TEST(Info, EndsWithAnErrorWhenNoBaseSends) {
  SessionRig rig;
  rig.silent_at = SessionRig::start;
  EXPECT_EQ(run(rig, info).error, "/dev/test: no base is sending there");
  EXPECT_NEAR(rig.elapsed_s(), 3, 0.1);
}

TEST(Info, EndsWithoutSuccessWhenTheUserEndsTheWait) {
  SessionRig rig;
  rig.silent_at = SessionRig::start;
  rig.interrupt_at = SessionRig::start + seconds(1);
  EXPECT_EQ(run(rig, info).code, 1);
}

TEST(Watch, EndsByAKeyOrByCtrlC) {
  SessionRig keyed;
  keyed.keys.emplace(SessionRig::start + seconds(1), 'x');
  keyed.keys.emplace(SessionRig::start + seconds(2), 'q');
  EXPECT_EQ(run(keyed, watch_plainly).code, 0);
  EXPECT_NEAR(keyed.elapsed_s(), 2, 0.1);
  SessionRig interrupted;
  interrupted.interrupt_at = SessionRig::start + seconds(2);
  EXPECT_EQ(run(interrupted, watch_plainly).code, 0);
}

TEST(Watch, SaysThatTheCableWasPulled) {
  for (int ms = 100; ms < 1500; ms += 70) {
    SessionRig rig;
    rig.unplug_at = SessionRig::start + std::chrono::milliseconds(ms);
    const Ended ended = run(rig, watch_plainly);
    EXPECT_EQ(ended.error, "/dev/test: the port was lost: is its cable out?") << ms;
    EXPECT_THAT(last_page(ended.out), HasSubstr("no port"));
    EXPECT_THAT(last_page(ended.out), Not(HasSubstr("online")));
  }
}

TEST(Watch, SaysThatTheFramesStopped) {
  SessionRig rig;
  rig.silent_at = SessionRig::start + seconds(1);
  const Ended ended = run(rig, watch_plainly);
  EXPECT_EQ(ended.error, "/dev/test: no frame for 3 s: is the base off?");
  EXPECT_THAT(last_page(ended.out), HasSubstr("silent"));
  EXPECT_NEAR(rig.elapsed_s(), 4, 0.1);
}

TEST(Test, IsGoodOnAGoodBaseOnly) {
  SessionRig good;
  EXPECT_EQ(run(good, [&](Session& session) { return test(session, &good); }).code, 0);
  SessionRig bad;
  bad.refuses = "bumper";
  EXPECT_EQ(run(bad, [&](Session& session) { return test(session, &bad); }).code, 1);
}

TEST(Test, SaysThatTheBaseWasLost) {
  SessionRig rig;
  rig.unplug_at = SessionRig::start + seconds(4);
  const Ended ended = run(rig, [&](Session& session) { return test(session, &rig); });
  EXPECT_EQ(ended.error, "/dev/test: the port was lost: is its cable out?");
  EXPECT_THAT(ended.out, HasSubstr("1 failed"));
}

}  // namespace
}  // namespace tocsin::kobuki
