// SPDX-License-Identifier: Apache-2.0
#include "link_mapper/link_map_worker.hpp"

#include <utility>

#include "foundation/replace_file.hpp"

namespace tocsin {
namespace {

constexpr std::size_t most_places = 300;  // a tenth of a second of learning

std::vector<link_map::Place> some_of(std::vector<link_map::Place> all) {
  if (all.size() <= most_places) return all;
  std::vector<link_map::Place> some;
  for (std::size_t i = 0; i < most_places; ++i) some.push_back(all[i * all.size() / most_places]);
  return some;
}

}  // namespace

void LinkMapWorker::learn(std::vector<link_map::Place> places) {
  background_->post([this, places = some_of(std::move(places))] {
    SignalGrid grid = grid_of(link_map::LinkMap(places), places);
    const std::lock_guard<std::mutex> lock(mutex_);
    grid_ = std::move(grid);
  });
}

void LinkMapWorker::save(const std::string& path, std::string text) {
  background_->post([this, path, text = std::move(text)] {
    const auto failed = replace_file(path, text);
    if (!failed) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = failed.message();
  });
}

std::optional<SignalGrid> LinkMapWorker::take_grid() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(grid_, std::nullopt);
}

std::optional<std::string> LinkMapWorker::take_error() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(error_, std::nullopt);
}

}  // namespace tocsin
