// SPDX-License-Identifier: Apache-2.0
// tocsin-container FILE HOST CONTAINER [COPY]: runs one container process of a resolved bringup
// file. COPY: where its text is read when the file itself may be gone.
#include <cstdio>
#include <string>
#include <vector>

#include "container/run_container.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"

namespace tocsin {
namespace {

int run(const std::vector<std::string>& words) {
  const std::string& file = words[0];
  const std::string& host_name = words[1];
  const std::string& name = words[2];
  const auto deployment = deployment::load_resolved(file, words.size() > 3 ? words[3] : "");
  const deployment::Host* host = deployment::find_host(deployment, host_name);
  if (host == nullptr) throw ConfigError(file + ": has no host '" + host_name + "'");
  const deployment::Container* found = deployment::find_container(*host, name);
  if (found == nullptr) throw ConfigError(file + ": " + host_name + " has no container " + name);
  return run_container(deployment, *host, *found);
}

}  // namespace
}  // namespace tocsin

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin-container", [&] {
    if (argc == 2 && std::string(argv[1]) == "--help") {
      std::printf("Runs one container process of a resolved bringup file (for tocsin launch)\n");
      return 0;
    }
    if (argc != 4 && argc != 5) {
      throw tocsin::ConfigError("usage: tocsin-container FILE HOST CONTAINER [COPY]");
    }
    return tocsin::run({argv + 1, argv + argc});
  });
}
