// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/background.hpp"
#include "link_map/link_grid.hpp"
#include "link_map/survey.hpp"

namespace tocsin {

/// Learns the map and saves readings beside its component, since both may take long. One thread
/// calls it.
class LinkMapWorker {
 public:
  explicit LinkMapWorker(std::unique_ptr<Background> background)
      : background_(std::move(background)) {}

  [[nodiscard]] bool is_busy() const { return background_->waiting() > 0; }
  /// At least LinkMap::least_places are there.
  void learn(link_map::Survey survey);
  void save(const std::string& path, std::vector<link_map::Reading> readings);

  /// The map that was learned since the last look.
  [[nodiscard]] std::optional<link_map::LinkGrid> take_grid();
  /// Why saving failed.
  [[nodiscard]] std::optional<std::string> take_error();

 private:
  std::mutex mutex_;
  std::optional<link_map::LinkGrid> grid_;
  std::optional<std::string> error_;
  // Last: ends before what it works on.
  std::unique_ptr<Background> background_;
};

}  // namespace tocsin
