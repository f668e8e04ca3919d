// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "qos_options.hpp"

namespace tocsin::qos_tool::qos_verb {

// Each does what its verb says and returns the exit code. They throw ConfigError and
// EnvironmentError.
int list(const Options& options);
int show(const Options& options);
int explain(const Options& options);
int diff(const Options& options);
int match(const Options& options);
int lint_files(const Options& options);
int export_profiles(const Options& options);
int set(const Options& options);
int tune(const Options& options);

}  // namespace tocsin::qos_tool::qos_verb
