// SPDX-License-Identifier: Apache-2.0
// tocsin shapes: the command line, output and exit codes of shape_main (omg-dds/dds-rtps), so that
// the suite's script can drive it: 1 for a wrong command line, 2 when it could not begin, 3 when it
// failed.
#include <cstdio>
#include <exception>

#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"
#include "shape_bus.hpp"
#include "shape_publisher.hpp"

namespace tocsin::shapes {
namespace {

constexpr int wrong_arguments = 1;
constexpr int could_not_begin = 2;
constexpr int failed = 3;

int run(const ShapeOptions& options) {
  if (!options.unsupported.empty()) {
    say("    " + options.unsupported + " = not supported");
    return could_not_begin;
  }
  catch_stop_signals();
  options.publish ? publish(options, is_stopped) : subscribe(options, is_stopped);
  say("Done.");
  return 0;
}

/// What to tell whom, and how to end.
int told(const std::exception& error, int code) {
  std::fprintf(stderr, "tocsin shapes: %s\n", error_line(error.what()).c_str());
  return code;
}

int run_all(int argc, char** argv) {
  try {
    const auto options = parse_options(argc, argv);
    return options ? run(*options) : 0;
  } catch (const ConfigError& error) {
    return told(error, wrong_arguments);
  } catch (const EnvironmentError& error) {
    return told(error, could_not_begin);
  } catch (const std::exception& error) {
    return told(error, failed);
  }
}

}  // namespace
}  // namespace tocsin::shapes

int main(int argc, char** argv) { return tocsin::shapes::run_all(argc, argv); }
