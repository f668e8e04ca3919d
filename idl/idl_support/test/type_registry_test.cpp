// SPDX-License-Identifier: Apache-2.0
#include "idl_support/type_registry.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <string>
#include <thread>
#include <vector>

namespace tocsin {
namespace {

TypeInfo named(const char* name) {
  return {name, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};
}

TEST(TypeRegistry, KnowsNoTypeOfANameThatNobodyRegistered) {
  EXPECT_EQ(find_type("nowhere::msg::dds_::Nothing_"), nullptr);
  EXPECT_EQ(find_type(""), nullptr);
}

TEST(TypeRegistry, TheFirstOfANameStands) {
  static const TypeInfo first = named("a::msg::dds_::A_");
  static const TypeInfo second = named("a::msg::dds_::A_");
  register_type(first);
  register_type(second);
  EXPECT_EQ(find_type("a::msg::dds_::A_"), &first);
  EXPECT_EQ(find_type("a::msg::dds_::A"), nullptr) << "the whole name";
}

TEST(TypeRegistry, LibrariesMayBeLoadedFromSeveralThreads) {
  static std::deque<std::string> names;
  static std::deque<TypeInfo> types;
  for (int i = 0; i < 200; ++i)
    types.push_back(named(names.emplace_back("T" + std::to_string(i)).c_str()));
  std::vector<std::thread> threads;
  for (std::size_t start : {0U, 1U}) {
    threads.emplace_back([start] {
      for (std::size_t i = start; i < types.size(); i += 2) register_type(types[i]);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const TypeInfo& type : types) EXPECT_EQ(find_type(type.name), &type);
}

}  // namespace
}  // namespace tocsin
