// SPDX-License-Identifier: Apache-2.0
#include "keystore/keystore.hpp"

#include <sys/stat.h>

#include "foundation/folder_lock.hpp"
#include "keystore_fixture.hpp"

namespace tocsin::keystore {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(KeystoreTest, HasTheFilesOfSros2) {
  for (const char* file :
       {"public/ca.cert.pem", "public/identity_ca.cert.pem", "public/permissions_ca.cert.pem",
        "private/ca.key.pem", "private/identity_ca.key.pem", "private/permissions_ca.key.pem",
        "enclaves/governance.p7s", "enclaves/governance.xml", "enclaves/uxv1/cert.pem",
        "enclaves/uxv1/key.pem", "enclaves/uxv1/governance.p7s", "enclaves/uxv1/permissions.p7s",
        "enclaves/uxv1/permissions.xml", "enclaves/uxv1/identity_ca.cert.pem",
        "enclaves/uxv1/permissions_ca.cert.pem"}) {
    EXPECT_FALSE(text_of(store() + "/" + file).empty()) << file;
  }
}

TEST_F(KeystoreTest, NobodyElseReadsWhatIsSecret) {
  for (const char* file : {"/private/ca.key.pem", "/enclaves/uxv1/key.pem"}) {
    struct stat facts {};
    ASSERT_EQ(stat((store() + file).c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 077U, 0U) << file;
  }
}

TEST_F(KeystoreTest, NamesItsIdentities) {
  EXPECT_THAT(names_in(store()), ElementsAre("gcs", "uxv1"));
  EXPECT_EQ(enclave_folder(store(), "gcs"), enclave("gcs"));
  EXPECT_THAT(error_of([&] { (void)enclave_folder(store(), "uxv2"); }),
              AllOf(HasSubstr("no identity 'uxv2'"), HasSubstr("[gcs, uxv1]")));
}

TEST_F(KeystoreTest, IsNotMadeOverWhatIsThere) {
  EXPECT_THAT(error_of([&] { create(store(), now_s); }), HasSubstr("is not empty"));
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, AnIdentityIsNotMadeTwice) {
  const std::string key = text_of(enclave("uxv1") + "/key.pem");
  EXPECT_THAT(error_of([&] { add(store(), {"uxv1", {}}, now_s); }), HasSubstr("is there already"));
  EXPECT_EQ(text_of(enclave("uxv1") + "/key.pem"), key);
}

TEST_F(KeystoreTest, ANameThatLeavesItsFolderIsRefused) {
  for (const char* name : {"", "../uxv2", "a/b", "a b", ".", "\n"}) {
    EXPECT_THAT(error_of([&] {
                  add(store(), {name, {}}, now_s);
                }),
                HasSubstr("allowed are letters"))
        << name;
  }
}

TEST_F(KeystoreTest, PermissionsAreSignedAnewWithTheSameIdentity) {
  const std::string certificate = text_of(enclave("uxv1") + "/cert.pem");
  permit(store(), "uxv1", {{"rt/odom"}, {}});
  EXPECT_EQ(read_enclave(enclave("uxv1")).permissions, (Permissions{{"rt/odom"}, {}}));
  EXPECT_EQ(text_of(enclave("uxv1") + "/cert.pem"), certificate);
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, ARevokedIdentityIsOneForAll) {
  revoke(store(), "uxv1", now_s);
  EXPECT_THAT(problems("uxv1"), ElementsAre(HasSubstr("is revoked")));
  EXPECT_THAT(problems("gcs"), IsEmpty());
  EXPECT_EQ(text_of(enclave("gcs") + "/crl.pem"), text_of(store() + "/public/crl.pem"));
  EXPECT_THAT(error_of([&] { revoke(store(), "uxv1", now_s); }), HasSubstr("is revoked already"));
}

TEST_F(KeystoreTest, ARevokedNameCanBeGivenAgain) {
  revoke(store(), "uxv1", now_s);
  const std::string before = text_of(enclave("uxv1") + "/cert.pem");
  add(store(), {"uxv1", {{"rt/location"}, {}}}, now_s);
  EXPECT_THAT(problems("uxv1"), IsEmpty());
  EXPECT_NE(text_of(enclave("uxv1") + "/cert.pem"), before);
  write(enclave("uxv1") + "/cert.pem", before);
  EXPECT_THAT(problems("uxv1"), Contains(HasSubstr("is revoked")));
}

TEST_F(KeystoreTest, WithoutItsPrivateKeyNothingIsMade) {
  fs::rename(store() + "/private", store() + "/elsewhere");
  EXPECT_THAT(error_of([&] {
                add(store(), {"uxv2", {}}, now_s);
              }),
              HasSubstr("identities are made where it is"));
  EXPECT_FALSE(fs::exists(enclave("uxv2")));
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, AnIdentityIsValidForTheDaysThatItWasGiven) {
  add(store(), {"guest", {{"rt/location"}, {}}, 3}, now_s);
  EXPECT_EQ(read_enclave(enclave("guest")).valid_until_s, now_s + 3 * 86'400);
  EXPECT_THAT(problems("guest", now_s + 2 * 86'400), IsEmpty());
  EXPECT_THAT(problems("guest", now_s + 4 * 86'400),
              AllOf(Contains(HasSubstr("cert.pem: has expired")),
                    Contains(HasSubstr("permissions.p7s: has expired"))));
}

TEST_F(KeystoreTest, WhatIsAddedAfterARevocationKnowsOfIt) {
  revoke(store(), "uxv1", now_s);
  add(store(), {"uxv2", {}}, now_s);
  EXPECT_EQ(text_of(enclave("uxv2") + "/crl.pem"), text_of(store() + "/public/crl.pem"));
  EXPECT_THAT(problems("uxv2"), IsEmpty());
}

TEST_F(KeystoreTest, ThePublicPartsHoldNoSecret) {
  for (const char* file : {"/public/ca.cert.pem", "/public/crl.pem", "/enclaves/governance.p7s",
                           "/enclaves/uxv1/permissions.p7s", "/enclaves/uxv1/cert.pem"}) {
    EXPECT_EQ(text_of(store() + file).find("PRIVATE KEY"), std::string::npos) << file;
  }
}

TEST_F(KeystoreTest, WhatAKilledMakerHasLeftIsNoIdentityAndIsInNobodysWay) {
  fs::copy(enclave("uxv1"), enclave("uxv2") + ".new", fs::copy_options::recursive);
  fs::remove(enclave("uxv2") + ".new/permissions.p7s");
  EXPECT_THAT(names_in(store()), ElementsAre("gcs", "uxv1"));
  add(store(), {"uxv2", {}}, now_s);
  EXPECT_THAT(problems("uxv2"), IsEmpty());
  EXPECT_FALSE(fs::exists(enclave("uxv2") + ".new"));
}

TEST_F(KeystoreTest, TwoDoNotChangeItAtOnce) {
  const FolderLock other(store() + "/enclaves");
  EXPECT_THAT(error_of([&] { add(store(), {"uxv2", {}}, now_s); }), HasSubstr("enclaves"));
  EXPECT_THAT(error_of([&] { revoke(store(), "uxv1", now_s); }), HasSubstr("enclaves"));
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, AFileInThePlaceOfAFolderIsAnError) {
  const std::string file = folder_.path() + "/file";
  write(file, "text");
  EXPECT_FALSE(error_of([&] { create(file, now_s); }).empty());
  EXPECT_EQ(text_of(file), "text");
}

TEST_F(KeystoreTest, TheKeyOfAnotherAuthorityMakesNothing) {
  const std::string other = folder_.path() + "/other";
  create(other, now_s);
  write(store() + "/private/ca.key.pem", text_of(other + "/private/ca.key.pem"));
  EXPECT_THAT(error_of([&] {
                add(store(), {"uxv2", {}}, now_s);
              }),
              HasSubstr("is not the key of public/ca.cert.pem"));
  EXPECT_THAT(error_of([&] { permit(store(), "uxv1", {}); }),
              HasSubstr("is not the key of public/ca.cert.pem"));
  EXPECT_THAT(error_of([&] { revoke(store(), "uxv1", now_s); }),
              HasSubstr("is not the key of public/ca.cert.pem"));
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, AnIdentityThatIsNotThereCannotBePermittedOrRevoked) {
  for (const char* name : {"uxv2", "", "../gcs"}) {
    EXPECT_THAT(error_of([&] { permit(store(), name, {}); }), HasSubstr("no identity"));
    EXPECT_THAT(error_of([&] { revoke(store(), name, now_s); }), HasSubstr("no identity"));
  }
}

TEST_F(KeystoreTest, AFolderThatIsNoKeystoreSaysSo) {
  EXPECT_THAT(error_of([&] { (void)names_in(folder_.path()); }), HasSubstr("is no keystore"));
}

}  // namespace
}  // namespace tocsin::keystore
