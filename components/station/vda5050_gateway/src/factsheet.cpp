// SPDX-License-Identifier: Apache-2.0
#include "vda5050_gateway/messages.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;

struct Field {
  const char* name;
  const char* support;
  const char* description;
  bool is_in_21;
  bool is_in_30;
};

constexpr Field fields[] = {
    {"order.nodes.nodePosition", "REQUIRED", "on the one map that maps names", true, true},
    {"order.nodes.nodePosition.theta", "SUPPORTED", "", true, true},
    {"order.nodes.nodePosition.allowedDeviationXY", "SUPPORTED",
     "of the first node; others are reached as near as can be", true, true},
    {"order.nodes.nodePosition.allowedDeviationTheta", "SUPPORTED", "", true, true},
    {"order.edges.maxSpeed", "SUPPORTED", "not below speedMax", true, false},
    {"order.edges.maximumSpeed", "SUPPORTED", "not below maximumSpeed", false, true},
    {"order.edges.length", "SUPPORTED", "", true, true},
};

struct Parameter {
  const char* key;
  const char* type;
  bool is_optional;
};

struct Offered {
  const char* type;
  bool is_on_nodes;
  std::vector<Parameter> parameters;
};

std::vector<Offered> actions_of(Version version) {
  const std::vector<Parameter> pose = {{"x", "NUMBER", false},
                                       {"y", "NUMBER", false},
                                       {"theta", "NUMBER", false},
                                       {"mapId", "STRING", true},
                                       {"lastNodeId", "STRING", true}};
  std::vector<Offered> all = {{"cancelOrder", false, {{"orderId", "STRING", true}}},
                              {"startPause", false, {}},
                              {"stopPause", false, {}},
                              {"startCharging", true, {}},
                              {"stateRequest", false, {}},
                              {"factsheetRequest", false, {}}};
  if (version == Version::v3_0) {
    all.push_back({"initializePosition", false, pose});
    all.push_back({"clearInstantActions", false, {}});
  } else {
    all.push_back({"initPosition", false, pose});
  }
  return all;
}

json parameters_of(const Offered& action) {
  json all = json::array();
  for (const Parameter& parameter : action.parameters) {
    all.push_back({{"key", parameter.key},
                   {"valueDataType", parameter.type},
                   {"isOptional", parameter.is_optional}});
  }
  return all;
}

json optional_parameters(bool is_new) {
  json all = json::array();
  for (const Field& field : fields) {
    if (!(is_new ? field.is_in_30 : field.is_in_21)) continue;
    all.push_back({{"parameter", field.name}, {"support", field.support}});
    if (*field.description != '\0') all.back()["description"] = field.description;
  }
  return all;
}

json described(const Offered& action, bool is_new) {
  json one = {{"actionType", action.type},
              {"actionScopes", json::array({"INSTANT"})},
              {"actionParameters", parameters_of(action)}};
  if (action.is_on_nodes) one["actionScopes"].push_back("NODE");
  if (!is_new) return one;
  // Texts in the schema of 3.0.0, truth values in its tables.
  one["pauseAllowed"] = "false";
  one["cancelAllowed"] = action.is_on_nodes ? "true" : "false";
  one["blockingTypes"] = json::array({"NONE", "SOFT", "HARD"});
  return one;
}

json features(Version version) {
  const bool is_new = version == Version::v3_0;
  json actions = json::array();
  for (const Offered& action : actions_of(version)) actions.push_back(described(action, is_new));
  return {{"optionalParameters", optional_parameters(is_new)},
          {is_new ? "mobileRobotActions" : "agvActions", std::move(actions)}};
}

/// A Kobuki: 5 kg on a hard floor, limits of its velocity_smoother.
json factsheet_30(const Capabilities& vehicle) {
  return {
      {"typeSpecification",
       {{"seriesName", "Tocsin"},
        {"mobileRobotKinematics", "DIFFERENTIAL"},
        {"mobileRobotKinematic", "DIFFERENTIAL"},  // the name that the schema of 3.0.0 requires
        {"mobileRobotClass", "CARRIER"},
        {"maximumLoadMass", 5},
        {"localizationTypes", json::array({"NATURAL"})},
        {"navigationTypes", json::array({"FREELY_NAVIGATING"})}}},
      {"physicalParameters",
       {{"minimumSpeed", 0},
        {"maximumSpeed", vehicle.speed_mps},
        {"maximumAngularSpeed", vehicle.rotation_rad_s},
        {"maximumAcceleration", 1},
        {"maximumDeceleration", 2},
        {"minimumHeight", vehicle.height_m},
        {"maximumHeight", vehicle.height_m},
        {"width", vehicle.width_m},
        {"length", vehicle.length_m}}},
      {"protocolLimits",
       {{"maximumStringLengths",
         {{"maximumMessageLength", most_message_bytes}, {"maximumIdLength", most_id_bytes}}},
        {"maximumArrayLengths",
         {{"order.nodes", most_nodes},
          {"order.edges", most_nodes - 1},
          {"state.instantActionStates", Gateway::most_instant_actions}}},
        {"timing",
         {{"minimumOrderInterval", 0.1}, {"minimumStateInterval", Publications::least_apart_s}}}}},
      {"mobileRobotGeometry", json::object()}};
}

json factsheet_21(const Capabilities& vehicle) {
  return {{"typeSpecification",
           {{"seriesName", "Tocsin"},
            {"agvKinematic", "DIFF"},
            {"agvClass", "CARRIER"},
            {"maxLoadMass", 5},
            {"localizationTypes", json::array({"NATURAL"})},
            {"navigationTypes", json::array({"AUTONOMOUS"})}}},
          {"physicalParameters",
           {{"speedMin", 0},
            {"speedMax", vehicle.speed_mps},
            {"accelerationMax", 1},
            {"decelerationMax", 2},
            {"heightMin", vehicle.height_m},
            {"heightMax", vehicle.height_m},
            {"width", vehicle.width_m},
            {"length", vehicle.length_m}}},
          {"protocolLimits",
           {{"maxStringLens", {{"msgLen", most_message_bytes}, {"idLen", most_id_bytes}}},
            {"maxArrayLens", {{"order.nodes", most_nodes}, {"order.edges", most_nodes - 1}}},
            {"timing",
             {{"minOrderInterval", 0.1}, {"minStateInterval", Publications::least_apart_s}}}}},
          {"agvGeometry", json::object()}};
}

}  // namespace

json factsheet_body(const Identity& identity, const Capabilities& capabilities) {
  json body =
      identity.version == Version::v3_0 ? factsheet_30(capabilities) : factsheet_21(capabilities);
  body["protocolFeatures"] = features(identity.version);
  body["loadSpecification"] = json::object();
  return body;
}

}  // namespace tocsin::vda5050
