// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>

namespace CLI {
class App;
}

namespace tocsin {

/// The whole of a program's main after its options are declared: parses, runs `body`, returns the
/// exit code. Errors as in run_program; the app's name stands in front of them. Bad usage is a
/// ConfigError.
[[nodiscard]] int run_command(CLI::App& app, int argc, char** argv,
                              const std::function<int()>& body);

/// The verbs of a program of which one must be said, each with what it does.
class Verbs {
 public:
  explicit Verbs(CLI::App& app);
  /// Declares a verb; `body` runs when it was said, and returns the exit code.
  CLI::App* add(const std::string& name, const std::string& text, std::function<int()> body);
  /// Parses and runs the body of the verb, as run_command.
  [[nodiscard]] int run(int argc, char** argv) const;

 private:
  CLI::App& app_;
  std::map<const CLI::App*, std::function<int()>> bodies_;
};

}  // namespace tocsin
