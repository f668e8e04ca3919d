// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/pose.hpp"
#include "vda5050_gateway/protocol.hpp"

namespace tocsin::vda5050 {

inline constexpr std::size_t most_message_bytes = 256 * 1024;  ///< of a message that is taken
inline constexpr std::size_t most_nodes = 1000;                ///< of an order
inline constexpr std::size_t most_id_bytes = 128;              ///< of an identifier
inline constexpr double farthest_m = 1e6;                      ///< of a position, along an axis

/// Something to do on a node, or at once.
struct Action {
  std::string type;
  std::string id;
  nlohmann::json parameters = nlohmann::json::object();  ///< value by key

  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const;
};

struct Node {
  std::string id;
  std::uint32_t sequence = 0;
  bool released = false;  ///< base; false: horizon
  geometry::Pose pose;    ///< map frame; a node without `theta` has the heading of the way to it
  /// Where the vehicle counts as on the node: an ellipse with these half axes [m], the first one in
  /// direction `deviation_rad`.
  double deviation_a_m = 0;
  double deviation_b_m = 0;
  double deviation_rad = 0;
  std::vector<Action> actions = {};
};

struct Edge {
  std::string id;
  std::uint32_t sequence = 0;
  bool released = false;
};

/// An order or an update of one, whose parts fit together: numbered without gaps, an edge between
/// each two nodes, the released ones first, no identifier of an action twice.
struct Order {
  std::string id;
  std::uint32_t update = 0;
  std::vector<Node> nodes;  ///< at least one
  std::vector<Edge> edges;  ///< one less
  std::string content;      ///< nodes and edges as they came, to be compared
};

/// What the vehicle can do, which an order must not exceed; told in the factsheet.
struct Capabilities {
  std::string map_id = "map";  ///< of the one map that nodes may be on
  double speed_mps = 0.5;      ///< top speed: a lower limit of an edge cannot be kept
  double rotation_rad_s = 1;   ///< the same of turning
  double height_m = 0.42;
  double width_m = 0.354;
  double length_m = 0.354;
};

/// Reads a message of the topic `order`. A fault names the field and what is allowed. Optional
/// fields that cannot be obeyed are faults, as the standard has it; unknown ones are ignored. Needs
/// no trust in the text.
[[nodiscard]] std::variant<Order, Fault> read_order(const std::string& text,
                                                    const Identity& identity,
                                                    const Capabilities& capabilities);
/// The same of the topic `instantActions`. Whether the actions are known is not looked at.
[[nodiscard]] std::variant<std::vector<Action>, Fault> read_instant_actions(
    const std::string& text, const Identity& identity);

}  // namespace tocsin::vda5050
