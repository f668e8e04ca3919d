// SPDX-License-Identifier: Apache-2.0
#include "domains_line.hpp"

#include <gtest/gtest.h>

namespace tocsin::cli {
namespace {

deployment::Host host(const char* name, int domain, bool router) {
  deployment::Host made;
  made.name = name;
  made.local_domain = domain;
  if (router) made.containers = {{"link", false, {{"link_router", "link_router", nullptr}}}};
  return made;
}

TEST(DomainsLine, SaysWhichIdBelongsToWhichHostAndToTheLink) {
  deployment::Deployment two;
  two.hosts = {host("uxv", 40, true), host("gcs", 41, true)};
  two.link_domain = 42;
  EXPECT_EQ(domains_line(two), "ROS_DOMAIN_ID: 40 on uxv, 41 on gcs; the link has 42");
}

TEST(DomainsLine, WithoutARouterThereIsNoLink) {
  deployment::Deployment alone;
  alone.hosts = {host("uxv", 0, false)};
  EXPECT_EQ(domains_line(alone), "ROS_DOMAIN_ID: 0 on uxv");
}

}  // namespace
}  // namespace tocsin::cli
