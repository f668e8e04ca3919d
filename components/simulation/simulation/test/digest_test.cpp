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

TEST(Digest, IsTheSameForTheSameSamples) {
  EXPECT_EQ(digest_of(at, "uxv/a/stop", true).value(), digest_of(at, "uxv/a/stop", true).value());
}

TEST(Digest, DiffersByTimeWriterAndBytes) {
  const std::uint64_t one = digest_of(at, "uxv/a/stop", true).value();
  EXPECT_NE(one, digest_of(at + Duration{1}, "uxv/a/stop", true).value());
  EXPECT_NE(one, digest_of(at, "gcs/a/stop", true).value());
  EXPECT_NE(one, digest_of(at, "uxv/a/stop", false).value());
}

TEST(Digest, DiffersByTheOrderOfSamples) {
  Digest forwards;
  Digest backwards;
  for (const char* text : {"first one", "other one"}) forwards.add(std::string_view(text));
  for (const char* text : {"other one", "first one"}) backwards.add(std::string_view(text));
  EXPECT_NE(forwards.value(), backwards.value());
}

TEST(Digest, DiffersByWhereOneTextEnds) {
  Digest one;
  Digest other;
  one.add(std::string_view("ab"));
  one.add(std::string_view("c"));
  other.add(std::string_view("a"));
  other.add(std::string_view("bc"));
  EXPECT_NE(one.value(), other.value());
}

}  // namespace
}  // namespace tocsin::simulation
