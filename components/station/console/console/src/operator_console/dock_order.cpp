// SPDX-License-Identifier: Apache-2.0
#include "operator_console/dock_order.hpp"

#include <cmath>
#include <utility>

namespace tocsin {

bool DockOrder::running() const {
  return status_ && status_->state != "idle" && status_->state != "done";
}

std::optional<std::string> DockOrder::on_status(const Status& status, Time now) {
  if (!status_) first_run_ = status.run;
  const bool news = !status_ || status_->state != status.state || status_->run != status.run;
  status_ = status;
  deadline_ = now + wait_;
  started_ = started_ || running() || status.run != first_run_;
  if (!news || wish_ == Wish::status || !running()) return std::nullopt;
  return std::to_string(std::lround(status.elapsed_s)) + " s: " + status.state;
}

const char* DockOrder::command() const {
  if (wish_ == Wish::start && !started_) return "start";
  return wish_ == Wish::cancel ? "cancel" : nullptr;
}

std::optional<OrderResult> DockOrder::result(Time now) const {
  if (now >= deadline_) return OrderResult{1, "the vehicle is not heard; docking may go on there"};
  if (!status_) return std::nullopt;
  const std::string ended =
      "docking " + (status_->state == "done" ? status_->result : status_->state);
  if (wish_ == Wish::status) return OrderResult{0, ended};
  if (running()) return std::nullopt;
  if (wish_ == Wish::cancel) return OrderResult{0, ended};
  if (!started_) return std::nullopt;
  return OrderResult{status_->result == "docked" ? 0 : 1, ended};
}

}  // namespace tocsin
