// SPDX-License-Identifier: Apache-2.0
#include "verbs.hpp"

#include <cstdio>

#include "acceptance.hpp"
#include "foundation/error.hpp"
#include "pages.hpp"

namespace tocsin::kobuki {
namespace {

/// Returns once the base was heard, or false when the user ended the wait.
bool wait_for_base(Session& session) {
  const bool heard = session.hears_base();
  session.check();
  return heard;
}

bool knows_all(const Inquiry& known) {
  const bool versions = known.hardware() && known.firmware() && known.unique_id();
  return versions && (known.gains() || !has_gains(*known.firmware()));
}

void print_page(const Session& session, bool screen) {
  std::fputs(screen ? "\x1b[H\x1b[2J" : "", stdout);
  std::fputs(watch_page(session.driver(), *session.last()).c_str(), stdout);
  std::puts(screen ? "q ends" : "");
  std::fflush(stdout);
}

}  // namespace

int info(Session& session) {
  if (!wait_for_base(session)) return 1;
  const Inquiry& known = session.driver().inquiry();
  (void)session.run_until([&] { return knows_all(known); }, std::chrono::seconds(2));
  session.check();
  std::fputs(info_page(session.driver(), *session.last()).c_str(), stdout);
  if (known.firmware()) return 0;
  throw EnvironmentError(session.name() + ": the base sends, but answers no request");
}

int watch(Session& session, bool screen) {
  if (!wait_for_base(session)) return 0;
  while (!session.over() && session.key() != 'q') {
    print_page(session, screen);
    session.run_for(std::chrono::milliseconds(200));
  }
  if (session.lost()) print_page(session, screen);
  session.check();
  return 0;
}

int test(Session& session, SimulatorControl* control) {
  if (!wait_for_base(session)) return 1;
  const bool good = Acceptance(session, control).run().good();
  session.check();
  return good ? 0 : 1;
}

}  // namespace tocsin::kobuki
