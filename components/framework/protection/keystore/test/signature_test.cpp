// SPDX-License-Identifier: Apache-2.0
#include "keystore/signature.hpp"

#include <string>
#include <vector>

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

TEST_F(KeystoreTest, AnIdentitySignsForItselfToo) {
  const Signer station(enclave("gcs"));
  SignatureCheck own(enclave("gcs"));
  ASSERT_TRUE(own.learn(station.certificate(), now_s));
  EXPECT_EQ(own.signer_of(message, station.sign(message), signer_id(station.certificate())),
            "CN=/gcs");
}

TEST_F(KeystoreTest, ARevokedIdentitySignsForNobody) {
  const Signer station(enclave("gcs"));
  revoke(store(), "gcs", now_s);
  SignatureCheck vehicle(enclave("uxv1"));
  EXPECT_FALSE(vehicle.learn(station.certificate(), now_s));
}

TEST_F(KeystoreTest, OfManyCertificatesTheFirstIsForgotten) {
  SignatureCheck vehicle(enclave("uxv1"));
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i <= SignatureCheck::most_certificates; ++i) {
    const std::string name = "one" + std::to_string(i);
    add(store(), {name, {{"rt/goal"}, {"rt/location"}}}, now_s);
    const Bytes certificate = Signer(enclave(name)).certificate();
    ids.push_back(signer_id(certificate));
    ASSERT_TRUE(vehicle.learn(certificate, now_s));
  }
  EXPECT_FALSE(vehicle.knows(ids.front()));
  for (std::size_t i = 1; i < ids.size(); ++i) EXPECT_TRUE(vehicle.knows(ids[i])) << i;
}

TEST_F(KeystoreTest, ACertificateThatIsLearnedAgainPushesNothingOut) {
  SignatureCheck vehicle(enclave("uxv1"));
  const Signer station(enclave("gcs"));
  const Signer other(enclave("uxv1"));
  ASSERT_TRUE(vehicle.learn(other.certificate(), now_s));
  for (std::size_t i = 0; i < 2 * SignatureCheck::most_certificates; ++i) {
    ASSERT_TRUE(vehicle.learn(station.certificate(), now_s));
  }
  EXPECT_TRUE(vehicle.knows(signer_id(other.certificate())));
}

TEST_F(KeystoreTest, EachSignatureOfAMessageIsAnotherAndAllAreValid) {
  const Signer station(enclave("gcs"));
  SignatureCheck vehicle(enclave("uxv1"));
  ASSERT_TRUE(vehicle.learn(station.certificate(), now_s));
  const auto id = signer_id(station.certificate());
  EXPECT_NE(station.sign(message), station.sign(message));
  for (const Bytes& one : {Bytes{}, Bytes(1, 0), Bytes(5000, 7)}) {
    EXPECT_EQ(vehicle.signer_of(one, station.sign(one), id), "CN=/gcs") << one.size();
  }
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
