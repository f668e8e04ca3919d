// SPDX-License-Identifier: Apache-2.0
#include "foundation/ownership.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;
using ::testing::Optional;

constexpr User user{1000, 1000};
constexpr mode_t shared_folder = S_IFDIR | S_ISVTX | 0777;

TEST(Ownership, OfTheUserOrRootIsFine) {
  EXPECT_EQ(changeable_by_others({1000, 1000, 0755}, user), std::nullopt);
  EXPECT_EQ(changeable_by_others({0, 0, 0755}, user), std::nullopt);
  EXPECT_EQ(changeable_by_others({0, 0, 0775}, user), std::nullopt);
}

TEST(Ownership, OfAnotherUserIsNotAlsoForRoot) {
  EXPECT_THAT(changeable_by_others({1001, 1000, 0755}, user),
              Optional(std::string("belongs to user 1001")));
  EXPECT_THAT(changeable_by_others({1000, 1000, 0755}, {0, 0}),
              Optional(std::string("belongs to user 1000")));
}

TEST(Ownership, GroupsOtherThanTheUsersMayNotWrite) {
  EXPECT_EQ(changeable_by_others({1000, 1000, 0775}, user), std::nullopt);
  EXPECT_EQ(changeable_by_others({1000, 1001, 0755}, user), std::nullopt);
  EXPECT_THAT(changeable_by_others({1000, 1001, 0775}, user),
              Optional(std::string("may be written by group 1001")));
}

TEST(Ownership, EverybodyMayWriteOnlyWhereEntriesStayTheirOwners) {
  EXPECT_THAT(changeable_by_others({0, 0, 0757}, user),
              Optional(std::string("may be written by everybody")));
  EXPECT_EQ(changeable_by_others({0, 0, shared_folder}, user), std::nullopt);
  EXPECT_THAT(changeable_by_others({0, 0, S_IFREG | S_ISVTX | 0777}, user),
              Optional(std::string("may be written by everybody")));
}

class OwnershipBelow : public ::testing::Test {
 protected:
  OwnershipBelow() : file_(folder_.write("prefix/lib/tocsin/liblamp.so", "")) {}
  const TemporaryFolder folder_;
  const fs::path prefix_ = folder_.path("prefix");
  const fs::path file_;
};

TEST_F(OwnershipBelow, AFolderOnTheWayIsNamed) {
  EXPECT_EQ(changeable_by_others_below(prefix_, file_), std::nullopt);
  fs::permissions(prefix_ / "lib", fs::perms::all);
  EXPECT_THAT(changeable_by_others_below(prefix_, file_),
              Optional((prefix_ / "lib").string() + " may be written by everybody"));
}

TEST_F(OwnershipBelow, TheFileItselfIsNamed) {
  fs::permissions(file_, fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT(changeable_by_others_below(prefix_, file_),
              Optional(file_.string() + " may be written by everybody"));
}

TEST_F(OwnershipBelow, TheFolderThatALinkLeadsToIsNamed) {
  const fs::path built = folder_.write("build/liblamp.so", "");
  const fs::path link = prefix_ / "lib/tocsin/liblinked.so";
  fs::create_symlink(built, link);
  EXPECT_EQ(changeable_by_others_below(prefix_, link), std::nullopt);
  fs::permissions(folder_.path("build"), fs::perms::all);
  EXPECT_THAT(changeable_by_others_below(prefix_, link),
              Optional(folder_.path("build") + " may be written by everybody"));
}

TEST_F(OwnershipBelow, WhatIsNotThereIsNobodys) {
  EXPECT_EQ(changeable_by_others(folder_.path("nothing")), std::nullopt);
  EXPECT_EQ(changeable_by_others_below(prefix_, prefix_ / "lib/none.so"), std::nullopt);
}

TEST_F(OwnershipBelow, AnotherUsersFileIsNamed) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a file away";
  ASSERT_EQ(::chown(file_.c_str(), 65'534, 0), 0);
  EXPECT_THAT(changeable_by_others_below(prefix_, file_),
              Optional(file_.string() + " belongs to user 65534"));
}

}  // namespace
}  // namespace tocsin
