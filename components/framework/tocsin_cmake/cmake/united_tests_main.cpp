// SPDX-License-Identifier: Apache-2.0
// The main of test programs that are united (tocsin_tests): runs the cases of one of their sources,
// which the environment names, so that each source still is a test with a process of its own.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace united_tests {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() &&
         text.compare(text.size() - end.size(), std::string::npos, end) == 0;
}

/// The filter that names each case of a source.
std::string cases_of(const std::string& source) {
  std::string filter;
  const auto& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      const testing::TestInfo& test = *suite.GetTestInfo(k);
      if (!ends_with(test.file(), source)) continue;
      filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  return filter;
}

}  // namespace united_tests

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const char* const source = std::getenv("TOCSIN_TEST_SOURCE");
  // A death test runs this program again with the filter of its case.
  if (source != nullptr && GTEST_FLAG_GET(filter) == "*") {
    const std::string cases = united_tests::cases_of(source);
    if (cases.empty()) {
      std::cerr << argv[0] << ": " << source << " has no case\n";
      return 1;
    }
    GTEST_FLAG_SET(filter, cases);
  }
  return RUN_ALL_TESTS();
}
