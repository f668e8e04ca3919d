// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "keystore/enclave.hpp"
#include "keystore/keystore.hpp"

namespace tocsin::keystore {

/// A keystore with the identities of a vehicle and a station.
class KeystoreTest : public ::testing::Test {
 protected:
  static constexpr std::int64_t now_s = 1'795'000'000;
  KeystoreTest() {
    create(store(), now_s);
    add(store(), {"uxv1", {{"rt/location"}, {"rt/goal"}}}, now_s);
    add(store(), {"gcs", {{"rt/goal"}, {"rt/location"}}}, now_s);
  }
  [[nodiscard]] std::string store() const { return folder_.path() + "/keystore"; }
  [[nodiscard]] std::string enclave(const std::string& name) const {
    return store() + "/enclaves/" + name;
  }
  [[nodiscard]] std::vector<std::string> problems(const std::string& name,
                                                  std::int64_t at_s = now_s) const {
    return problems_of(enclave(name), at_s);
  }
  static std::string text_of(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void write(const std::string& path, const std::string& text) {
    std::filesystem::remove(path);
    std::ofstream(path) << text;
  }
  template <class Call>
  static std::string error_of(Call call) {
    try {
      call();
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

}  // namespace tocsin::keystore
