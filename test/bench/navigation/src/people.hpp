// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "laser_model/scene.hpp"

namespace tocsin::bench {

/// Persons who walk to and fro, each on a straight way of his own. Those who look wait where they
/// would come within 0.3 m of the vehicle; after 2 s they turn round, and let it pass at their
/// end for 10 s. The others walk on, also into it.
class People {
 public:
  explicit People(const std::vector<laser::Walker>& walkers = {}, bool look = false);

  /// Lets them walk for a while, and puts them into the scene of these walkers.
  void walk(double step_s, const geometry::Point& vehicle, double vehicle_radius_m,
            laser::Scene& scene);

 private:
  struct Person {
    laser::Walker walker;
    double walked_m = 0;
    bool comes_back = false;
    double rests_s = 0;   ///< still, at an end
    double waited_s = 0;  ///< before the vehicle
    bool gives_way = false;
  };
  [[nodiscard]] bool would_come_near(const Person& person, double walked_m,
                                     const geometry::Point& vehicle, double vehicle_radius_m) const;
  static void rest_at_end(Person& person, double way_m);
  static void wait(Person& person, double step_s);

  std::vector<Person> people_;
  bool look_;
};

}  // namespace tocsin::bench
