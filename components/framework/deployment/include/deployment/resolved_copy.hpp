// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "deployment/deployment.hpp"

namespace tocsin::deployment {

/// A resolved file in memory. The processes of a run inherit it, so that a restart needs no run
/// folder, and whoever looks for the run finds there what it is, see running_hosts.
class ResolvedCopy {
 public:
  /// Throws EnvironmentError when there is no memory for it.
  explicit ResolvedCopy(const Deployment& deployment);
  ~ResolvedCopy();
  ResolvedCopy(const ResolvedCopy&) = delete;
  ResolvedCopy& operator=(const ResolvedCopy&) = delete;

  /// Where this process, and those that it starts, read it.
  [[nodiscard]] std::string path() const;

 private:
  int descriptor_;
};

}  // namespace tocsin::deployment
