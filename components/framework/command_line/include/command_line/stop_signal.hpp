// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/time.hpp"

namespace tocsin {

/// Ctrl-C and SIGTERM end a command well from now on: it asks is_stopped() now and then.
void catch_stop_signals();

/// Whether one of them came.
[[nodiscard]] bool is_stopped();

/// Returns at `due`, or soon after a signal.
void sleep_until_stopped(Time due);

}  // namespace tocsin
