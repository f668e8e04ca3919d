// SPDX-License-Identifier: Apache-2.0
#include "keystore_fixture.hpp"
#include "signed_text.hpp"

namespace tocsin::keystore {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::int64_t year_s = 366 * 86'400;

TEST_F(KeystoreTest, WhatWasJustMadeHasNoProblem) {
  EXPECT_THAT(problems("uxv1"), IsEmpty());
  EXPECT_THAT(problems("gcs"), IsEmpty());
}

TEST_F(KeystoreTest, AnEnclaveCopiedWithoutItsKeystoreIsWhole) {
  const std::string copy = folder_.path() + "/vehicle";
  fs::copy(enclave("uxv1"), copy, fs::copy_options::recursive);  // follows links
  EXPECT_THAT(problems_of(copy, now_s), IsEmpty());
}

TEST_F(KeystoreTest, TellsWhoItIsAndWhatItMayDo) {
  const Enclave one = read_enclave(enclave("uxv1"));
  EXPECT_EQ(one.subject, "CN=/uxv1");
  EXPECT_GT(one.valid_until_s, now_s + 9 * year_s);
  ASSERT_TRUE(one.permissions);
  EXPECT_EQ(*one.permissions, (Permissions{{"rt/location"}, {"rt/goal"}}));
}

TEST_F(KeystoreTest, PermissionsWithoutADeclarationOfXmlAreReadAll) {
  const Authority authority{certificate_at(store() + "/public/ca.cert.pem"),
                            key_in(text_of(store() + "/private/ca.key.pem"))};
  const std::string whole = text_of(enclave("uxv1") + "/permissions.xml");
  write(enclave("uxv1") + "/permissions.p7s", sign(whole.substr(whole.find("<dds")), authority));
  EXPECT_THAT(problems("uxv1"), IsEmpty());
  EXPECT_EQ(read_enclave(enclave("uxv1")).permissions, (Permissions{{"rt/location"}, {"rt/goal"}}));
}

TEST_F(KeystoreTest, EveryAbsentFileIsNamed) {
  using namespace enclave_file;
  for (const char* file :
       {identity_ca, permissions_ca, certificate, key, governance, permissions}) {
    const std::string path = enclave("uxv1") + "/" + file;
    fs::rename(path, path + ".away");
    EXPECT_THAT(problems("uxv1"), Contains(AllOf(HasSubstr(file), HasSubstr("cannot be read"))));
    fs::rename(path + ".away", path);
  }
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, EveryFileWithOtherContentIsNamed) {
  using namespace enclave_file;
  for (const char* file :
       {identity_ca, permissions_ca, certificate, key, governance, permissions, revocations}) {
    const std::string path = enclave("uxv1") + "/" + file;
    const std::string before = text_of(path);
    write(path, "something else\n");
    EXPECT_THAT(problems("uxv1"), Contains(HasSubstr(file))) << file;
    write(path, before);
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  }
  EXPECT_THAT(problems("uxv1"), IsEmpty());
}

TEST_F(KeystoreTest, AKeyThatOthersCanReadIsAProblem) {
  fs::permissions(enclave("uxv1") + "/key.pem", fs::perms::others_read, fs::perm_options::add);
  EXPECT_THAT(problems("uxv1"), ElementsAre(HasSubstr("mode 600")));
}

TEST_F(KeystoreTest, TheKeyOfAnotherIsAProblem) {
  const std::string path = enclave("uxv1") + "/key.pem";
  write(path, text_of(enclave("gcs") + "/key.pem"));
  fs::permissions(path, fs::perms::owner_read);
  EXPECT_THAT(problems("uxv1"), ElementsAre(HasSubstr("is not the key of cert.pem")));
}

TEST_F(KeystoreTest, ThePermissionsOfAnotherAreAProblem) {
  write(enclave("uxv1") + "/permissions.p7s", text_of(enclave("gcs") + "/permissions.p7s"));
  EXPECT_THAT(problems("uxv1"), ElementsAre(HasSubstr("is for CN=/gcs, not for CN=/uxv1")));
}

TEST_F(KeystoreTest, AnIdentityOfAnotherAuthorityIsAProblem) {
  const std::string other = folder_.path() + "/other";
  create(other, now_s);
  add(other, {"uxv1", {}}, now_s);
  for (const char* file : {"cert.pem", "key.pem"}) {
    write(enclave("uxv1") + "/" + file, text_of(other + "/enclaves/uxv1/" + file));
  }
  fs::permissions(enclave("uxv1") + "/key.pem", fs::perms::owner_read);
  EXPECT_THAT(problems("uxv1"), ElementsAre(HasSubstr("is not signed by identity_ca.cert.pem")));
}

TEST_F(KeystoreTest, WhatExpiresIsAProblemThen) {
  EXPECT_THAT(problems("uxv1", now_s + 11 * year_s),
              Contains(AllOf(HasSubstr("cert.pem"), HasSubstr("has expired at 20"))));
  EXPECT_THAT(problems("uxv1", now_s - 2 * 86'400),
              Contains(AllOf(HasSubstr("cert.pem"), HasSubstr("is not valid before"))));
}

TEST_F(KeystoreTest, AFolderThatIsNoneSaysSo) {
  EXPECT_THAT(problems("nobody"), Contains(HasSubstr("cannot be read")));
  EXPECT_THAT(error_of([&] { (void)read_enclave(enclave("nobody")); }),
              HasSubstr("is no certificate"));
}

}  // namespace
}  // namespace tocsin::keystore
