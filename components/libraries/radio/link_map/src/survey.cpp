// SPDX-License-Identifier: Apache-2.0
#include "link_map/survey.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin::link_map {
namespace {

constexpr double least_dbm = -120;
constexpr double most_m = 1e6;
constexpr std::size_t most_readings = 64;  // of a place

bool is_good(const Reading& reading) {
  return std::abs(reading.at.x_m) < most_m && std::abs(reading.at.y_m) < most_m &&
         reading.signal_dbm >= least_dbm && reading.signal_dbm <= 0;
}

/// Mean of the middle half: fading has a long tail downwards.
double midmean(const std::vector<Reading>& readings) {
  std::vector<double> values;
  for (const Reading& reading : readings) values.push_back(reading.signal_dbm);
  std::sort(values.begin(), values.end());
  const std::size_t cut = values.size() / 4;
  double sum = 0;
  for (std::size_t i = cut; i < values.size() - cut; ++i) sum += values[i];
  return sum / static_cast<double>(values.size() - 2 * cut);
}

}  // namespace

bool Survey::add(const Reading& reading) {
  if (!is_good(reading)) return false;
  const std::pair<long, long> cell{std::lround(std::floor(reading.at.x_m / LinkMap::place_m)),
                                   std::lround(std::floor(reading.at.y_m / LinkMap::place_m))};
  const auto [at, is_new] = known_.emplace(cell, squares_.size());
  if (is_new) squares_.push_back({});
  Square& square = squares_[at->second];
  const double share = 1.0 / ++square.count;
  square.mean = between(square.mean, reading.at, share);
  if (square.kept.size() < most_readings) square.kept.push_back(reading);
  square.kept[static_cast<std::size_t>(square.count - 1) % most_readings] = reading;
  return true;
}

std::vector<Place> Survey::places() const {
  std::vector<Place> places;
  for (const Square& square : squares_) {
    places.push_back({square.mean, midmean(square.kept), square.count});
  }
  return places;
}

std::vector<Reading> Survey::readings() const {
  std::vector<Reading> readings;
  for (const Square& square : squares_) {
    const std::size_t size = square.kept.size();
    const std::size_t oldest = size < most_readings ? 0 : static_cast<std::size_t>(square.count);
    for (std::size_t i = 0; i < size; ++i) readings.push_back(square.kept[(oldest + i) % size]);
  }
  return readings;
}

}  // namespace tocsin::link_map
