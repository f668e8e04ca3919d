// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/probe_window.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::network {
namespace {

/// The next slot after `slot`; from `now` on when slots were missed.
Time next_slot(Time slot, Duration period, Time now) {
  return slot + period > now ? slot + period : now + period;
}

double to_ms(Duration d) { return to_seconds(d) * 1e3; }

void add_rtt(std::optional<RttSummary>& sum, double rtt_ms) {
  if (!sum) sum = RttSummary{rtt_ms, 0, rtt_ms};
  sum->min_ms = std::min(sum->min_ms, rtt_ms);
  sum->max_ms = std::max(sum->max_ms, rtt_ms);
  sum->mean_ms += rtt_ms;
}

}  // namespace

ProbeWindow::ProbeWindow(const ProbeParams& params)
    : period_(seconds(params.period_s)), sample_period_(seconds(params.sample_period_s)) {
  set_limits(params);
}

void ProbeWindow::set_limits(const ProbeParams& params) {
  timeout_ = seconds(params.timeout_s);
  window_ = static_cast<std::size_t>(params.window);
  const double on_their_way = std::ceil(params.timeout_s / to_seconds(period_));
  memory_ = window_ + static_cast<std::size_t>(on_their_way) + 1;
}

void ProbeWindow::forget() {
  first_sequence_ = static_cast<std::uint16_t>(first_sequence_ + probes_.size());
  probes_.clear();
}

void ProbeWindow::start(Time now) {
  if (started_) return;
  started_ = true;
  next_probe_ = now;
  next_sample_ = now + sample_period_;
}

std::optional<std::uint16_t> ProbeWindow::take_due(Time now) {
  start(now);
  if (now < next_probe_) return std::nullopt;
  next_probe_ = next_slot(next_probe_, period_, now);
  probes_.push_back(Probe{now, std::nullopt, false});
  while (probes_.size() > memory_) {
    probes_.pop_front();
    ++first_sequence_;
  }
  return static_cast<std::uint16_t>(first_sequence_ + probes_.size() - 1);
}

ProbeWindow::Probe* ProbeWindow::find(std::uint16_t sequence) {
  // The difference wraps like the sequence number itself.
  const auto index = static_cast<std::uint16_t>(sequence - first_sequence_);
  return index < probes_.size() ? &probes_[index] : nullptr;
}

void ProbeWindow::on_sent(std::uint16_t sequence, Time at) {
  if (Probe* probe = find(sequence)) probe->sent = at;
}

void ProbeWindow::on_send_error(std::uint16_t sequence) {
  ++totals_.send_errors;
  if (Probe* probe = find(sequence)) probe->refused = true;
}

ReplyKind ProbeWindow::on_reply(std::uint16_t sequence, Time received_at) {
  Probe* probe = find(sequence);
  if (!probe || probe->refused) {
    ++totals_.unknown;
    return ReplyKind::unknown;
  }
  if (probe->rtt) {
    ++totals_.duplicates;
    return ReplyKind::duplicate;
  }
  if (received_at - probe->sent > timeout_) {
    ++totals_.late;
    return ReplyKind::late;
  }
  probe->rtt = std::max(received_at - probe->sent, Duration{0});
  return ReplyKind::accepted;
}

bool ProbeWindow::is_settled(const Probe& probe, Time now) const {
  return now - probe.sent > timeout_;
}

std::optional<ProbeSample> ProbeWindow::take_sample(Time now) {
  start(now);
  if (now < next_sample_) return std::nullopt;
  next_sample_ = next_slot(next_sample_, sample_period_, now);
  return summarize(now);
}

std::optional<ProbeSample> ProbeWindow::summarize(Time now) const {
  ProbeSample sample;
  for (auto probe = probes_.rbegin(); probe != probes_.rend(); ++probe) {
    if (static_cast<std::size_t>(sample.sent) == window_) break;
    if (!is_settled(*probe, now)) continue;
    ++sample.sent;
    if (!probe->rtt) continue;
    ++sample.received;
    add_rtt(sample.rtt, to_ms(*probe->rtt));
  }
  if (sample.sent == 0) return std::nullopt;
  if (sample.rtt) sample.rtt->mean_ms /= sample.received;
  sample.per_percent = 100.0 * (sample.sent - sample.received) / sample.sent;
  return sample;
}

Time ProbeWindow::next_deadline() const { return std::min(next_probe_, next_sample_); }

}  // namespace tocsin::network
