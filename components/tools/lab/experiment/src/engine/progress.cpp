// SPDX-License-Identifier: Apache-2.0
#include "engine/progress.hpp"

#include <cmath>
#include <cstdio>

namespace tocsin::experiment {

std::string clock_text(double s) {
  if (!std::isfinite(s) || s < 0) return "-:--";
  const long whole = std::lround(s);
  char text[40];
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  }
  return text;
}

std::string progress_text(std::size_t done, std::size_t total, double elapsed_s, double rate) {
  constexpr std::size_t width = 20;
  const std::size_t full = total > 0 ? width * done / total : width;
  const std::string bar = std::string(full, '#') + std::string(width - full, '.');
  const double left_s = rate > 0 ? static_cast<double>(total - done) / rate : std::nan("");
  char text[160];
  std::snprintf(text, sizeof text, "%zu of %zu runs [%s] %.0f %%, %s, %s left", done, total,
                bar.c_str(),
                total > 0 ? 100.0 * static_cast<double>(done) / static_cast<double>(total) : 100.0,
                clock_text(elapsed_s).c_str(), clock_text(left_s).c_str());
  return text;
}

Progress::Progress(std::size_t total, std::size_t done, bool terminal)
    : total_(total),
      done_(done),
      done_before_(done),
      terminal_(terminal),
      shown_tenth_(total > 0 ? 10 * done / total : 10) {
  if (done > 0) std::printf("%zu of %zu runs are there already\n", done, total);
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Progress::advance() {
  ++done_;
  const std::size_t tenth = 10 * done_ / total_;
  if (terminal_ || tenth != shown_tenth_) show();
  shown_tenth_ = tenth;
}

void Progress::show() {
  const double s = elapsed_s();
  const double rate = static_cast<double>(done_ - done_before_) / s;
  std::printf("%s%s%s", terminal_ ? "\r" : "", progress_text(done_, total_, s, rate).c_str(),
              terminal_ ? "  " : "\n");
  std::fflush(stdout);
}

void Progress::finish() {
  if (terminal_ && done_ > done_before_) std::printf("\n");
}

}  // namespace tocsin::experiment
