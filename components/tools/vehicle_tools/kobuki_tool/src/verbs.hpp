// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session.hpp"
#include "simulator_control.hpp"

/// What `tocsin kobuki` does. Each prints to standard output and returns the exit code; each throws
/// EnvironmentError, naming the port, when no base is there or it is lost, at whatever moment.
namespace tocsin::kobuki {

int info(Session& session);
/// Until `q` or Ctrl-C. With `screen` each page replaces the one before.
int watch(Session& session, bool screen);
/// `control` may be null: then a person presses and answers.
int test(Session& session, SimulatorControl* control);

}  // namespace tocsin::kobuki
