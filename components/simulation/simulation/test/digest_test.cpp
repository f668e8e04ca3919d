// SPDX-License-Identifier: Apache-2.0
#include "digest.hpp"

#include <gtest/gtest.h>

#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

using Bool = topic::EmergencyStop::Message;
constexpr Time at{std::chrono::seconds(1)};

Digest digest_of(Time now, const char* writer, bool value) {
  Digest digest;
  Bool message;
  message.data(value);
  digest.add_sample(now, writer, type_info<Bool>(), &message);
  return digest;
}

TEST(Digest, DiffersByTimeWriterAndBytesOnly) {
  const std::uint64_t one = digest_of(at, "uxv/a/stop", true).value();
  EXPECT_EQ(one, digest_of(at, "uxv/a/stop", true).value());
  EXPECT_NE(one, digest_of(at + Duration{1}, "uxv/a/stop", true).value());
  EXPECT_NE(one, digest_of(at, "gcs/a/stop", true).value());
  EXPECT_NE(one, digest_of(at, "uxv/a/stop", false).value());
}

std::uint64_t of_texts(std::initializer_list<std::string_view> texts) {
  Digest digest;
  for (const std::string_view text : texts) digest.add(text);
  return digest.value();
}

TEST(Digest, DiffersByTheOrderOfTextsAndWhereOneEnds) {
  EXPECT_NE(of_texts({"first one", "other one"}), of_texts({"other one", "first one"}));
  EXPECT_NE(of_texts({"ab", "c"}), of_texts({"a", "bc"}));
}

}  // namespace
}  // namespace tocsin::simulation
