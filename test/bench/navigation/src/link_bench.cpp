// SPDX-License-Identifier: Apache-2.0
// link_bench: what a map of the link buys a vehicle in halls full of racks, of which a quarter of
// the floor has no link: seconds without link by the way that is chosen, and the time until the
// link is back by where it turns after a loss. It drives at 0.5 m/s along what it has planned.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

#include "command_line/command.hpp"
#include "foundation/some_of.hpp"
#include "hall.hpp"
#include "link_map/link_map.hpp"
#include "link_map/loss_curve.hpp"
#include "link_map/survey.hpp"
#include "navigation/link_way.hpp"
#include "navigator/reconnection.hpp"

namespace tocsin::bench {
namespace {

using geometry::Path;
using geometry::Point;
using navigation::length_m;
using navigation::LinkRisk;
using std::chrono::steady_clock;

constexpr double speed_mps = 0.5;
constexpr double second_m = speed_mps;  // driven in one second

/// Points of a path, one for each second.
std::vector<Point> seconds_of(const Path& path) {
  std::vector<Point> points;
  double left_m = 0;  // to the next point
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length_m = distance(path[i - 1], path[i]);
    for (; left_m < length_m; left_m += second_m) {
      points.push_back(between(path[i - 1], path[i], left_m / length_m));
    }
    left_m -= length_m;
  }
  points.push_back(path.back());
  return points;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// A vehicle in one hall, with a map of its link.
class Vehicle {
 public:
  Vehicle(std::uint64_t seed, int survey_goals)
      : hall_(seed),
        random_(seed),
        costs_(std::make_shared<const navigation::CostMap>(hall_.floor(),
                                                           navigation::InflationParams{})),
        planner_(costs_) {
    learn(survey_goals);
  }

  /// At least 10 m apart; `ends_heard`: from and to places with a link.
  [[nodiscard]] Path random_way(bool ends_heard = false) {
    while (true) {
      const Point from = hall_.free_place(random_);
      const Point to = hall_.free_place(random_);
      if (distance(from, to) < 10 || (ends_heard && (is_lost(from) || is_lost(to)))) continue;
      auto path = planner_.plan(from, to);
      if (path) return *path;
    }
  }
  [[nodiscard]] int silent_s(const Path& path) {
    const auto points = seconds_of(path);
    return static_cast<int>(
        std::count_if(points.begin(), points.end(), [&](const Point& p) { return is_lost(p); }));
  }
  [[nodiscard]] navigation::WayChoice choose(const Path& shortest, double detour) {
    return navigation::LinkWayChooser(detour).choose(shortest, *costs_, *risk_,
                                                     risk_->on(costs_->grid()));
  }
  [[nodiscard]] bool is_lost(const Point& p) { return hall_.mean_dbm(p) < Hall::half_dbm; }
  void take_map_of(const Vehicle& other) { risk_ = other.risk_; }
  /// Knows where the link is lost.
  void know() {
    risk_ = risk_of([this](const Point& p) { return is_lost(p) ? 1.0 : 0.0; });
  }
  [[nodiscard]] double learned_in_ms() const { return learned_in_ms_; }

  /// Where a loss is noticed on the way: after so many seconds of silence.
  [[nodiscard]] std::optional<std::size_t> noticed_at(const std::vector<Point>& way, int after_s) {
    int silent = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
      silent = is_lost(way[i]) ? silent + 1 : 0;
      if (silent > after_s) return i;
    }
    return std::nullopt;
  }
  /// Seconds from there back along the track until it is heard.
  [[nodiscard]] double retracing_s(const std::vector<Point>& way, std::size_t at) {
    double s = 0;
    while (at > 0 && is_lost(way[at])) {
      --at;
      ++s;
    }
    return s;
  }
  struct Heard {
    double after_s = 0;
    Point at;
    bool is_heard = false;
  };
  /// The same by the map of the link.
  [[nodiscard]] Heard reconnect(const Point& from, const Point& goal) {
    Reconnection reconnection{Reconnection::Params{}};
    Heard heard{0, from};
    while (const auto place = reconnection.place(*costs_, *risk_, heard.at, goal, speed_mps)) {
      const auto path = planner_.plan(heard.at, *place);
      for (const Point& p : path ? seconds_of(*path) : std::vector<Point>{}) {
        heard.at = p;
        if (!is_lost(p)) return {heard.after_s, p, true};
        ++heard.after_s;
      }
      heard.after_s += Reconnection::Params{}.reconnect_wait_s;
      reconnection.give_up();
    }
    return heard;
  }
  [[nodiscard]] double way_s(const Point& from, const Point& to) {
    const auto path = planner_.plan(from, to);
    return path ? length_m(*path) / speed_mps : 0;
  }

 private:
  void learn(int goals) {
    link_map::Survey survey;
    std::normal_distribution<double> fading(0, 3);
    for (int i = 0; i < goals; ++i) {
      for (const Point& p : seconds_of(random_way())) {
        const double dbm = hall_.mean_dbm(p) + fading(random_);
        (void)survey.add({p, std::clamp(dbm, -120.0, 0.0), hall_.lost_share(dbm)});
      }
    }
    const auto begin = steady_clock::now();
    const link_map::LinkMap map(some_of(survey.places(), 300));
    const auto curve = link_map::fit_loss_curve(survey.readings());
    risk_ = risk_of([&](const Point& p) { return risk(curve, map.predict(p)); });
    learned_in_ms_ = std::chrono::duration<double, std::milli>(steady_clock::now() - begin).count();
  }

