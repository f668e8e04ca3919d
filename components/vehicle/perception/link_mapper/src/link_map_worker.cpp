// SPDX-License-Identifier: Apache-2.0
#include "link_mapper/link_map_worker.hpp"

#include <utility>

#include "foundation/replace_file.hpp"
#include "foundation/some_of.hpp"
#include "link_map/signal_file.hpp"

namespace tocsin {
namespace {

constexpr std::size_t most_places = 300;  // a tenth of a second of learning

}  // namespace

void LinkMapWorker::learn(link_map::Survey survey) {
  background_->post([this, survey = std::move(survey)] {
    const auto places = some_of(survey.places(), most_places);
    LinkGrid grid = grid_of(link_map::LinkMap(places), fit_loss_curve(survey.readings()), places);
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

std::optional<LinkGrid> LinkMapWorker::take_grid() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(grid_, std::nullopt);
}

std::optional<std::string> LinkMapWorker::take_error() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(error_, std::nullopt);
}

}  // namespace tocsin
