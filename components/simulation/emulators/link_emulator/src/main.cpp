// SPDX-License-Identifier: Apache-2.0
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "emulator.hpp"
#include "foundation/program.hpp"

namespace {

/// The parent owns the namespaces and the run: without it there is nothing to carry.
void die_with_parent() {
  const pid_t parent = ::getppid();
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) std::exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  die_with_parent();
  return tocsin::run_program("link_emulator", [&] {
    const auto options = tocsin::link::parse_options(argc, argv);
    if (!options) return 0;
    if (options->check) {
      (void)tocsin::link::make_channel(*options, {});
    } else {
      tocsin::link::Emulator(*options).run();
    }
    return 0;
  });
}
