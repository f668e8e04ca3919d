// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/packet_loss.hpp"

namespace tocsin::radio {

PacketLoss::PacketLoss(const ChannelParams& params, std::uint64_t seed, Time start)
    : params_(params), packets_(seed, 4), states_(seed, 5), change_at_(start) {
  bad_ = !states_.chance(params.bad_s / (params.good_s + params.bad_s));  // flips at the start
}

bool PacketLoss::bad(Time now) {
  while (change_at_ <= now) {
    bad_ = !bad_;
    change_at_ += seconds(states_.exponential(bad_ ? params_.bad_s : params_.good_s));
  }
  return bad_;
}

bool PacketLoss::lost(Time now) {
  if (params_.mode == "bernoulli") return packets_.chance(params_.loss);
  return packets_.chance(bad(now) ? params_.bad_loss : params_.good_loss);
}

}  // namespace tocsin::radio
