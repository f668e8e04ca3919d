// SPDX-License-Identifier: Apache-2.0
#include "mapper/map_worker.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"
#include "mapping/session_bytes.hpp"
#include "navigation/map_writer.hpp"

namespace tocsin {

MapWorker::MapWorker(std::unique_ptr<Background> background, const mapping::MapperParams& params,
                     double resolution_m)
    : mapper_(params), painter_(resolution_m), background_(std::move(background)) {}

MapWorker::MapWorker(std::unique_ptr<Background> background, const mapping::MapperParams& params,
                     double resolution_m, mapping::MapSession session)
    : nodes_at_start_(session.nodes.size()),
      mapper_(params, std::move(session)),
      painter_(resolution_m),
      background_(std::move(background)) {}

std::optional<geometry::Pose> MapWorker::locate(const laser::Scan& scan,
                                                const geometry::Pose& guess) const {
  constexpr double reach_m = 6;
  const mapping::SearchWindow window{1.5, 0.6};
  return mapper_.locate(scan, guess, reach_m, window);
}

void MapWorker::add(mapping::LocalStep step) {
  // A function that can be copied holds it.
  auto held = std::make_shared<mapping::LocalStep>(std::move(step));
  background_->post([this, held] {
    mapper_.add(std::move(*held));
    tell();
  });
}

void MapWorker::tell() {
  const geometry::Pose& local = mapper_.nodes().back().pose;
  const geometry::Pose map_from_local = compose(mapper_.poses().back(), inverse(local));
  const std::lock_guard<std::mutex> lock(mutex_);
  news_.map_from_local = map_from_local;
  news_.nodes = mapper_.nodes().size();
  news_.loops = mapper_.loops();
}

void MapWorker::paint(bool may_begin_anew) {
  background_->post([this, may_begin_anew] {
    painter_.paint(mapper_, may_begin_anew);
    auto changes = painter_.take_changes();
    const std::lock_guard<std::mutex> lock(mutex_);
    std::move(changes.begin(), changes.end(), std::back_inserter(news_.tiles));
  });
}

template <class Save>
std::uint64_t MapWorker::post_save(const std::string& path, Save save) {
  const std::uint64_t ticket = ++tickets_;
  background_->post([this, path, ticket, save] {
    std::string error;
    try {
      save();
    } catch (const ConfigError& failed) {
      error = failed.what();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    saved_.push_back({ticket, path, std::move(error)});
  });
  return ticket;
}

std::uint64_t MapWorker::save_map(const std::string& path) {
  return post_save(path, [this, path] {
    painter_.paint(mapper_, true);
    auto changes = painter_.take_changes();
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      std::move(changes.begin(), changes.end(), std::back_inserter(news_.tiles));
    }
    if (painter_.tiles().tiles().empty()) throw ConfigError(path + ": there is no map yet");
    navigation::write_map(painter_.tiles().map(), path);
  });
}

std::uint64_t MapWorker::save_session(const std::string& path) {
  return post_save(path, [this, path] {
    const std::string file = path + ".session";
    if (mapper_.nodes().empty()) throw ConfigError(file + ": there is no map yet");
    const auto failed = replace_file(file, bytes_of(mapper_.session()));
    if (failed) throw ConfigError(fmt::format("{}: {}", file, failed.message()));
  });
}

MapWorker::News MapWorker::take_news() {
  const std::lock_guard<std::mutex> lock(mutex_);
  News news = std::move(news_);
  news_ = {};
  news_.nodes = news.nodes;
  news_.loops = news.loops;
  return news;
}

std::vector<MapWorker::Saved> MapWorker::take_saved() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(saved_, {});
}

}  // namespace tocsin
