// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "vda5050_gateway/protocol.hpp"

namespace tocsin::vda5050 {

/// Messages of a fleet manager, as the standard has them.
class OrderTexts {
 public:
  explicit OrderTexts(Version version = Version::v3_0) : version_(version) {}

  [[nodiscard]] Identity identity() const { return {version_, "", "tocsin", "uxv1"}; }
  [[nodiscard]] nlohmann::json header() const {
    return {{"headerId", 0},
            {"timestamp", "2026-11-29T12:00:00.000Z"},
            {"version", version_ == Version::v3_0 ? "3.0.0" : "2.1.0"},
            {"manufacturer", "tocsin"},
            {"serialNumber", "uxv1"}};
  }
  /// Nodes a, b, c, ... along x, a metre apart, the first one at `first`; of these `released`.
  [[nodiscard]] nlohmann::json order(int nodes, int released, int first = 0) const {
    nlohmann::json made = header();
    made["orderId"] = "o1";
    made["orderUpdateId"] = 0;
    made["nodes"] = nlohmann::json::array();
    made["edges"] = nlohmann::json::array();
    for (int i = 0; i < nodes; ++i) {
      const int place = first + i;
      made["nodes"].push_back({{"nodeId", name(place)},
                               {"sequenceId", 2 * place},
                               {"released", i < released},
                               {"nodePosition", {{"x", place}, {"y", 0}, {"mapId", "map"}}},
                               {"actions", nlohmann::json::array()}});
      if (i == 0) continue;
      made["edges"].push_back({{"edgeId", name(place - 1) + name(place)},
                               {"sequenceId", 2 * place - 1},
                               {"released", i < released},
                               {"actions", nlohmann::json::array()}});
      if (version_ == Version::v3_0) continue;
      made["edges"].back()["startNodeId"] = name(place - 1);
      made["edges"].back()["endNodeId"] = name(place);
    }
    return made;
  }
  [[nodiscard]] static nlohmann::json action(const std::string& type, const std::string& id,
                                             const nlohmann::json& parameters = {}) {
    nlohmann::json made = {{"actionType", type}, {"actionId", id}, {"blockingType", "NONE"}};
    for (const auto& [key, value] : parameters.items()) {
      made["actionParameters"].push_back({{"key", key}, {"value", value}});
    }
    return made;
  }
  [[nodiscard]] std::string instant(const std::string& type, const std::string& id,
                                    const nlohmann::json& parameters = {}) const {
    nlohmann::json made = header();
    made["actions"] = nlohmann::json::array({action(type, id, parameters)});
    return made.dump();
  }

 private:
  static std::string name(int place) { return std::string(1, static_cast<char>('a' + place)); }
  Version version_;
};

}  // namespace tocsin::vda5050
