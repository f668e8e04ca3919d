// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin {

/// How an order ended: what to tell the person and the shell.
struct OrderResult {
  int code = 0;
  std::string text;
};

}  // namespace tocsin
