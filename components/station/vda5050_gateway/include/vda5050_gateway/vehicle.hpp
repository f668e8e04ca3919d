// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/numbers.hpp"
#include "geometry/pose.hpp"

namespace tocsin::vda5050 {

/// What the station knows of the vehicle, as its topics told it last.
struct Vehicle {
  std::optional<geometry::Pose> pose;  ///< map frame
  double deviation_m = 0;              ///< of the pose, two standard deviations
  std::string navigation;              ///< as NavigationStatus.state
  std::string navigation_reason;       ///< as NavigationStatus.reason
  std::string mission;                 ///< as MissionStatus.state
  std::size_t waypoint = 0;            ///< of the mission, that is driven to, from 0
  std::vector<geometry::Point> way;    ///< all waypoints of the mission
  double charge_percent = 0;           ///< 0 while it is not known
  std::optional<double> voltage_v;
  bool is_charging = false;
  bool emergency_stop = false;
  bool stopped_by_station = false;  ///< else, where a stop stands, by somebody on the vehicle
  bool bumper = false;
  bool hazard = false;  ///< cliff or wheel drop
  std::string driver;   ///< who drives by hand; empty: nobody
  std::uint32_t docking_run = 0;
  std::string docking;          ///< as DockingStatus.state; empty: never heard of
  std::string docking_result;   ///< as DockingStatus.result
  double silence_s = infinity;  ///< since the vehicle was heard
  std::optional<double> qni_percent;
};

/// What the vehicle is asked for.
struct Request {
  enum class Kind : std::uint8_t {
    drive,
    cancel_drive,
    pause,
    resume,
    dock,
    cancel_dock,
    set_pose
  };
  Kind kind = Kind::drive;
  std::vector<geometry::Pose> poses = {};  ///< of drive: one after the other; of set_pose: one
};

/// What comes of the drive that was asked for last.
struct DriveNews {
  enum class Kind : std::uint8_t {
    at,          ///< on its way to pose `index`
    succeeded,   ///< all poses were reached
    aborted,     ///< it goes no further
    canceled,    ///< it stands, as somebody asked
    rejected,    ///< it does not begin
    unanswered,  ///< nobody leads vehicles
  };
  Kind kind = Kind::at;
  std::uint32_t index = 0;
  std::string reason = {};
};

}  // namespace tocsin::vda5050
