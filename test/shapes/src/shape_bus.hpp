// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>

#include "runtime/bus.hpp"
#include "shapes/shape.hpp"
#include "shapes_idl/shapes.hpp"

namespace tocsin::shapes {

using ShapeType = shapes_msgs::ShapeType;

/// ShapeType under the name that the suite gives it on the wire.
[[nodiscard]] const TypeInfo& shape_type();

/// A bus on the domain of the options, on which all topics have the options' QoS and the names that
/// the suite gives them. Throws EnvironmentError when it cannot be made.
[[nodiscard]] std::unique_ptr<Bus> make_shape_bus(const ShapeOptions& options);

/// The end of a topic of this name. The name must outlive it.
[[nodiscard]] Endpoint shape_endpoint(const char* topic);

[[nodiscard]] ShapeType message_of(const Shape& shape);
[[nodiscard]] Shape shape_of(const ShapeType& message);

/// Prints what happens to the ends of a bus as shape_main's listeners do: matches, incompatible
/// QoS, missed deadlines.
class EventPrinter {
 public:
  void look(Bus& bus);

 private:
  struct Seen {
    int matched = 0;
    std::uint64_t incompatible = 0;
    std::uint64_t deadlines = 0;
  };
  std::map<std::string, Seen> seen_;
};

/// Prints a line and lets it go at once: scripts wait for it.
void say(const std::string& line);

}  // namespace tocsin::shapes
