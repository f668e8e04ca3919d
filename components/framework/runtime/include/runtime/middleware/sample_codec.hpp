// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "foundation/sample_coding.hpp"

namespace tocsin {

/// Makes serialised samples smaller by what they repeat: of themselves, and of a base that the
/// other side has. By zstd (RFC 8878), whose checksum tells a wrong base; the first four bytes of
/// its frame, always the same, are left out. What comes out is a serialised sample, too: behind an
/// encapsulation header that tells how many bytes of padding follow (DDS-XTypes 1.3, 7.6.3.1.2).
/// A sample that claims to be larger than SampleCoding::largest is not restored. One thread.
class SampleCodec {
 public:
  using Bytes = std::vector<std::uint8_t>;

  SampleCodec();
  /// `base` may be empty.
  [[nodiscard]] Bytes compress(const Bytes& plain, const Bytes& base);
  /// Nothing when it was not compressed by this base, or is no such thing.
  [[nodiscard]] std::optional<Bytes> restore(const Bytes& compressed, const Bytes& base);

 private:
  struct Contexts;
  std::shared_ptr<Contexts> contexts_;
};

}  // namespace tocsin
