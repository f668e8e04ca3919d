// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "topic_options.hpp"

namespace tocsin::topic_tool::topic_verb {

// Each does what its verb says and returns the exit code. They throw ConfigError for what a person
// said wrong, EnvironmentError for what is not there.
int list(const Options& options);
int info(const Options& options);
int type(const Options& options);
int find(const Options& options);
int echo(const Options& options);
int hz(const Options& options);
int bw(const Options& options);
int delay(const Options& options);
int pub(const Options& options);

}  // namespace tocsin::topic_tool::topic_verb
