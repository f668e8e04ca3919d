// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::topic_tool {

/// `tocsin topic` and its siblings: each parses its arguments, does what the verb says and returns
/// the exit code.
int run_action(int argc, char** argv);
int run_interface(int argc, char** argv);
int run_lifecycle(int argc, char** argv);
int run_node(int argc, char** argv);
int run_param(int argc, char** argv);
int run_service(int argc, char** argv);
int run_topic(int argc, char** argv);

}  // namespace tocsin::topic_tool
