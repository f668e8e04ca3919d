// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/endpoint_account.hpp"
#include "runtime/host_control.hpp"

#include <algorithm>
#include <map>

namespace tocsin {
namespace {

namespace dds = eprosima::fastdds::dds;

std::string name_of(dds::QosPolicyId_t policy) {
  static const std::map<std::uint32_t, const char*> names{
      {dds::DURABILITY_QOS_POLICY_ID, "durability"},
      {dds::DEADLINE_QOS_POLICY_ID, "deadline"},
      {dds::OWNERSHIP_QOS_POLICY_ID, "ownership"},
      {dds::LIVELINESS_QOS_POLICY_ID, "liveliness"},
      {dds::PARTITION_QOS_POLICY_ID, "partition"},
      {dds::RELIABILITY_QOS_POLICY_ID, "reliability"},
      {dds::PRESENTATION_QOS_POLICY_ID, "presentation"}};
  const auto found = names.find(policy);
  return found != names.end() ? found->second : "DDS policy " + std::to_string(policy);
}

std::uint64_t counted(int change) { return static_cast<std::uint64_t>(std::max(change, 0)); }

}  // namespace

EndpointAccount::EndpointAccount(const std::string& topic, bool writer) : log_("dds " + topic) {
  health_.writer = writer;
}

void EndpointAccount::on_matched(int change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  health_.matched += change;
}

void EndpointAccount::on_incompatible(dds::QosPolicyId_t policy, int change) {
  const std::string name = name_of(policy);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    health_.incompatible_qos += counted(change);
    health_.incompatible_policy = name;
  }
  log_.error("not matched: a {} this {} ({})",
             health_.writer ? "reader requests more than" : "writer offers less than",
             health_.writer ? "writer offers" : "reader requests", name);
}

void EndpointAccount::on_lost(int change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  health_.lost += counted(change);
}

void EndpointAccount::on_undecodable(std::uint32_t bytes) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++health_.rejected;
  }
  log_.error("a sample of {} bytes is not of this type; dropped", bytes);
}

void EndpointAccount::on_liveliness_lost(int change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  health_.liveliness_lost += counted(change);
}

EndpointHealth EndpointAccount::health() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return health_;
}

}  // namespace tocsin
