// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/parameters.hpp"
#include "link_map/survey.hpp"
#include "link_mapper/link_map_worker.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Learns where the link's signal is good while the vehicle drives, only where it knows its pose
/// well. What was measured lies beside the map and is carried over runs; the map is published as a
/// grid.
class LinkMapperComponent final : public Component {
 public:
  struct Params {
    std::string map_name;
    double learn_every_s = 20;
    double save_every_s = 30;
    double most_deviation_m = 0.3;
    template <class Visitor>
    void visit(Visitor& v) {
      v("map_name", map_name,
        "path of the map without its endings: readings lie in `map_name`.signal.csv; empty: "
        "nowhere");
      v("learn_every_s", learn_every_s, {1, 3600}, "[s] between looks for what the map shows anew");
      v("save_every_s", save_every_s, {1, 86400}, "[s] between saves, and at the end");
      v("most_deviation_m", most_deviation_m, {0.01, 10}, "[m] a pose less sure teaches nothing");
    }
  };

  /// Throws ConfigError when the file is there and is none of readings.
  LinkMapperComponent(Context& context, const Params& params);
  ~LinkMapperComponent() override;
  void tick(Time now) override;

 private:
  void take_pose(Time now);
  void take_quality(Time now);
  void learn(Time now);
  [[nodiscard]] nav_msgs::msg::OccupancyGrid message_of(const link_map::LinkGrid& grid,
                                                        Time now) const;
  void publish(Time now);
  void save(Time now);
  [[nodiscard]] bool keeps() const { return keeps_files_ && !params_.map_name.empty(); }
  [[nodiscard]] std::string file() const { return params_.map_name + ".signal.csv"; }

  Input<topic::AmclPose> pose_in_{*this};
  Input<topic::NetworkQuality> quality_{*this};
  Output<topic::LinkMap> map_{*this};
  Output<topic::LinkRisk> risk_{*this};

  const Params params_;
  const bool keeps_files_;
  link_map::Survey survey_;
  LinkMapWorker worker_;
  std::optional<geometry::Point> at_;  ///< empty: not known well
  Time at_since_{};
  int unlearned_ = 0;  ///< readings
  int unsaved_ = 0;
  Time next_learn_{};
  Time next_save_{};
};

}  // namespace tocsin
