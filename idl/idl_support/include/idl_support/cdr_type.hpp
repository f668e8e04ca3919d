// SPDX-License-Identifier: Apache-2.0
// Included by generated code only: how the fields of its types are coded, shown and edited.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "idl_support/key_only.hpp"
#include "idl_support/type_info.hpp"
#include "idl_support/wire_cursor.hpp"
#include "idl_support/wire_writer.hpp"

namespace tocsin::cdr {

inline constexpr std::size_t encapsulation_bytes = 4;

template <class T>
std::shared_ptr<void> create() {
  return std::make_shared<T>();
}

/// Encodes a value of any type that a field may have to a WireWriter, or counts its bytes.
template <class Wire, class T>
bool write_value(Wire& wire, const std::vector<T>& list);
template <class Wire, class T, std::size_t size>
bool write_value(Wire& wire, const std::array<T, size>& list);

template <class Wire, class T>
bool write_value(Wire& wire, const T& value) {
  if constexpr (std::is_enum_v<T>) {
    const auto number = static_cast<std::uint32_t>(value);
    return wire.write(&number, 1);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return wire.write(&value, 1);
  } else if constexpr (std::is_same_v<T, std::string>) {
    const auto length = static_cast<std::uint32_t>(value.size() + 1);  // with its NUL
    return wire.write(&length, 1) && wire.write(value.c_str(), length);
  } else {
    return T::every_field(value,
                          [&](const char*, const auto& field) { return write_value(wire, field); });
  }
}

template <class Wire, class List>
bool write_items(Wire& wire, const List& list) {
  using Item = typename List::value_type;
  if constexpr (std::is_arithmetic_v<Item> && !std::is_same_v<Item, bool>) {
    return wire.write(list.data(), list.size());
  } else {
    for (const Item& item : list) {
      if (!write_value(wire, item)) return false;
    }
    return true;
  }
}

template <class Wire, class T>
bool write_value(Wire& wire, const std::vector<T>& list) {
  const auto length = static_cast<std::uint32_t>(list.size());
  return wire.write(&length, 1) && write_items(wire, list);
}

template <class Wire, class T, std::size_t size>
bool write_value(Wire& wire, const std::array<T, size>& list) {
  return write_items(wire, list);
}

template <class T>
std::size_t serialized_size(const void* message) {
  WireSize size;
  write_value(size, *static_cast<const T*>(message));
  return encapsulation_bytes + size.size();
}

template <class T>
std::size_t serialize(const void* message, std::uint8_t* buffer, std::size_t capacity) {
  constexpr std::uint8_t little_endian[encapsulation_bytes] = {0, 1, 0, 0};
  if (capacity < encapsulation_bytes) return 0;
  std::copy(std::begin(little_endian), std::end(little_endian), buffer);
  WireWriter wire(buffer + encapsulation_bytes, capacity - encapsulation_bytes, ByteOrder::little);
  if (!write_value(wire, *static_cast<const T*>(message))) return 0;
  return encapsulation_bytes + wire.size();
}

template <class T>
std::size_t serialize_key(const void* message, std::uint8_t* buffer, std::size_t capacity) {
  WireWriter wire(buffer, capacity, ByteOrder::big);
  const bool written =
      T::every_key_field(*static_cast<const T*>(message),
                         [&](const char*, const auto& field) { return write_value(wire, field); });
  return written ? wire.size() : 0;
}

/// Decodes a value of any type that a field may have.
template <class T>
bool read_value(WireCursor& cursor, std::vector<T>& list);
template <class T, std::size_t size>
bool read_value(WireCursor& cursor, std::array<T, size>& list);

inline bool read_text(WireCursor& cursor, std::string& text) {
  std::uint32_t length = 0;
  if (!cursor.read_length(length) || !cursor.has(length, 1)) return false;
  text.resize(length);
  if (!cursor.read(text.data(), length)) return false;
  if (!text.empty() && text.back() == '\0') text.pop_back();
  return true;
}

template <class T>
bool read_value(WireCursor& cursor, T& value) {
  if constexpr (std::is_enum_v<T>) {
    std::uint32_t number = 0;
    if (!cursor.read(&number, 1)) return false;
    value = static_cast<T>(number);
    return true;
  } else if constexpr (std::is_same_v<T, bool>) {
    std::uint8_t number = 0;
    if (!cursor.read(&number, 1) || number > 1) return false;
    value = number == 1;
    return true;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return cursor.read(&value, 1);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return read_text(cursor, value);
  } else {
    return T::every_field(value,
                          [&](const char*, auto& field) { return read_value(cursor, field); });
  }
}

template <class T>
bool read_value(WireCursor& cursor, std::vector<T>& list) {
  std::uint32_t length = 0;
  if (!cursor.read_length(length)) return false;
  if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    if (!cursor.has(length, sizeof(T))) return false;
    list.resize(length);
    return cursor.read(list.data(), length);
  } else {
    list.clear();
    for (std::uint32_t i = 0; i < length; ++i) {  // no more than the bytes hold
      T item{};
      if (!read_value(cursor, item)) return false;
      list.push_back(std::move(item));
    }
    return true;
  }
}

