// SPDX-License-Identifier: Apache-2.0
#include "revocations.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace tocsin::keystore {
namespace {

constexpr std::int64_t now_s = 1'795'000'000;

class RevocationsTest : public ::testing::Test {
 protected:
  const Authority authority_ = make_authority("authority", now_s, 100);
  const Key key_ = make_key();
  [[nodiscard]] Certificate identity() const {
    return make_certificate("/uxv1", *key_, authority_, now_s, 10);
  }
};

TEST_F(RevocationsTest, ANewListHasNobody) {
  Revocations sut;
  EXPECT_FALSE(sut.have(*identity()));
  const auto read = Revocations::in(sut.signed_pem(authority_, now_s));
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->have(*identity()));
}

TEST_F(RevocationsTest, HasWhoWasAddedAndNobodyElseOfTheSameName) {
  const Certificate revoked = identity();
  const Certificate good = identity();
  Revocations sut;
  sut.add(*revoked, now_s);
  const auto read = Revocations::in(sut.signed_pem(authority_, now_s));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->have(*revoked));
  EXPECT_FALSE(read->have(*good));
}

TEST_F(RevocationsTest, KeepsThoseOfBeforeWhenItIsReadAndSignedAnew) {
  std::vector<Certificate> revoked;
  std::string pem = Revocations().signed_pem(authority_, now_s);
  for (int i = 0; i < 10; ++i) {
    auto list = Revocations::in(pem);
    ASSERT_TRUE(list);
    revoked.push_back(identity());
    list->add(*revoked.back(), now_s + i);
    pem = list->signed_pem(authority_, now_s + i);
  }
  const auto list = Revocations::in(pem);
  ASSERT_TRUE(list);
  for (const Certificate& one : revoked) EXPECT_TRUE(list->have(*one));
  EXPECT_FALSE(list->have(*identity()));
}

TEST_F(RevocationsTest, IsOfTheAuthorityThatSignedIt) {
  const Authority other = make_authority("authority", now_s, 100);
  Revocations sut;
  const auto read = Revocations::in(sut.signed_pem(authority_, now_s));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->is_signed_by(*authority_.certificate));
  EXPECT_FALSE(read->is_signed_by(*other.certificate));
}

TEST_F(RevocationsTest, WhatIsNoListIsNothing) {
  for (const char* text : {"", "text", "-----BEGIN X509 CRL-----\nAAAA\n"}) {
    EXPECT_FALSE(Revocations::in(text)) << text;
  }
  EXPECT_FALSE(Revocations::in(to_pem(*authority_.certificate)));
}

TEST_F(RevocationsTest, OneThatWasChangedIsNotSigned) {
  Revocations sut;
  sut.add(*identity(), now_s);
  const std::string good = sut.signed_pem(authority_, now_s);
  std::mt19937 random(7);
  for (int i = 0; i < 1000; ++i) {
    std::string mutated = good;
    // Not in its last line, whose last letter has bits that mean nothing.
    mutated[25 + random() % (good.size() - 120)] = static_cast<char>('A' + random() % 26);
    const auto read = Revocations::in(mutated);
    if (mutated == good || !read) continue;
    EXPECT_FALSE(read->is_signed_by(*authority_.certificate));
  }
}

}  // namespace
}  // namespace tocsin::keystore
