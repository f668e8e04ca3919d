// SPDX-License-Identifier: Apache-2.0
// Files with random faults: nothing crashes, hangs or takes memory that the file only claims. A
// slice of test/fuzz/campaign mcap; see fuzz_target.cpp.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>

#include "cursor.hpp"
#include "encode.hpp"
#include "fuzz_target.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

/// Of each compression; a campaign says more by the environment.
int mutations() {
  const char* const said = std::getenv("TOCSIN_MUTATIONS");
  return said == nullptr ? 4000 : std::atoi(said);
}

void mutate(Bytes& bytes, std::mt19937& random) {
  for (unsigned i = 1 + random() % 4; i > 0 && bytes.size() > 16; --i) {
    const std::size_t at = 8 + random() % (bytes.size() - 8);
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random() % 6) {
      case 0:
        *place = static_cast<std::uint8_t>(random());
        break;
      case 1:
        *place = random() % 2 == 0 ? 0x00 : 0xff;
        break;
      case 2:
        bytes.erase(place, place + static_cast<std::ptrdiff_t>(
                                       std::min<std::size_t>(random() % 20, bytes.size() - at)));
        break;
      case 3:
        bytes.insert(place, random() % 40, static_cast<std::uint8_t>(random()));
        break;
      case 4:  // a length
        for (std::size_t k = 0; k < 8 && at + k < bytes.size(); ++k) bytes[at + k] = 0xff;
        break;
      default:
        bytes.resize(at);
    }
  }
}

/// Makes the checksum of the summary right again, so that what is behind it is tried, too.
void mend_crc(Bytes& bytes) {
  if (bytes.size() < footer_size + magic.size()) return;
  const std::size_t footer = bytes.size() - footer_size + record_head;
  Cursor cursor({bytes.data() + footer, 8});
  const std::uint64_t start = cursor.number(8);
  const std::size_t field = bytes.size() - magic.size() - 4;
  if (start >= field) return;
  const std::uint32_t crc = crc32({bytes.data() + start, field - static_cast<std::size_t>(start)});
  for (std::size_t i = 0; i < 4; ++i) bytes[field + i] = static_cast<std::uint8_t>(crc >> (8 * i));
}

class MutatedFile : public ::testing::TestWithParam<Compression> {};
INSTANTIATE_TEST_SUITE_P(Each, MutatedFile,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

TEST_P(MutatedFile, IsReadAndMendedWithoutACrash) {
  MemorySink sink;
  {
    TwoTopics file(sink, small_chunks(GetParam()));
    (void)file.writer.write(Attachment{1, 2, "name", "type", "data"});
    for (const Sent& sent : numbered(30)) (void)file.write(sent);
    (void)file.writer.write(Metadata{"m", {{"x", "y"}}});
  }
  std::mt19937 random(20261122);
  for (int i = 0; i < mutations(); ++i) {
    Bytes bytes = sink.bytes();
    mutate(bytes, random);
    if (i % 2 == 0) mend_crc(bytes);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  EXPECT_LT(used.ru_maxrss, 1'000'000) << "KiB";
}

}  // namespace
}  // namespace tocsin::mcap
