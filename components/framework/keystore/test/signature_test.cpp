// SPDX-License-Identifier: Apache-2.0
#include "keystore/signature.hpp"

#include "keystore_fixture.hpp"

namespace tocsin::keystore {
namespace {

const Bytes message{1, 2, 3};

TEST_F(KeystoreTest, ASignatureNamesItsIdentity) {
  const Signer station(enclave("gcs"));
  SignatureCheck vehicle(enclave("uxv1"));
  const auto id = signer_id(station.certificate());
  EXPECT_FALSE(vehicle.knows(id));
  ASSERT_TRUE(vehicle.learn(station.certificate(), now_s));
  EXPECT_TRUE(vehicle.knows(id));
  EXPECT_EQ(vehicle.signer_of(message, station.sign(message), id), "CN=/gcs");
}

TEST_F(KeystoreTest, AChangedMessageOrSignatureIsOfNobody) {
  const Signer station(enclave("gcs"));
  SignatureCheck vehicle(enclave("uxv1"));
  const auto id = signer_id(station.certificate());
  Bytes signature = station.sign(message);
  EXPECT_EQ(vehicle.signer_of(message, signature, id), std::nullopt) << "not learned";
  ASSERT_TRUE(vehicle.learn(station.certificate(), now_s));
  EXPECT_EQ(vehicle.signer_of({1, 2, 4}, signature, id), std::nullopt);
  signature.back() ^= 1;
  EXPECT_EQ(vehicle.signer_of(message, signature, id), std::nullopt);
  EXPECT_EQ(vehicle.signer_of(message, {}, id), std::nullopt);
}

TEST_F(KeystoreTest, AnotherIdentitysSignatureDoesNotPassForThis) {
  SignatureCheck vehicle(enclave("uxv1"));
  const Signer station(enclave("gcs"));
  const Signer other(enclave("uxv1"));
  ASSERT_TRUE(vehicle.learn(station.certificate(), now_s));
  ASSERT_TRUE(vehicle.learn(other.certificate(), now_s));
  const Bytes signature = other.sign(message);
  EXPECT_EQ(vehicle.signer_of(message, signature, signer_id(station.certificate())), std::nullopt);
}

TEST_F(KeystoreTest, CertificatesOfOtherAuthoritiesOrDatesAreNotLearned) {
  const std::string strange = folder_.path() + "/strange";
  create(strange, now_s);
  add(strange, {"gcs", {{"rt/goal"}, {"rt/location"}}}, now_s);
  SignatureCheck vehicle(enclave("uxv1"));
  EXPECT_FALSE(vehicle.learn(Signer(strange + "/enclaves/gcs").certificate(), now_s));
  EXPECT_FALSE(vehicle.learn({1, 2, 3}, now_s));
  EXPECT_FALSE(vehicle.learn({}, now_s));
  const Signer station(enclave("gcs"));
  constexpr std::int64_t years = 11LL * 366 * 86'400;
  EXPECT_FALSE(vehicle.learn(station.certificate(), now_s + years));
  EXPECT_FALSE(vehicle.learn(station.certificate(), now_s - years));
}

TEST_F(KeystoreTest, ARevokedIdentitySignsForNobody) {
  const Signer station(enclave("gcs"));
  revoke(store(), "gcs", now_s);
  SignatureCheck vehicle(enclave("uxv1"));
  EXPECT_FALSE(vehicle.learn(station.certificate(), now_s));
}

TEST_F(KeystoreTest, AnEnclaveWithoutKeyOrAuthorityIsRefusedByName) {
  std::filesystem::remove(enclave("gcs") + "/key.pem");
  EXPECT_THAT(error_of([&] { const Signer none(enclave("gcs")); }),
              ::testing::HasSubstr("key.pem"));
  std::filesystem::remove(enclave("gcs") + "/identity_ca.cert.pem");
  EXPECT_THAT(error_of([&] { const SignatureCheck none(enclave("gcs")); }),
              ::testing::HasSubstr("identity_ca.cert.pem"));
}

}  // namespace
}  // namespace tocsin::keystore
