// SPDX-License-Identifier: Apache-2.0
// The command line of shape_main, the program of the OMG's DDS interoperability suite.
#pragma once

#include <optional>
#include <string>

#include "runtime/middleware/qos_policies.hpp"

namespace tocsin::shapes {

enum class FinalState { none, unregister, dispose };

/// What a program of the suite is told. The suite has durations in ms; here they are in seconds.
struct ShapeOptions {
  bool publish = false;
  int domain = 0;
  std::string topic;
  std::string color;  ///< of a publisher; a subscriber's filter; empty: none
  QosProfile qos;  ///< reliability, durability, history, deadline, ownership, partition, lifespan
  bool print_written = false;
  int shapesize = 20;  ///< [pixel] 0: grows with each sample
  int size_modulo = 0;
  bool reads = false;   ///< read() instead of take()
  bool stamps = false;  ///< a subscriber prints the instants of its samples
  double write_period_s = 0.033;
  double read_period_s = 0.1;
  int iterations = 0;  ///< 0: until it is interrupted
  int instances = 1;
  int topics = 1;
  FinalState final_state = FinalState::none;
  int payload_bytes = 0;
  std::string filter;       ///< an expression, see ShapeFilter
  std::string unsupported;  ///< what of the command line this DDS does not have; empty: nothing
};

/// Throws ConfigError, with the usage, for what shape_main does not accept. Empty: help was asked
/// for and printed.
[[nodiscard]] std::optional<ShapeOptions> parse_options(int argc, const char* const* argv);

}  // namespace tocsin::shapes
