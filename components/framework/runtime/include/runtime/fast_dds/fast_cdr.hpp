// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <cstddef>
#include <cstdint>

#include "runtime/fast_dds/names.hpp"

/// Fast CDR of either version, for who compares with it: our own types are coded by idl_support.
namespace tocsin::fast_dds {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

#if TOCSIN_FAST_DDS >= 3
inline constexpr auto fast_cdr_version = eprosima::fastcdr::CdrVersion::XCDRv1;
#else
inline constexpr auto fast_cdr_version = Cdr::DDS_CDR;
#endif

/// XCDR1, little endian. Returns the bytes written, header included.
template <class Encode>
std::size_t encode_by_fast_cdr(std::uint8_t* to, std::size_t capacity, Encode encode) {
  FastBuffer buffer(reinterpret_cast<char*>(to), capacity);
  Cdr encoder(buffer, Cdr::LITTLE_ENDIANNESS, fast_cdr_version);
#if TOCSIN_FAST_DDS >= 3
  encoder.set_encoding_flag(eprosima::fastcdr::EncodingAlgorithmFlag::PLAIN_CDR);
#endif
  encoder.serialize_encapsulation();
  encode(encoder);
#if TOCSIN_FAST_DDS >= 3
  return encoder.get_serialized_data_length();
#else
  return encoder.getSerializedDataLength();
#endif
}

template <class Decode>
void decode_by_fast_cdr(const std::uint8_t* from, std::size_t size, Decode decode) {
  auto* const bytes = reinterpret_cast<char*>(const_cast<std::uint8_t*>(from));  // it only reads
  FastBuffer buffer(bytes, size);
  Cdr decoder(buffer, Cdr::DEFAULT_ENDIAN, fast_cdr_version);
  decoder.read_encapsulation();
  decode(decoder);
}

}  // namespace tocsin::fast_dds
