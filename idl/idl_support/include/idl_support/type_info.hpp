// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace tocsin {

class WireCursor;

/// Receives the fields of a message in the order of its IDL. Names are the IDL's; the elements of
/// a list have the list's name.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;
  virtual void number(const char* name, double value) = 0;
  virtual void integer(const char* name, std::int64_t value) = 0;
  virtual void text(const char* name, const std::string& value) = 0;
  virtual void bytes(const char* name, const std::uint8_t* data, std::size_t size) = 0;
  virtual void begin_struct(const char* name) = 0;
  virtual void end_struct() = 0;
  virtual void begin_list(const char* name, std::size_t size) = 0;
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
  /// Passes one encoded message; false when the bytes end before it does.
  bool (*skip)(WireCursor& cursor);
};

/// The description of a generated type. Declared for each type by its generated header.
template <class T>
const TypeInfo& type_info();

}  // namespace tocsin
