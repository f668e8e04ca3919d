// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace tocsin {

/// The whole of a program's main after its options are declared: parses, runs `body`, returns the
/// exit code. Errors as in run_program; the app's name stands in front of them. Bad usage is a
/// ConfigError.
[[nodiscard]] int run_command(CLI::App& app, int argc, char** argv,
                              const std::function<int()>& body);

}  // namespace tocsin
