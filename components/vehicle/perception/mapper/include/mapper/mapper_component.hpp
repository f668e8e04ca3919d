// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "foundation/parameters.hpp"
#include "foundation/state_file.hpp"
#include "geometry/twist.hpp"
#include "map_ports/map_output.hpp"
#include "map_ports/pose_output.hpp"
#include "mapper/map_worker.hpp"
#include "mapper/tile_queue.hpp"
#include "mapping/local_mapper.hpp"
#include "ros_idl/nav2_msgs.hpp"
#include "ros_idl/slam_toolbox.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "runtime/service_port.hpp"
#include "scan_input/pose_history.hpp"
#include "scan_input/scan_input.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Under the name that nav2's map saver has.
struct SaveMap {
  using Request = nav2_msgs::srv::SaveMap_Request;
  using Response = nav2_msgs::srv::SaveMap_Response;
  static constexpr const char* name = "map_saver/save_map";
};
/// Under the name that slam_toolbox has.
struct SerializePoseGraph {
  using Request = slam_toolbox::srv::SerializePoseGraph_Request;
  using Response = slam_toolbox::srv::SerializePoseGraph_Response;
  static constexpr const char* name = "slam_toolbox/serialize_map";
};

/// Makes a map of what the laser sees while the vehicle drives, and tells where it is on it, as a
/// localiser does. Matching is done with each scan; what takes longer goes on beside it.
class MapperComponent final : public Component {
 public:
  struct Params {
    double start_x_m = 0;
    double start_y_m = 0;
    double start_yaw_rad = 0;
    std::string map_name;
    std::string session_file;
    double save_every_s = 30;
    double paint_every_s = 1;
    double tile_hz = 4;
    double repeat_hz = 1;
    int most_scans = 20000;
    template <class Visitor>
    void visit(Visitor& v) {
      v("start_x_m", start_x_m, {-1e5, 1e5}, "[m] where the vehicle begins, map frame");
      v("start_y_m", start_y_m, {-1e5, 1e5}, "[m]");
      v("start_yaw_rad", start_yaw_rad, {-7, 7}, "[rad]");
      v("map_name", map_name,
        "path of the files that the map is saved in, without their endings; empty: on request "
        "only");
      v("session_file", session_file, "goes on with this saved session; empty: a new map");
      v("save_every_s", save_every_s, {1, 86400}, "[s] between saves, and at the end");
      v("paint_every_s", paint_every_s, {0.2, 60}, "[s] between looks for what the map shows anew");
      v("tile_hz", tile_hz, {0.1, 100}, "[Hz] tiles that have changed, over the radio");
      v("repeat_hz", repeat_hz, {0, 100}, "[Hz] tiles that are sent again; 0: never");
      v("most_scans", most_scans, {10, 1000000}, "[1] on the map; then it grows no more");
    }
  };

  /// Throws ConfigError when the session cannot be read, or a map of that name is there already.
  MapperComponent(Context& context, const Params& params);
  ~MapperComponent() override;
  void tick(Time now) override;

 private:
  struct Start {
    geometry::Pose pose;
    std::string session;                          ///< file; empty: a new map
    std::optional<geometry::Pose> map_from_odom;  ///< of a process of this launch before this one
  };
  struct SaveCall {
    CallId id;
    bool is_session;
  };
  [[nodiscard]] static Start start_of(const StateFile& file, const Context& context,
                                      const Params& params);
  void take_odometry();
  void take_scan(Time now);
  void begin(const ScanInput::Turn& turn, const geometry::Pose& odometry);
  [[nodiscard]] geometry::Pose place_in_session(const laser::Scan& scan,
                                                const geometry::Pose& guess);
  void use(const ScanInput::Turn& turn, const geometry::Pose& odometry);
  [[nodiscard]] geometry::Pose pose_at(const geometry::Pose& odometry) const;
  void publish_pose(const geometry::Pose& odometry, std::int64_t stamp_ns);
  void take_calls();
  [[nodiscard]] std::string path_of(const std::string& name) const;
  void take_news(Time now);
  void take_saved();
  void send_tiles(Time now);
  void send_tile(navigation::TileMap::Index index, Time now);
  void save(Time now);
  void publish_diagnostics(Time now);
  void remember(Time now);
  [[nodiscard]] bool is_full() const;

  Input<topic::Odom> odom_{*this, WakeMode::time_triggered};
  ScanInput scan_{*this};
  Server<SaveMap> save_map_{*this};
  Server<SerializePoseGraph> serialize_{*this};
  MapOutput map_;
  PoseOutput pose_{*this};
  Output<topic::MapTiles> map_tiles_{*this};
  Output<topic::Diagnostics> diagnostics_{*this};

  const Params params_;
  StateFile file_;
  const bool keeps_files_;
  const Start start_;
  MapWorker worker_;
  std::optional<mapping::LocalMapper> local_;  ///< since the first scan
  PoseHistory odometry_;
  std::optional<geometry::Pose> last_odom_;
  std::int64_t last_odom_ns_ = 0;
  geometry::Twist velocity_;
  geometry::Pose map_from_local_;
  geometry::Pose last_pose_;
  double unmatched_m_ = 0;  ///< driven since a scan was matched
  bool is_matched_ = false;
  bool is_late_ = false;  ///< scans are passed over
  bool was_full_ = false;
  std::size_t nodes_ = 0;
  std::size_t loops_ = 0;
  std::size_t saved_nodes_ = 0;
  std::uint32_t session_ = 0;
  TileQueue queue_;
  std::map<std::uint64_t, SaveCall> calls_;  ///< by ticket
  Time next_paint_{};
  Time next_anew_{};
  Time next_tile_{};
  Time next_repeat_{};
  Time next_save_{};
  Time next_diagnostics_{};
  Time next_remember_{};
};

}  // namespace tocsin