template <class T, std::size_t size>
bool read_value(WireCursor& cursor, std::array<T, size>& list) {
  if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    return cursor.read(list.data(), size);
  } else {
    return std::all_of(list.begin(), list.end(), [&](T& item) { return read_value(cursor, item); });
  }
}

template <class T>
bool deserialize(const std::uint8_t* buffer, std::size_t size, void* message) {
  WireCursor cursor(buffer, size);
  if (!cursor.has_header()) return false;
  T& read = *static_cast<T*>(message);
  if (!is_key_only(buffer, size)) return read_value(cursor, read);
  if constexpr (T::has_key) {
    return T::every_key_field(read,
                              [&](const char*, auto& field) { return read_value(cursor, field); });
  } else {
    return false;
  }
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
void visit_fields(const void* message, FieldVisitor& visitor) {
  T::every_field(*static_cast<const T*>(message), [&](const char* name, const auto& field) {
    visit_value(visitor, name, field);
    return true;
  });
}

template <class T>
void edit_fields(void* message, FieldEditor& editor) {
  T::every_field(*static_cast<T*>(message), [&](const char* name, auto& field) {
    edit_value(editor, name, field);
    return true;
  });
}

/// What a key with a text is counted as: more than the 16 bytes of a key hash. It may be longer.
inline constexpr std::size_t longest_text_key = 260;

/// Whether every value of its type takes as many bytes.
template <class T>
bool is_fixed(const std::vector<T>& list);
template <class T, std::size_t size>
bool is_fixed(const std::array<T, size>& list);

template <class T>
bool is_fixed(const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return true;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return false;
  } else {
    return T::every_field(value, [](const char*, const auto& field) { return is_fixed(field); });
  }
}

template <class T>
bool is_fixed(const std::vector<T>& /*list*/) {
  return false;
}

template <class T, std::size_t size>
bool is_fixed(const std::array<T, size>& list) {
  return is_fixed(list.front());
}

/// Bytes of the longest key of this type.
template <class T>
std::size_t longest_key() {
  WireSize size;
  const T message{};
  const bool fixed = T::every_key_field(message, [&](const char*, const auto& field) {
    return is_fixed(field) && write_value(size, field);
  });
  return fixed ? size.size() : longest_text_key;
}

template <class T>
TypeInfo make_type_info(const char* name, const char* ros_hash) {
  TypeInfo info{name,           create<T>,       serialized_size<T>, serialize<T>,
                deserialize<T>, visit_fields<T>, edit_fields<T>,     ros_hash};
  if constexpr (T::has_key) {
    info.longest_key = longest_key<T>();
    info.serialize_key = serialize_key<T>;
  }
  return info;
}

}  // namespace tocsin::cdr
