// SPDX-License-Identifier: Apache-2.0
// tocsin-container FILE HOST CONTAINER: runs one container process of a resolved bringup file.
#include <cstdio>
#include <string>

#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "run_container.hpp"

namespace tocsin {
namespace {

int run(const std::string& file, const std::string& host_name, const std::string& name) {
  const deployment::Deployment deployment = deployment::load_resolved(file);
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
    if (argc != 4) throw tocsin::ConfigError("usage: tocsin-container FILE HOST CONTAINER");
    return tocsin::run(argv[1], argv[2], argv[3]);
  });
}
