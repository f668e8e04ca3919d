// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/file_descriptor.hpp"

namespace tocsin::cli {

/// SIGINT, SIGTERM, SIGHUP and SIGCHLD as something to poll. Blocks them for this process.
class Signals {
 public:
  Signals();
  [[nodiscard]] int descriptor() const { return fd_.get(); }
  /// The next waiting signal, 0 when there is none.
  [[nodiscard]] int take();

 private:
  FileDescriptor fd_;
};

}  // namespace tocsin::cli
