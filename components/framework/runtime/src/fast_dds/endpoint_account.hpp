// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <mutex>
#include <string>

#include "runtime/bus.hpp"
#include "runtime/host_control.hpp"
#include "runtime/logger.hpp"

namespace tocsin {

/// What the callbacks of one DDS endpoint have told, from any thread, and a log line for what a
/// person must know.
class EndpointAccount {
 public:
  EndpointAccount(const std::string& topic, bool writer);

  /// `change` of the number of matched ends outside this process.
  void on_matched(int change);
  void on_incompatible(eprosima::fastdds::dds::QosPolicyId_t policy, int change);
  void on_lost(int change);
  void on_undecodable(std::uint32_t bytes);
  void on_liveliness_lost(int change);
  [[nodiscard]] EndpointHealth health() const;

 private:
  Logger log_;
  mutable std::mutex mutex_;
  EndpointHealth health_;
};

}  // namespace tocsin
