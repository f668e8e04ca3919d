// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/sample_codec.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <new>

namespace tocsin {
namespace {

/// 2 to 11 us for a sample of 0.7 to 2.6 kB; higher levels cost more for nothing
/// (link_router_bench).
constexpr int level = 5;
constexpr std::size_t header_bytes = 4;
constexpr std::size_t most_padding = 3;
constexpr std::array<std::uint8_t, 4> magic{0x28, 0xb5, 0x2f, 0xfd};  // RFC 8878, 3.1.1

}  // namespace

struct SampleCodec::Contexts {
  Contexts()
      : compress(ZSTD_createCCtx(), ZSTD_freeCCtx), restore(ZSTD_createDCtx(), ZSTD_freeDCtx) {
    if (!compress || !restore) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(compress.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(compress.get(), ZSTD_c_checksumFlag, 1);
  }
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> compress;
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> restore;
};

SampleCodec::SampleCodec() : contexts_(std::make_shared<Contexts>()) {}

SampleCodec::Bytes SampleCodec::compress(const Bytes& plain, const Bytes& base) {
  ZSTD_CCtx* const context = contexts_->compress.get();
  Bytes frame(ZSTD_compressBound(plain.size()));
  ZSTD_CCtx_refPrefix(context, base.data(), base.size());
  const std::size_t size =
      ZSTD_compress2(context, frame.data(), frame.size(), plain.data(), plain.size());
  if (ZSTD_isError(size) != 0) throw std::bad_alloc();  // the bound is kept
  const std::size_t body = size - magic.size();
  Bytes sample(header_bytes + body);
  sample[1] = 1;  // CDR, little endian
  sample[3] = static_cast<std::uint8_t>((4 - body % 4) % 4);
  std::copy_n(frame.begin() + magic.size(), body, sample.begin() + header_bytes);
  return sample;
}

std::optional<SampleCodec::Bytes> SampleCodec::restore(const Bytes& compressed, const Bytes& base) {
  if (compressed.size() < header_bytes) return std::nullopt;
  Bytes frame(magic.size() + compressed.size() - header_bytes);
  std::copy(magic.begin(), magic.end(), frame.begin());
  std::copy(compressed.begin() + header_bytes, compressed.end(), frame.begin() + magic.size());
  const std::size_t size = ZSTD_findFrameCompressedSize(frame.data(), frame.size());
  if (ZSTD_isError(size) != 0 || frame.size() - size > most_padding) return std::nullopt;
  const unsigned long long claimed = ZSTD_getFrameContentSize(frame.data(), size);
  if (claimed > SampleCoding::largest)
    return std::nullopt;  // so are both values that tell an error
  Bytes plain(static_cast<std::size_t>(claimed));
  ZSTD_DCtx* const context = contexts_->restore.get();
  ZSTD_DCtx_refPrefix(context, base.data(), base.size());
  const std::size_t restored =
      ZSTD_decompressDCtx(context, plain.data(), plain.size(), frame.data(), size);
  if (ZSTD_isError(restored) != 0 || restored != plain.size()) return std::nullopt;
  return plain;
}

}  // namespace tocsin
