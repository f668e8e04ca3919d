// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/writer_proxy.hpp"

#include <algorithm>

namespace tocsin::rtps {

std::size_t WriterProxy::missing_before(Sequence sequence) const {
  if (sequence <= available_) return 0;
  const auto settled = std::distance(early_.begin(), early_.lower_bound(sequence));
  return sequence - available_ - 1 - static_cast<std::size_t>(settled);
}

std::vector<Sequence> WriterProxy::missing() const {
  std::vector<Sequence> all;
  const Sequence end = std::min(available_ + 1 + wire::longest_list, last_known_ + 1);
  for (Sequence sequence = available_ + 1; sequence < end; ++sequence) {
    if (early_.count(sequence) == 0) all.push_back(sequence);
  }
  return all;
}

bool WriterProxy::settle(Sequence sequence) {
  if (has(sequence)) return false;
  last_known_ = std::max(last_known_, sequence);
  if (sequence == available_ + 1) {
    available_ = sequence;
    advance();
  } else {
    early_.insert(sequence);
  }
  return true;
}

void WriterProxy::on_history(Sequence first, Sequence last) {
  if (first > available_ + 1) {
    early_.erase(early_.begin(), early_.lower_bound(first));
    available_ = first - 1;
    advance();
  }
  last_known_ = std::max({last_known_, available_, last});
}

void WriterProxy::advance() {
  while (!early_.empty() && *early_.begin() == available_ + 1) {
    early_.erase(early_.begin());
    ++available_;
  }
}

}  // namespace tocsin::rtps
