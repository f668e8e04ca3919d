// SPDX-License-Identifier: Apache-2.0
#include "link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"
#include "link_map/link_map.hpp"
#include "link_map/loss_curve.hpp"
#include "link_map/signal_file.hpp"

namespace tocsin::map_tool {
namespace {

using link_map::LinkMap;
using link_map::Place;
using Places = std::vector<Place>;

constexpr std::size_t longest_file = 500'000'000;  // [byte]
constexpr double normal_95 = 1.96;

struct Parts {
  Places learned;
  Places left_out;
};

Parts at_random(const Places& places, double share, std::uint64_t seed) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  std::vector<bool> is_left_out(places.size(), false);
  const auto count =
      static_cast<std::size_t>(std::lround(share * static_cast<double>(places.size())));
  for (std::size_t i = 0; i < count; ++i) is_left_out[order[i]] = true;
  Parts parts;
  for (std::size_t i = 0; i < places.size(); ++i) {
    (is_left_out[i] ? parts.left_out : parts.learned).push_back(places[i]);
  }
  return parts;
}

/// Places are in the order in which they were first met: what comes later was not met before.
Parts split(const Places& places, const LinkOptions& options) {
  if (!options.after) return at_random(places, options.leave_out, options.seed);
  const auto until =
      static_cast<std::ptrdiff_t>(*options.after * static_cast<double>(places.size()));
  return {{places.begin(), places.begin() + until}, {places.begin() + until, places.end()}};
}

/// Also of NaN, which a range of CLI11 lets pass.
void check_share(const char* option, double share, double low, double high) {
  if (share >= low && share <= high) return;
  throw ConfigError(fmt::format("{}: {} is outside [{}, {}]", option, share, low, high));
}

struct Score {
  double map_db = 0;
  double path_loss_db = 0;
  double nearest_db = 0;
  double within_95 = 0;
};

double nearest_dbm(const Places& places, const geometry::Point& at) {
  return std::min_element(places.begin(), places.end(),
                          [&](const Place& a, const Place& b) {
                            return distance(a.at, at) < distance(b.at, at);
                          })
      ->signal_dbm;
}

Score score_of(const LinkMap& map, const Parts& parts) {
  std::vector<geometry::Point> at;
  Eigen::VectorXd signals(static_cast<Eigen::Index>(parts.learned.size()));
  for (const Place& place : parts.learned) {
    signals(static_cast<Eigen::Index>(at.size())) = place.signal_dbm;
    at.push_back(place.at);
  }
  const link_map::PathLoss alone = link_map::fit_path_loss(at, signals);
  Score score;
  for (const Place& place : parts.left_out) {
    const auto said = map.predict(place.at);
    const auto squared = [&](double dbm) { return std::pow(dbm - place.signal_dbm, 2); };
    score.map_db += squared(said.mean_dbm);
    score.path_loss_db += squared(alone.signal_dbm(place.at));
    score.nearest_db += squared(nearest_dbm(parts.learned, place.at));
    const double off_db = std::abs(said.mean_dbm - place.signal_dbm);
    score.within_95 += off_db <= normal_95 * said.deviation_db ? 1 : 0;
  }
  const auto count = static_cast<double>(parts.left_out.size());
  for (double* const sum : {&score.map_db, &score.path_loss_db, &score.nearest_db}) {
    *sum = std::sqrt(*sum / count);
  }
  score.within_95 /= count;
  return score;
}

/// Nothing where no reading tells loss.
std::optional<double> half_lost_dbm(const std::vector<link_map::Reading>& readings) {
  const bool is_told = std::any_of(readings.begin(), readings.end(), [](const auto& reading) {
    return std::isfinite(reading.lost_share);
  });
  if (!is_told) return std::nullopt;
  return link_map::fit_loss_curve(readings).half_dbm;
}

std::string json_of(const LinkMap& map, const Parts& parts, const Score& score,
                    std::optional<double> half_dbm) {
  const auto& loss = map.path_loss();
  nlohmann::ordered_json json{{"places", parts.learned.size() + parts.left_out.size()},
                              {"left_out", parts.left_out.size()},
                              {"error_db", score.map_db},
                              {"within_95", score.within_95},
                              {"path_loss_error_db", score.path_loss_db},
                              {"nearest_error_db", score.nearest_db},
                              {"shadowing_db", std::sqrt(map.field().variance_db2)},
                              {"range_m", map.field().range_m},
                              {"noise_db", std::sqrt(map.field().noise_db2)},
                              {"exponent", loss.exponent},
                              {"at_1_m_dbm", loss.at_1_m_dbm},
                              {"access_point", {loss.access_point.x_m, loss.access_point.y_m}}};
  if (half_dbm) json["half_lost_dbm"] = *half_dbm;
  return json.dump() + "\n";
}

std::string text_of(const LinkMap& map, const Parts& parts, const Score& score,
                    std::optional<double> half_dbm) {
  const auto& loss = map.path_loss();
  const std::string told = fmt::format(
      "{} places, {} of them left out\n"
      "map         {:5.2f} dB, {:.0f} % within the 95 % interval\n"
      "path loss   {:5.2f} dB\n"
      "nearest     {:5.2f} dB\n"
      "shadowing {:.1f} dB over {:g} m, noise {:.1f} dB; {:.0f} dBm at 1 m, exponent {:.1f}, "
      "access "
      "point about ({:.0f}, {:.0f})\n",
      parts.learned.size() + parts.left_out.size(), parts.left_out.size(), score.map_db,
      100 * score.within_95, score.path_loss_db, score.nearest_db,
      std::sqrt(map.field().variance_db2), map.field().range_m, std::sqrt(map.field().noise_db2),
      loss.at_1_m_dbm, loss.exponent, loss.access_point.x_m, loss.access_point.y_m);
  if (!half_dbm) return told;
  return told + fmt::format("half of the packets are lost at {:.0f} dBm\n", *half_dbm);
}

}  // namespace

std::string link(const LinkOptions& options) {
  check_share("--leave-out", options.leave_out, 0.01, 0.9);
  check_share("--after", options.after.value_or(0.5), 0.1, 0.95);
  const std::string name = printable(options.file);
  const auto readings =
      link_map::signals_in(read_file(options.file, longest_file), name, options.columns);
  const Places places = LinkMap::places_of(readings);
  const Parts parts = split(places, options);
  if (parts.learned.size() < LinkMap::least_places || parts.left_out.empty()) {
    throw ConfigError(
        fmt::format("{}: {} places of {:g} m with a signal within [-120, 0] dBm leave {} to learn "
                    "from and {} to "
                    "foretell; at least {} and 1 are needed",
                    name, places.size(), LinkMap::place_m, parts.learned.size(),
                    parts.left_out.size(), LinkMap::least_places));
  }
  const LinkMap map(parts.learned);
  const Score score = score_of(map, parts);
  const auto half_dbm = half_lost_dbm(readings);
  return options.json ? json_of(map, parts, score, half_dbm) : text_of(map, parts, score, half_dbm);
}

}  // namespace tocsin::map_tool
