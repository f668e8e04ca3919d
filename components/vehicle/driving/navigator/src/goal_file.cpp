// SPDX-License-Identifier: Apache-2.0
#include "navigator/goal_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <sstream>

namespace tocsin {
namespace {

/// Shorter than a shortest number that gives a double back: StateFile has room for so many.
void write(std::ostream& text, const navigation::Waypoint& place) {
  text << ' ' << place.x_m << ' ' << place.y_m << ' ' << place.heading_rad << ' ' << place.send_s;
}

std::istream& read(std::istream& text, navigation::Waypoint& place) {
  return text >> place.x_m >> place.y_m >> place.heading_rad >> place.send_s;
}

}  // namespace

std::optional<Goal> GoalFile::load() const {
  std::istringstream text(file_.load().value_or(""));
  Goal goal;
  pid_t parent = 0;
  Duration::rep expires = 0;
  std::size_t ahead = 0;
  text >> parent >> goal.mission >> goal.id >> goal.tolerance_m >> expires >> ahead;
  if (!text || parent != ::getppid() || ahead > most_ahead) return std::nullopt;
  goal.expires = Time{Duration{expires}};
  goal.ahead.resize(ahead);
  (void)read(text, goal.pose);
  for (navigation::Waypoint& place : goal.ahead) (void)read(text, place);
  return text ? std::optional(std::move(goal)) : std::nullopt;
}

bool GoalFile::save(const Goal& goal) {
  if (!file_.keeps()) return true;
  const std::size_t ahead = std::min(goal.ahead.size(), most_ahead);
  std::ostringstream text;
  text << ::getppid() << ' ' << goal.mission << ' ' << goal.id << ' ' << goal.tolerance_m << ' '
       << goal.expires.time_since_epoch().count() << ' ' << ahead;
  text.setf(std::ios::fixed);
  text.precision(3);
  write(text, goal.pose);
  for (std::size_t i = 0; i < ahead; ++i) write(text, goal.ahead[i]);
  return keep(text.str());
}

bool GoalFile::keep(const std::string& text) {
  if (!file_.keeps() || text == saved_) return true;
  if (!file_.save(text)) return false;
  saved_ = text;
  return true;
}

}  // namespace tocsin
