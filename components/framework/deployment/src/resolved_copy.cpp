// SPDX-License-Identifier: Apache-2.0
#include "deployment/resolved_copy.hpp"

#include <sys/mman.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin::deployment {

ResolvedCopy::ResolvedCopy(const Deployment& deployment)
    : file_(::memfd_create("tocsin_deployment", 0)) {  // stays open in children
  std::ofstream file(path());
  file << resolved_text(deployment);
  file.close();
  if (file_ && file) return;
  throw EnvironmentError("no memory for a copy of the bringup file: " +
                         std::generic_category().message(errno));
}

std::string ResolvedCopy::path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }

}  // namespace tocsin::deployment
