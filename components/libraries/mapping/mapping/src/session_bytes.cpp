// SPDX-License-Identifier: Apache-2.0
#include "mapping/session_bytes.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/hash.hpp"

namespace tocsin::mapping {
namespace {

constexpr std::string_view magic = "tocsin map session 1\n";
constexpr std::size_t most_items = 100'000'000;  // of a list: more is damage

class Writer {
 public:
  template <class T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void size(std::size_t count) { number(std::uint64_t{count}); }
  void operator()(const std::vector<float>& values) {
    size(values.size());
    for (const float value : values) number(value);
  }
  void pose(const geometry::Pose& pose) {
    number(pose.x_m);
    number(pose.y_m);
    number(pose.heading_rad);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Throws ConfigError at the end of the bytes and at what cannot be.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}
  template <class T>
  T number() {
    static_assert(std::is_arithmetic_v<T>);
    if (bytes_.size() < sizeof(T)) fail("it is cut");
    T value;
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    return value;
  }
  std::size_t size() {
    const auto count = number<std::uint64_t>();
    if (count > most_items || count > bytes_.size()) fail("a list is longer than the file");
    return static_cast<std::size_t>(count);
  }
  /// Of a node.
  std::size_t index(std::size_t count) {
    const auto index = number<std::uint64_t>();
    if (index >= count) fail("it speaks of a node that is not there");
    return static_cast<std::size_t>(index);
  }
  void operator()(std::vector<float>& values) {
    values.resize(size());
    for (float& value : values) {
      value = number<float>();
      if (!std::isfinite(value)) fail("a reading is not finite");
    }
    if (values.size() % 2 != 0) fail("a point has one coordinate");
  }
  geometry::Pose pose() {
    geometry::Pose pose;
    pose.x_m = number<double>();
    pose.y_m = number<double>();
    pose.heading_rad = number<double>();
    if (!is_finite(pose)) fail("a pose is not finite");
    return pose;
  }
  [[nodiscard]] bool is_at_end() const { return bytes_.empty(); }
  [[noreturn]] void fail(const char* reason) const {
    throw ConfigError(name_ + ": is no session of a map: " + reason);
  }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

void write_constraint(Writer& to, const Constraint& constraint) {
  to.size(constraint.from);
  to.size(constraint.to);
  to.pose(constraint.relative);
  for (int i = 0; i < 9; ++i) to.number(constraint.information(i / 3, i % 3));
  to.number(std::uint8_t{constraint.may_be_wrong});
}

Constraint read_constraint(Reader& from, std::size_t nodes) {
  Constraint constraint;
  constraint.from = from.index(nodes);
  constraint.to = from.index(nodes);
  constraint.relative = from.pose();
  for (int i = 0; i < 9; ++i) constraint.information(i / 3, i % 3) = from.number<double>();
  constraint.may_be_wrong = from.number<std::uint8_t>() != 0;
  if (constraint.from == constraint.to) from.fail("a constraint joins a node with itself");
  if (!constraint.information.allFinite()) from.fail("a constraint is not finite");
  return constraint;
}

MapSession::Node read_node(Reader& from) {
  MapSession::Node node;
  node.pose = from.pose();
  node.scan.visit(from);
  if (!node.scan.is_whole()) from.fail("a scan has no place of the laser");
  return node;
}

std::vector<std::size_t> read_submap(Reader& from, std::size_t nodes) {
  std::vector<std::size_t> submap(from.size());
  for (std::size_t& node : submap) node = from.index(nodes);
  for (std::size_t i = 1; i < submap.size(); ++i) {
    if (submap[i] <= submap[i - 1]) from.fail("the nodes of a submap do not rise");
  }
  if (submap.empty()) from.fail("a submap has no node");
  return submap;
}

}  // namespace

std::string bytes_of(const MapSession& session) {
  Writer to;
  to.size(session.nodes.size());
  for (const MapSession::Node& node : session.nodes) {
    to.pose(node.pose);
    node.scan.visit(to);
  }
  to.size(session.submaps.size());
  for (const auto& submap : session.submaps) {
    to.size(submap.size());
    for (const std::size_t node : submap) to.size(node);
  }
  to.size(session.constraints.size());
  for (const Constraint& constraint : session.constraints) write_constraint(to, constraint);
  Writer sum;
  sum.number(hash_of(to.bytes()));
  return std::string(magic) + sum.bytes() + to.bytes();
}

MapSession session_in(const std::string& bytes, const std::string& name) {
  std::string_view rest = bytes;
  const bool is_ours = rest.substr(0, magic.size()) == magic;
  if (is_ours) rest.remove_prefix(magic.size());
  Reader header(rest, name);
  if (!is_ours) header.fail("it does not begin with 'tocsin map session 1'");
  const auto sum = header.number<std::uint64_t>();
  rest.remove_prefix(sizeof sum);
  Reader from(rest, name);
  if (sum != hash_of(rest)) from.fail("it is cut or damaged, its check sum does not fit");
  MapSession session;
  session.nodes.resize(from.size());
  for (MapSession::Node& node : session.nodes) node = read_node(from);
  session.submaps.resize(from.size());
  for (auto& submap : session.submaps) submap = read_submap(from, session.nodes.size());
  session.constraints.resize(from.size());
  for (Constraint& constraint : session.constraints) {
    constraint = read_constraint(from, session.nodes.size());
  }
  if (!from.is_at_end()) from.fail("it is longer than its content");
  return session;
}

}  // namespace tocsin::mapping
