// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tocsin {

/// Receives the fields of a message in the order of its IDL. Names are the IDL's; the elements of
/// a list have the list's name.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;
  virtual void number(const char* name, double value) = 0;
  /// A 32-bit number.
  virtual void single(const char* name, float value) { number(name, static_cast<double>(value)); }
  virtual void integer(const char* name, std::int64_t value) = 0;
  virtual void boolean(const char* name, bool value) { integer(name, value ? 1 : 0); }
  virtual void text(const char* name, const std::string& value) = 0;
  virtual void bytes(const char* name, const std::uint8_t* data, std::size_t size) = 0;
  virtual void begin_struct(const char* name) = 0;
  virtual void end_struct() = 0;
  virtual void begin_list(const char* name, std::size_t size) = 0;
  virtual void end_list() = 0;
};

/// What an integer field can hold. An unsigned 64-bit field: only what the signed one can, too.
struct IntegerRange {
  std::int64_t least;
  std::int64_t most;
};

/// Is given the fields of a message in the order of its IDL, to change those that it will.
class FieldEditor {
 public:
  virtual ~FieldEditor() = default;
  virtual void number(const char* name, double& value) = 0;
  virtual void integer(const char* name, std::int64_t& value, const IntegerRange& range) = 0;
  virtual void boolean(const char* name, bool& value) = 0;
  virtual void text(const char* name, std::string& value) = 0;
  virtual void bytes(const char* name, std::vector<std::uint8_t>& value) = 0;
  virtual void begin_struct(const char* name) = 0;
  virtual void end_struct() = 0;
  /// Returns how many elements a sequence gets; an array keeps its `size`.
  virtual std::size_t begin_list(const char* name, std::size_t size) = 0;
  virtual void end_list() = 0;
};

/// All that the runtime needs to know of a message type, without its C++ type.
/// One constant object per type, made by the IDL build; safe to use from any thread.
struct TypeInfo {
  /// Type name on the wire, ROS 2 style: `geometry_msgs::msg::dds_::Twist_`.
  const char* name;
  /// A new default-constructed message.
  std::shared_ptr<void> (*create)();
  /// Bytes of the encoded message, encapsulation header included.
  std::size_t (*serialized_size)(const void* message);
  /// Writes XCDR1 little endian with its 4-byte encapsulation header. Returns the bytes written,
  /// 0 when `capacity` is too small.
  std::size_t (*serialize)(const void* message, std::uint8_t* buffer, std::size_t capacity);
  /// Reads what serialize wrote, either byte order. False, and `message` unspecified, when the
  /// bytes are not such a message. Never takes memory for more than the bytes can hold.
  bool (*deserialize)(const std::uint8_t* buffer, std::size_t size, void* message);
  /// Shows every field to `visitor`.
  void (*visit)(const void* message, FieldVisitor& visitor);
  /// Gives every field to `editor`.
  void (*edit)(void* message, FieldEditor& editor);
  /// "RIHS01_" and 64 hexadecimal digits, by which ROS 2 compares types; empty for a type that no
  /// interface file of ROS 2 can say. A literal.
  const char* ros_hash = "";
  /// Bytes that the key fields may take; 0: the type has no key, so that a topic is one instance.
  std::size_t longest_key = 0;
  /// Writes the key fields in XCDR1 big endian without header, as RTPS 2.2, section 9.6.3.3, has
  /// them. Returns the bytes written, 0 when `capacity` is too small. Null without a key.
  std::size_t (*serialize_key)(const void* message, std::uint8_t* buffer,
                               std::size_t capacity) = nullptr;
};

/// The description of a generated type. Declared for each type by its generated header.
template <class T>
const TypeInfo& type_info();

}  // namespace tocsin
