// SPDX-License-Identifier: Apache-2.0
#include "link_mapper/link_map_worker.hpp"

#include <utility>

#include "foundation/replace_file.hpp"
#include "link_map/signal_file.hpp"

namespace tocsin {
void LinkMapWorker::learn(link_map::Survey survey) {
  background_->post([this, survey = std::move(survey)] {
    link_map::LinkGrid grid = grid_of(survey);
    const std::lock_guard<std::mutex> lock(mutex_);
    grid_ = std::move(grid);
  });
}

void LinkMapWorker::save(const std::string& path, std::vector<link_map::Reading> readings) {
  background_->post([this, path, readings = std::move(readings)] {
    const auto failed = replace_file(path, link_map::signal_text(readings));
    if (!failed) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = failed.message();
  });
}

std::optional<link_map::LinkGrid> LinkMapWorker::take_grid() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(grid_, std::nullopt);
}

std::optional<std::string> LinkMapWorker::take_error() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(error_, std::nullopt);
}

}  // namespace tocsin
