// SPDX-License-Identifier: Apache-2.0
// Included by generated code only: the one place that knows Fast CDR.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>

#include <array>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "idl_support/key_only.hpp"
#include "idl_support/type_info.hpp"
#include "idl_support/wire_cursor.hpp"

namespace tocsin::cdr {

inline constexpr std::size_t encapsulation_bytes = 4;

template <class T>
std::shared_ptr<void> create() {
  return std::make_shared<T>();
}

template <class T>
std::size_t serialized_size(const void* message) {
  return encapsulation_bytes + T::getCdrSerializedSize(*static_cast<const T*>(message));
}

template <class T>
std::size_t serialize(const void* message, std::uint8_t* buffer, std::size_t capacity) {
  eprosima::fastcdr::FastBuffer memory(reinterpret_cast<char*>(buffer), capacity);
  eprosima::fastcdr::Cdr encoder(memory, eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS,
                                 eprosima::fastcdr::Cdr::DDS_CDR);
  try {
    encoder.serialize_encapsulation();
    static_cast<const T*>(message)->serialize(encoder);
  } catch (const eprosima::fastcdr::exception::Exception&) {
    return 0;
  }
  return encoder.getSerializedDataLength();
}

template <class T>
std::size_t serialize_key(const void* message, std::uint8_t* buffer, std::size_t capacity) {
  eprosima::fastcdr::FastBuffer memory(reinterpret_cast<char*>(buffer), capacity);
  eprosima::fastcdr::Cdr encoder(memory, eprosima::fastcdr::Cdr::BIG_ENDIANNESS);
  try {
    static_cast<const T*>(message)->serializeKey(encoder);
  } catch (const eprosima::fastcdr::exception::Exception&) {
    return 0;
  }
  return encoder.getSerializedDataLength();
}

/// Passes one encoded value of type T.
template <class T>
struct Skip {
  static bool value(WireCursor& cursor) {
    if constexpr (std::is_enum_v<T>) {
      return cursor.skip(1, sizeof(std::uint32_t));
    } else if constexpr (std::is_arithmetic_v<T>) {
      return cursor.skip(1, sizeof(T));
    } else {
      return type_info<T>().skip(cursor);
    }
  }
};

template <>
struct Skip<std::string> {
  static bool value(WireCursor& cursor) {
    std::uint32_t length = 0;
    return cursor.read_length(length) && cursor.skip(length, 1);
  }
};

template <class T>
bool skip_items(WireCursor& cursor, std::size_t count) {
  if constexpr (std::is_arithmetic_v<T>) return cursor.skip(count, sizeof(T));
  for (std::size_t i = 0; i < count; ++i) {
    if (!Skip<T>::value(cursor)) return false;
  }
  return true;
}

template <class T>
struct Skip<std::vector<T>> {
  static bool value(WireCursor& cursor) {
    std::uint32_t length = 0;
    return cursor.read_length(length) && skip_items<T>(cursor, length);
  }
};

template <class T, std::size_t size>
struct Skip<std::array<T, size>> {
  static bool value(WireCursor& cursor) { return skip_items<T>(cursor, size); }
};

/// Passes a value of the type that a getter returns.
template <class Getter>
bool skip_field(WireCursor& cursor) {
  return Skip<std::remove_cv_t<std::remove_reference_t<Getter>>>::value(cursor);
}

/// Of a type with a key: `skip` passes its encoded key fields, `read` decodes them.
/// `read`, which decodes them.
template <class T>
struct Key {
  static bool skip(WireCursor&) { return false; }
  static void read(eprosima::fastcdr::Cdr&, T&) {}
};

template <class T>
void read_value(eprosima::fastcdr::Cdr& decoder, T& value) {
  if constexpr (std::is_enum_v<T>) {
    std::uint32_t number = 0;
    decoder >> number;
    value = static_cast<T>(number);
  } else {
    decoder >> value;
  }
}

template <class T>
bool deserialize(const std::uint8_t* buffer, std::size_t size, void* message) {
  WireCursor cursor(buffer, size);
  const bool key_alone = is_key_only(buffer, size);
  const auto skip = key_alone ? Key<T>::skip : type_info<T>().skip;
  if (!cursor.has_header() || !skip(cursor)) return false;
  auto* bytes = reinterpret_cast<char*>(const_cast<std::uint8_t*>(buffer));  // Fast CDR only reads
  eprosima::fastcdr::FastBuffer memory(bytes, size);
  eprosima::fastcdr::Cdr decoder(memory, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                                 eprosima::fastcdr::Cdr::DDS_CDR);
  try {
    decoder.read_encapsulation();
    T& read = *static_cast<T*>(message);
    key_alone ? Key<T>::read(decoder, read) : read.deserialize(decoder);
  } catch (const eprosima::fastcdr::exception::Exception&) {
    return false;
  }
  return true;
}

template <class T>
void visit_value(FieldVisitor& visitor, const char* name, const std::vector<T>& list);
template <class T, std::size_t size>
void visit_value(FieldVisitor& visitor, const char* name, const std::array<T, size>& list);

template <class T>
void visit_value(FieldVisitor& visitor, const char* name, const T& value) {
  if constexpr (std::is_same_v<T, float>) {
    visitor.single(name, value);
  } else if constexpr (std::is_floating_point_v<T>) {
    visitor.number(name, value);
  } else if constexpr (std::is_same_v<T, bool>) {
    visitor.boolean(name, value);
  } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
    visitor.integer(name, static_cast<std::int64_t>(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    visitor.text(name, value);
  } else {
    visitor.begin_struct(name);
    type_info<T>().visit(&value, visitor);
    visitor.end_struct();
  }
}

template <class List>
void visit_list(FieldVisitor& visitor, const char* name, const List& list) {
  visitor.begin_list(name, list.size());
  for (const auto& item : list) visit_value(visitor, name, item);
  visitor.end_list();
}

template <class T>
void visit_value(FieldVisitor& visitor, const char* name, const std::vector<T>& list) {
  if constexpr (std::is_same_v<T, std::uint8_t>) {
    visitor.bytes(name, list.data(), list.size());
  } else {
    visit_list(visitor, name, list);
  }
}

template <class T, std::size_t size>
void visit_value(FieldVisitor& visitor, const char* name, const std::array<T, size>& list) {
  visit_list(visitor, name, list);
}

template <class T>
constexpr IntegerRange range_of() {
  if constexpr (std::is_enum_v<T>) {
    return {0, std::numeric_limits<std::uint32_t>::max()};
  } else if constexpr (std::is_same_v<T, std::uint64_t>) {
    return {0, std::numeric_limits<std::int64_t>::max()};
  } else {
    return {std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};
  }
}

template <class T>
void edit_value(FieldEditor& editor, const char* name, std::vector<T>& list);
template <class T, std::size_t size>
void edit_value(FieldEditor& editor, const char* name, std::array<T, size>& list);

template <class T>
void edit_value(FieldEditor& editor, const char* name, T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    double wide = static_cast<double>(value);
    editor.number(name, wide);
    value = static_cast<T>(wide);
  } else if constexpr (std::is_same_v<T, bool>) {
    editor.boolean(name, value);
  } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
    auto wide = static_cast<std::int64_t>(value);
    editor.integer(name, wide, range_of<T>());
    value = static_cast<T>(wide);
  } else if constexpr (std::is_same_v<T, std::string>) {
    editor.text(name, value);
  } else {
    editor.begin_struct(name);
    type_info<T>().edit(&value, editor);
    editor.end_struct();
  }
}

template <class T>
void edit_value(FieldEditor& editor, const char* name, std::vector<T>& list) {
  if constexpr (std::is_same_v<T, std::uint8_t>) {
    editor.bytes(name, list);
  } else {
    list.resize(editor.begin_list(name, list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
      T item = list[i];  // the elements of vector<bool> are no bools
      edit_value(editor, name, item);
      list[i] = std::move(item);
    }
    editor.end_list();
  }
}

template <class T, std::size_t size>
void edit_value(FieldEditor& editor, const char* name, std::array<T, size>& list) {
  (void)editor.begin_list(name, size);
  for (T& item : list) edit_value(editor, name, item);
  editor.end_list();
}

template <class T>
TypeInfo make_type_info(const char* name, void (*visit)(const void*, FieldVisitor&),
                        void (*edit)(void*, FieldEditor&), bool (*skip)(WireCursor&),
                        const char* ros_hash) {
  TypeInfo info{name, create<T>, serialized_size<T>, serialize<T>, deserialize<T>, visit, edit,
                skip, ros_hash};
  if (T::isKeyDefined()) {
    info.longest_key = T::getKeyMaxCdrSerializedSize();
    info.serialize_key = serialize_key<T>;
  }
  return info;
}

}  // namespace tocsin::cdr
