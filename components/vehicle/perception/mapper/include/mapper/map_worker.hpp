// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "devices/background.hpp"
#include "mapping/global_mapper.hpp"
#include "mapping/map_painter.hpp"

namespace tocsin {

/// The slow half of mapping beside its component: joins what the matching makes, paints, saves.
/// All of it is posted; what comes of it is taken later. One thread calls it.
class MapWorker {
 public:
  /// What has come since the last look.
  struct News {
    std::optional<geometry::Pose> map_from_local;
    std::vector<mapping::MapPainter::Change> tiles;
    std::size_t nodes = 0;
    std::size_t loops = 0;
  };
  struct Saved {
    std::uint64_t ticket = 0;
    std::string path;
    std::string error;  ///< empty: it is on disk
  };

  MapWorker(std::unique_ptr<Background> background, const mapping::MapperParams& params,
            double resolution_m);
  /// The same that goes on with a session.
  MapWorker(std::unique_ptr<Background> background, const mapping::MapperParams& params,
            double resolution_m, mapping::MapSession session);

  /// See GlobalMapper; at once, so only before anything is posted.
  [[nodiscard]] std::optional<geometry::Pose> locate(const laser::Scan& scan,
                                                     const geometry::Pose& guess) const;
  [[nodiscard]] std::size_t nodes_at_start() const { return nodes_at_start_; }

  void add(mapping::LocalStep step);
  /// Paints what is new; all anew where the map has moved, if that is wanted.
  void paint(bool may_begin_anew);
  /// Saves `path`.yaml and `path`.pgm, or `path`.session; both answer with this ticket.
  std::uint64_t save_map(const std::string& path);
  std::uint64_t save_session(const std::string& path);

  /// Posted and not done.
  [[nodiscard]] std::size_t waiting() const { return background_->waiting(); }
  [[nodiscard]] News take_news();
  [[nodiscard]] std::vector<Saved> take_saved();

 private:
  template <class Save>
  std::uint64_t post_save(const std::string& path, Save save);
  void tell();

  std::size_t nodes_at_start_ = 0;
  std::uint64_t tickets_ = 0;
  // Of the background.
  mapping::GlobalMapper mapper_;
  mapping::MapPainter painter_;
  // Between both.
  std::mutex mutex_;
  News news_;
  std::vector<Saved> saved_;
  // Last: ends before what it works on.
  std::unique_ptr<Background> background_;
};

}  // namespace tocsin
