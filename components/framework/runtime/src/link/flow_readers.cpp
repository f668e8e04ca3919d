// SPDX-License-Identifier: Apache-2.0
#include "link/flow_readers.hpp"

#include <algorithm>

namespace tocsin {
namespace {

bool are_same(const ReaderKey& one, const ReaderKey& other) {
  return !(one < other) && !(other < one);
}

}  // namespace

void FlowReaders::add(FlowId flow, const ReaderKey& key) {
  if (by_flow_.count(flow) != 0) return;
  const auto found = readers_.find(key);
  if (found == readers_.end()) readers_[key] = {make_(key)};
  idle_.erase(std::remove_if(idle_.begin(), idle_.end(),
                             [&](const ReaderKey& one) { return are_same(one, key); }),
              idle_.end());
  ++readers_[key].flows;
  by_flow_[flow] = key;
}

void FlowReaders::remove(FlowId flow) {
  const auto found = by_flow_.find(flow);
  if (found == by_flow_.end()) return;
  if (--readers_.at(found->second).flows == 0) idle_.push_back(found->second);
  by_flow_.erase(found);
  if (idle_.size() <= most_idle) return;
  readers_.erase(idle_.front());
  idle_.pop_front();
}

void FlowReaders::drop(FlowId flow) {
  const auto found = by_flow_.find(flow);
  if (found == by_flow_.end()) return;
  const ReaderKey key = found->second;
  by_flow_.erase(found);
  if (--readers_.at(key).flows == 0) readers_.erase(key);
}

void FlowReaders::renew(FlowId flow) {
  const auto found = by_flow_.find(flow);
  if (found == by_flow_.end()) return;
  readers_.at(found->second).reader = make_(found->second);
}

}  // namespace tocsin
