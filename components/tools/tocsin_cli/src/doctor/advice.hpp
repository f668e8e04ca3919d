// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin::doctor {

enum class Fitness { good, unknown, bad };

/// One thing that was looked at.
struct Advice {
  Fitness fitness;
  std::string text;
  std::string remedy;  ///< a command or a sentence; empty when all is well
};

using Advices = std::vector<Advice>;

}  // namespace tocsin::doctor
