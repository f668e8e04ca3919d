// SPDX-License-Identifier: Apache-2.0
#include "compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

namespace tocsin::mcap {
namespace {

constexpr int zstd_level = 1;
/// Of packed to unpacked size, that most data do not reach; more memory is taken as bytes come.
constexpr std::uint64_t usual_ratio = 8;
constexpr std::uint64_t least_step = 65'536;  // [byte]

struct ZstdDecoder {
  std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream{ZSTD_createDStream(),
                                                                    ZSTD_freeDStream};
  void reset() { ZSTD_DCtx_reset(stream.get(), ZSTD_reset_session_only); }
  /// Unpacks more; false when it is damaged or over.
  bool step(const std::uint8_t*& from, const std::uint8_t* end, std::uint8_t*& to,
            const std::uint8_t* to_end) {
    ZSTD_inBuffer in{from, static_cast<std::size_t>(end - from), 0};
    ZSTD_outBuffer out{to, static_cast<std::size_t>(to_end - to), 0};
    const std::size_t result = ZSTD_decompressStream(stream.get(), &out, &in);
    from += in.pos;
    to += out.pos;
    return ZSTD_isError(result) == 0 && (in.pos > 0 || out.pos > 0);
  }
};

struct Lz4Decoder {
  static LZ4F_dctx* make() {
    LZ4F_dctx* made = nullptr;
    return LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) == 0U ? made
                                                                                    : nullptr;
  }
  std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> stream{
      make(), LZ4F_freeDecompressionContext};
  void reset() { LZ4F_resetDecompressionContext(stream.get()); }
  bool step(const std::uint8_t*& from, const std::uint8_t* end, std::uint8_t*& to,
            const std::uint8_t* to_end) {
    std::size_t in = static_cast<std::size_t>(end - from);
    std::size_t out = static_cast<std::size_t>(to_end - to);
    const std::size_t result = LZ4F_decompress(stream.get(), to, &out, from, &in, nullptr);
    from += in;
    to += out;
    return LZ4F_isError(result) == 0U && (in > 0 || out > 0);
  }
};

template <class Decoder>
Unpacked unpack_stream(Span from, std::uint64_t size, Bytes& to) {
  thread_local Decoder decoder;
  if (!decoder.stream) return Unpacked::nothing;
  decoder.reset();
  const std::uint8_t* at = from.data;
  const std::uint8_t* const end = from.data + from.size;
  const std::uint64_t likely = usual_ratio * from.size + least_step;
  to.resize(static_cast<std::size_t>(std::min(size, likely)));
  std::size_t done = 0;
  while (done < size) {
    if (done == to.size()) {
      to.resize(static_cast<std::size_t>(std::min<std::uint64_t>(size, 2 * to.size())));
    }
    std::uint8_t* out = to.data() + done;
    const bool going = decoder.step(at, end, out, to.data() + to.size());
    done = static_cast<std::size_t>(out - to.data());
    if (!going) break;
  }
  to.resize(done);
  return done == size ? Unpacked::whole : Unpacked::part;
}

bool compress_lz4(Span from, Bytes& to) {
  LZ4F_preferences_t preferences{};
  preferences.frameInfo.contentSize = from.size;
  to.resize(LZ4F_compressFrameBound(from.size, &preferences));
  const std::size_t size =
      LZ4F_compressFrame(to.data(), to.size(), from.data, from.size, &preferences);
  if (LZ4F_isError(size) != 0U) return false;
  to.resize(size);
  return size < from.size;
}

bool compress_zstd(Span from, Bytes& to) {
  thread_local const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context{ZSTD_createCCtx(),
                                                                                  ZSTD_freeCCtx};
  to.resize(ZSTD_compressBound(from.size));
  const std::size_t size =
      ZSTD_compressCCtx(context.get(), to.data(), to.size(), from.data, from.size, zstd_level);
  if (ZSTD_isError(size) != 0U) return false;
  to.resize(size);
  return size < from.size;
}

}  // namespace

std::string name_in_file(Compression compression) {
  const auto place = static_cast<std::size_t>(compression);
  return compression == Compression::none ? "" : words_of(compression)[place];
}

bool compress(Compression compression, Span from, Bytes& to) {
  switch (compression) {
    case Compression::lz4:
      return compress_lz4(from, to);
    case Compression::zstd:
      return compress_zstd(from, to);
    case Compression::none:
      break;
  }
  return false;
}

Unpacked unpack(const std::string& compression, Span from, std::uint64_t size, Bytes& to) {
  if (compression == "zstd") return unpack_stream<ZstdDecoder>(from, size, to);
  if (compression == "lz4") return unpack_stream<Lz4Decoder>(from, size, to);
  to.clear();
  if (!compression.empty() && compression != "none") return Unpacked::nothing;
  to.assign(from.data, from.data + std::min<std::uint64_t>(from.size, size));
  return to.size() == size ? Unpacked::whole : Unpacked::part;
}

}  // namespace tocsin::mcap
