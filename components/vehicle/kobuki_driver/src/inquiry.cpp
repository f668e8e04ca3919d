// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/inquiry.hpp"

#include <algorithm>

namespace tocsin::kobuki {

void Inquiry::begin(Time now) {
  hardware_.reset();
  firmware_.reset();
  unique_id_.reset();
  gains_.reset();
  asked_for_gains_ = doubts_firmware_ = false;
  pause_ = first_pause;
  next_ = now;
}

void Inquiry::on_feedback(const Feedback& feedback) {
  if (feedback.hardware) hardware_ = feedback.hardware;
  if (feedback.firmware) {
    firmware_ = feedback.firmware;
    doubts_firmware_ = false;
  }
  if (feedback.unique_id) unique_id_ = feedback.unique_id;
  if (feedback.gains) gains_ = feedback.gains;
}

void Inquiry::forget_gains() {
  gains_.reset();
  asked_for_gains_ = false;
}

std::optional<Command> Inquiry::missing() const {
  if (!hardware_ || !firmware_ || !unique_id_ || doubts_firmware_) {
    return RequestExtra{RequestExtra::hardware | RequestExtra::firmware | RequestExtra::unique_id};
  }
  if (!gains_ && has_gains(*firmware_)) return GetGains{};
  return std::nullopt;
}

std::optional<Command> Inquiry::due(Time now) {
  auto request = missing();
  if (!request) return std::nullopt;
  const bool first_for_gains = std::holds_alternative<GetGains>(*request) && !asked_for_gains_;
  if (first_for_gains) pause_ = first_pause;
  if (!first_for_gains && now < next_) return std::nullopt;
  asked_for_gains_ |= first_for_gains;
  next_ = now + pause_;
  pause_ = std::min(2 * pause_, longest_pause);
  return request;
}

}  // namespace tocsin::kobuki
