// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "deployment/deployment.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin::deployment {

/// A resolved file in memory. The processes of a run inherit it, so that a restart needs no run
/// folder, and whoever looks for the run finds there what it is, see running_hosts.
class ResolvedCopy {
 public:
  /// Throws EnvironmentError when there is no memory for it.
  explicit ResolvedCopy(const Deployment& deployment);

  /// Where this process, and those that it starts, read it.
  [[nodiscard]] std::string path() const;

 private:
  FileDescriptor file_;
};

}  // namespace tocsin::deployment
