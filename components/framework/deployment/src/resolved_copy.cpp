// SPDX-License-Identifier: Apache-2.0
#include "deployment/resolved_copy.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "foundation/error.hpp"

namespace tocsin::deployment {

ResolvedCopy::ResolvedCopy(const Deployment& deployment)
    : descriptor_(::memfd_create("tocsin_deployment", 0)) {  // stays open in children
  std::ofstream file(path());
  file << resolved_text(deployment);
  file.close();
  if (descriptor_ >= 0 && file) return;
  const std::string reason = std::generic_category().message(errno);
  if (descriptor_ >= 0) ::close(descriptor_);
  throw EnvironmentError("no memory for a copy of the bringup file: " + reason);
}

ResolvedCopy::~ResolvedCopy() { ::close(descriptor_); }

std::string ResolvedCopy::path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

}  // namespace tocsin::deployment
