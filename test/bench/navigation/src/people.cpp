// SPDX-License-Identifier: Apache-2.0
#include "people.hpp"

#include <algorithm>

namespace tocsin::bench {
namespace {

using geometry::Point;

constexpr double kept_m = 0.3;
constexpr double patience_s = 2;
constexpr double gives_way_s = 10;

double length_of(const laser::Walker& walker) {
  return distance(walker.way.front(), walker.way.back());
}

Point place_on(const laser::Walker& walker, double walked_m) {
  return between(walker.way.front(), walker.way.back(), walked_m / length_of(walker));
}

}  // namespace

People::People(const std::vector<laser::Walker>& walkers, bool look) : look_(look) {
  for (const laser::Walker& walker : walkers) people_.push_back({walker});
}

bool People::would_come_near(const Person& person, double walked_m, const Point& vehicle,
                             double vehicle_radius_m) const {
  const double away_m = distance(place_on(person.walker, walked_m), vehicle);
  const double near_m = person.walker.radius_m + vehicle_radius_m + kept_m;
  return look_ && away_m < near_m &&
         away_m < distance(place_on(person.walker, person.walked_m), vehicle);
}

void People::rest_at_end(Person& person, double way_m) {
  if (person.walked_m > 0 && person.walked_m < way_m) return;
  person.comes_back = person.walked_m > 0;
  person.rests_s = person.gives_way ? gives_way_s : person.walker.pause_s;
  person.gives_way = false;
}

void People::wait(Person& person, double step_s) {
  person.waited_s += step_s;
  if (person.waited_s < patience_s) return;
  person.comes_back = !person.comes_back;
  person.gives_way = true;
  person.waited_s = 0;
}

void People::walk(double step_s, const Point& vehicle, double vehicle_radius_m,
                  laser::Scene& scene) {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    Person& person = people_[i];
    const double way_m = length_of(person.walker);
    const double step_m = person.walker.speed_mps * step_s * (person.comes_back ? -1 : 1);
    const double next_m = std::clamp(person.walked_m + step_m, 0.0, way_m);
    if (person.rests_s > 0) {
      person.rests_s -= step_s;
    } else if (would_come_near(person, next_m, vehicle, vehicle_radius_m)) {
      wait(person, step_s);
    } else {
      person.walked_m = next_m;
      person.waited_s = 0;
      rest_at_end(person, way_m);
    }
    scene.place_walker(i, place_on(person.walker, person.walked_m));
  }
}

}  // namespace tocsin::bench