  template <class Of>
  static LinkRisk risk_of(const Of& of) {
    const navigation::Grid grid{60, 40, 0.5, {0, 0}};
    std::vector<std::int8_t> percent;
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        percent.push_back(
            static_cast<std::int8_t>(std::lround(100 * of(grid.centre({column, row})))));
      }
    }
    return {grid, std::move(percent)};
  }

  Hall hall_;
  std::mt19937_64 random_;
  std::shared_ptr<const navigation::CostMap> costs_;
  navigation::Planner planner_;
  std::optional<LinkRisk> risk_;
  double learned_in_ms_ = 0;
};

/// Sums over many ways.
struct Sums {
  double shortest_s = 0, shortest_m = 0, chosen_s = 0, chosen_m = 0;
  int worse = 0, ways = 0;
  std::vector<double> plan_ms;
  void add(Vehicle& vehicle, double detour, bool ends_heard) {
    const Path shortest = vehicle.random_way(ends_heard);
    const auto begin = steady_clock::now();
    const auto choice = vehicle.choose(shortest, detour);
    plan_ms.push_back(
        std::chrono::duration<double, std::milli>(steady_clock::now() - begin).count());
    const int before_s = vehicle.silent_s(shortest);
    const int after_s = vehicle.silent_s(choice.way.path);
    shortest_s += before_s;
    chosen_s += after_s;
    shortest_m += length_m(shortest);
    chosen_m += choice.way.length_m;
    worse += after_s > before_s ? 1 : 0;
    ++ways;
  }
  void print(const char* map, int goals, double detour, bool ends_heard) const {
    fmt::print("| {} | {} | {} | {:.2f} | {:.1f} | {:.1f} | {:.2f} | {:.3f} | {:.1f} | {:.1f} |\n",
               ends_heard ? "with link" : "anywhere", map, goals, detour, shortest_s / ways,
               chosen_s / ways, chosen_s / shortest_s, chosen_m / shortest_m, 100.0 * worse / ways,
               median(plan_ms));
    std::fflush(stdout);
  }
};

void print_ways(int halls) {
  fmt::print(
      "| ends | map of | learned on, ways | link_detour | without link, shortest, s | chosen, s | "
      "ratio | "
      "way, ratio | more silence, % of ways | chosen in, ms |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  constexpr int ways = 20;
  const auto print = [&](const char* map, int goals, double detour, bool ends_heard,
                         auto&& prepare) {
    Sums sums;
    for (int seed = 1; seed <= halls; ++seed) {
      Vehicle vehicle(static_cast<std::uint64_t>(seed), goals);
      prepare(vehicle, seed);
      for (int i = 0; i < ways; ++i) sums.add(vehicle, detour, ends_heard);
    }
    sums.print(map, goals, detour, ends_heard);
  };
  const auto as_learned = [](Vehicle&, int) {};
  const auto foreign = [&](Vehicle& vehicle, int seed) {
    vehicle.take_map_of(Vehicle(static_cast<std::uint64_t>(seed + halls), 10));
  };
  const auto true_map = [](Vehicle& vehicle, int) { vehicle.know(); };
  for (const bool ends_heard : {true, false}) {
    for (const int goals : {3, 10, 30}) print("this hall", goals, 0.15, ends_heard, as_learned);
    print("this hall", 10, 0.3, ends_heard, as_learned);
    print("this hall, the truth", 10, 0.15, ends_heard, true_map);
    print("another hall", 10, 0.15, ends_heard, foreign);
  }
}

void print_losses(int halls, int after_s) {
  std::vector<double> retracing_s, reconnecting_s, retraced_s, reconnected_s;
  int lost = 0;
  for (int seed = 1; seed <= halls; ++seed) {
    Vehicle vehicle(static_cast<std::uint64_t>(seed), 10);
    for (int i = 0; i < 10; ++i) {
      const auto way = seconds_of(vehicle.random_way());
      const auto at = vehicle.noticed_at(way, after_s);
      if (!at || vehicle.is_lost(way.front())) continue;
      const double back_s = vehicle.retracing_s(way, *at);
      const auto heard = vehicle.reconnect(way[*at], way.back());
      lost += heard.is_heard ? 0 : 1;
      const auto back_at = *at - static_cast<std::size_t>(back_s);
      retracing_s.push_back(back_s);
      reconnecting_s.push_back(heard.after_s);
      retraced_s.push_back(back_s + vehicle.way_s(way[back_at], way.back()));
      reconnected_s.push_back(heard.after_s + vehicle.way_s(heard.at, way.back()));
    }
  }
  fmt::print("| {} | {} | {} | {:.1f} | {:.0f} | {:.1f} | {:.1f} | {:.0f} | {:.1f} |\n", after_s,
             retracing_s.size(), lost, mean(retracing_s), median(retracing_s), mean(retraced_s),
             mean(reconnecting_s), median(reconnecting_s), mean(reconnected_s));
  std::fflush(stdout);
}

int run(int halls) {
  print_ways(halls);
  fmt::print(
      "\n| noticed after, s | losses | without a place | back along the track: heard after, mean, "
      "s | "
      "median, s | at the goal after, s | reconnect: heard after, mean, s | median, s | at the "
      "goal "
      "after, s |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const int after_s : {5, 15, 30}) print_losses(halls, after_s);
  return 0;
}

}  // namespace
}  // namespace tocsin::bench

int main(int argc, char** argv) {
  int halls = 100;
  CLI::App app("What a map of the link buys a vehicle in halls with dead zones.");
  app.name("link_bench");
  app.add_option("--halls", halls, "random halls")->check(CLI::Range(1, 10000));
  return tocsin::run_command(app, argc, argv, [&] { return tocsin::bench::run(halls); });
}
