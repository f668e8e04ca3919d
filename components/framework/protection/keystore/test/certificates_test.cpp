// SPDX-License-Identifier: Apache-2.0
#include "certificates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/x509v3.h>

#include <algorithm>
#include <random>
#include <set>

#include "signed_text.hpp"

namespace tocsin::keystore {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int64_t now_s = 1'795'000'000;
constexpr std::int64_t day_s = 86'400;

class CertificatesTest : public ::testing::Test {
 protected:
  const Authority authority_ = make_authority("authority", now_s, 100);
  const Key key_ = make_key();
  [[nodiscard]] Certificate identity(const std::string& name = "/uxv1") const {
    return make_certificate(name, *key_, authority_, now_s, 10);
  }
  static std::string serial_of(X509& certificate) {
    const ASN1_INTEGER* const number = X509_get0_serialNumber(&certificate);
    return {reinterpret_cast<const char*>(ASN1_STRING_get0_data(number)),
            static_cast<std::size_t>(ASN1_STRING_length(number))};
  }
};

TEST_F(CertificatesTest, AKeyIsOfTheCurveThatDdsSecurityNames) {
  EXPECT_EQ(EVP_PKEY_get_id(key_.get()), EVP_PKEY_EC);
  EXPECT_EQ(EVP_PKEY_get_bits(key_.get()), 256) << "DDS Security 1.1 section 9.3.1";
}

TEST_F(CertificatesTest, NoTwoKeysAreTheSame) {
  std::set<std::string> keys;
  for (int i = 0; i < 20; ++i) keys.insert(to_pem(*make_key()));
  EXPECT_EQ(keys.size(), 20U);
}

TEST_F(CertificatesTest, AnAuthoritySignsItselfAndMaySignOthers) {
  X509& own = *authority_.certificate;
  EXPECT_EQ(X509_verify(&own, X509_get0_pubkey(&own)), 1);
  EXPECT_EQ(X509_check_ca(&own), 1);
  EXPECT_EQ(subject_of(own), "CN=authority");
}

TEST_F(CertificatesTest, AnIdentityIsSignedByTheAuthorityAndMaySignNobody) {
  const Certificate one = identity();
  EXPECT_EQ(X509_verify(one.get(), X509_get0_pubkey(authority_.certificate.get())), 1);
  EXPECT_EQ(X509_check_ca(one.get()), 0);
  EXPECT_EQ(X509_check_issued(authority_.certificate.get(), one.get()), X509_V_OK);
  EXPECT_EQ(X509_check_private_key(one.get(), key_.get()), 1);
}

TEST_F(CertificatesTest, AnotherAuthorityOfTheSameNameHasNotSignedIt) {
  const Authority other = make_authority("authority", now_s, 100);
  EXPECT_NE(X509_verify(identity().get(), X509_get0_pubkey(other.certificate.get())), 1);
}

TEST_F(CertificatesTest, TheSubjectIsWrittenAsPermissionsNameIt) {
  EXPECT_EQ(subject_of(*identity("/uxv1")), "CN=/uxv1");
  EXPECT_EQ(subject_of(*identity("a,b")), "CN=a\\,b") << "RFC 2253 section 2.4";
}

TEST_F(CertificatesTest, HoldsFromADayBeforeForAsLongAsItWasAskedFor) {
  const Certificate one = identity();
  EXPECT_EQ(valid_from(*one), now_s - day_s);
  EXPECT_EQ(valid_until(*one), now_s + 10 * day_s);
}

TEST_F(CertificatesTest, NoTwoHaveTheSameNumber) {
  std::set<std::string> numbers;
  for (int i = 0; i < 50; ++i) numbers.insert(serial_of(*identity()));
  EXPECT_EQ(numbers.size(), 50U);
  for (const std::string& number : numbers) EXPECT_LE(number.size(), 20U) << "RFC 5280, 4.1.2.2";
}

TEST_F(CertificatesTest, PemIsReadBackAsTheSame) {
  const Certificate one = identity();
  const std::string pem = to_pem(*one);
  EXPECT_THAT(pem, StartsWith("-----BEGIN CERTIFICATE-----"));
  const Certificate read = certificate_in(pem);
  ASSERT_TRUE(read);
  EXPECT_EQ(X509_cmp(one.get(), read.get()), 0);
  const Key key = key_in(to_pem(*key_));
  ASSERT_TRUE(key);
  EXPECT_EQ(EVP_PKEY_eq(key.get(), key_.get()), 1);
}

TEST_F(CertificatesTest, WhatIsNoPemIsNothing) {
  for (const char* text : {"", "text", "-----BEGIN CERTIFICATE-----\nAAAA\n"}) {
    EXPECT_FALSE(certificate_in(text)) << text;
    EXPECT_FALSE(key_in(text)) << text;
  }
  EXPECT_FALSE(certificate_in(to_pem(*key_)));
  EXPECT_FALSE(key_in(to_pem(*authority_.certificate)));
}

TEST_F(CertificatesTest, MutatedPemIsNothingOrIsNotSigned) {
  const std::string good = to_pem(*identity());
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string mutated = good;
    // Not in its last lines, where the last letter has bits that mean nothing.
    mutated[28 + random() % (good.size() - 126)] = static_cast<char>('A' + random() % 26);
    const Certificate read = certificate_in(mutated);
    if (mutated == good || !read) continue;
    EXPECT_NE(X509_verify(read.get(), X509_get0_pubkey(authority_.certificate.get())), 1);
  }
}

TEST_F(CertificatesTest, AMutatedDocumentIsNotBelieved) {
  const std::string good = sign("<dds>the text that counts</dds>\n", authority_);
  const auto text = verified(good, *authority_.certificate, now_s);
  ASSERT_TRUE(text);
  std::mt19937 random(6);
  for (int i = 0; i < 2000; ++i) {
    std::string mutated = good;
    mutated[random() % good.size()] = static_cast<char>(' ' + random() % 90);
    const auto read = verified(mutated, *authority_.certificate, now_s);
    if (!read) continue;
    EXPECT_EQ(read, text) << "only what is not signed may differ";
  }
}

TEST_F(CertificatesTest, ADocumentCutAnywhereIsNotBelieved) {
  const std::string good = sign("text\n", authority_);
  const std::size_t end = good.find("-----", good.find("base64"));  // behind the signature
  for (std::size_t size = 0; size < end - 100; size += 3) {
    EXPECT_FALSE(verified(good.substr(0, size), *authority_.certificate, now_s)) << size;
  }
}

TEST_F(CertificatesTest, AnErrorOfOpensslIsSaidOnceAndThenForgotten) {
  EXPECT_FALSE(certificate_in("no certificate"));
  EXPECT_THAT(openssl_error(), HasSubstr("PEM"));
  EXPECT_EQ(openssl_error(), "no reason given");
}

}  // namespace
}  // namespace tocsin::keystore
