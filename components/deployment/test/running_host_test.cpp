// SPDX-License-Identifier: Apache-2.0
#include "deployment/running_host.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::deployment {
namespace {

using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;

/// A process that has ended.
pid_t dead_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(ProcessOf, IsTheFirstOfTheHostThatLives) {
  const TemporaryFolder folder;
  folder.write("processes.json", "{\"gcs/view\": 1, \"uxv/a\": " + std::to_string(dead_process()) +
                                     ", \"uxv/b\": " + std::to_string(::getpid()) + "}");
  EXPECT_EQ(process_of(folder.path(), "uxv"), ::getpid());
}

TEST(ProcessOf, NamesAHostOnWhichNothingLives) {
  const TemporaryFolder folder;
  folder.write("processes.json", "{\"uxv/a\": " + std::to_string(dead_process()) + "}");
  EXPECT_THAT([&] { (void)process_of(folder.path(), "uxv"); },
              Throws<EnvironmentError>(
                  Property(&EnvironmentError::what, HasSubstr("nothing runs on host uxv"))));
}

TEST(ProcessOf, TakesAHostForItsWholeName) {
  const TemporaryFolder folder;
  folder.write("processes.json", "{\"uxv2/a\": " + std::to_string(::getpid()) + "}");
  EXPECT_THROW((void)process_of(folder.path(), "uxv"), EnvironmentError);
}

TEST(ProcessOf, NamesAFolderWithoutARun) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      [&] { (void)process_of(folder.path(), "uxv"); },
      Throws<EnvironmentError>(Property(&EnvironmentError::what, HasSubstr(folder.path()))));
}

TEST(EnterNamespaces, NamesAProcessThatIsNotThere) {
  const pid_t dead = dead_process();
  EXPECT_THAT(
      [&] { enter_namespaces(dead); },
      Throws<EnvironmentError>(Property(&EnvironmentError::what, HasSubstr(std::to_string(dead)))));
}

}  // namespace
}  // namespace tocsin::deployment
