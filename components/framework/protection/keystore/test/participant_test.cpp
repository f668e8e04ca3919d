// SPDX-License-Identifier: Apache-2.0
#include "keystore/participant.hpp"

#include <gtest/gtest.h>
#include <openssl/x509.h>

#include "certificates.hpp"

namespace tocsin::keystore {
namespace {

constexpr std::int64_t now_s = 1'795'000'000;

/// As Fast DDS 2.9.1 makes it of a certificate (PKIDH.cpp, adjust_participant_key).
GuidStart of_fast_dds(const std::string& identity) {
  const Authority authority = make_authority("authority", now_s, 100);
  const Key key = make_key();
  const Certificate own = make_certificate("/" + identity, *key, authority, now_s, 10);
  std::array<unsigned char, EVP_MAX_MD_SIZE> md{};
  X509_NAME_digest(X509_get_subject_name(own.get()), EVP_sha256(), md.data(), nullptr);
  GuidStart start{};
  start[0] = static_cast<std::uint8_t>(0x80 | (md[0] >> 1));
  for (std::size_t i = 1; i < start.size(); ++i) {
    start[i] = static_cast<std::uint8_t>((md[i - 1] << 7) | (md[i] >> 1));
  }
  return start;
}

TEST(GuidStart, IsThatOfTheCertificate) {
  for (const char* const name : {"gcs", "uxv1", "a-long_name-0"}) {
    EXPECT_EQ(guid_start_of(name), of_fast_dds(name)) << name;
  }
}

TEST(ProvenName, IsTheHostsWhereTheIdentityIsIts) {
  EXPECT_EQ(proven_name("gcs", of_fast_dds("gcs")), "gcs");
  EXPECT_EQ(proven_name("uxv", of_fast_dds("uxv1")), "uxv");
  EXPECT_EQ(proven_name("uxv", of_fast_dds("uxv999")), "uxv");
}

TEST(ProvenName, IsAnotherWhereTheIdentityIsAnothers) {
  EXPECT_NE(proven_name("gcs", of_fast_dds("uxv1")), "gcs");
  EXPECT_NE(proven_name("gcs", of_fast_dds("gcs1000")), "gcs");
  EXPECT_NE(proven_name("gcs", of_fast_dds("gcsx")), "gcs");
  EXPECT_NE(proven_name("gcs", of_fast_dds("uxv1")), proven_name("gcs", of_fast_dds("uxv2")));
  EXPECT_EQ(proven_name("gcs", GuidStart{0x80, 1, 2, 3, 4, 0xff}), "gcs_of_8001020304ff");
  EXPECT_EQ(exact_name("uxv1", of_fast_dds("uxv1")), "uxv1");
  EXPECT_NE(exact_name("uxv1", of_fast_dds("uxv12")), "uxv1");
}

}  // namespace
}  // namespace tocsin::keystore
