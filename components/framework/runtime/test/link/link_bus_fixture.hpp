// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "fast_dds/bus_fixture.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/testing/relay.hpp"

namespace tocsin {

/// A vehicle and a station with routers that meet on loopback.
class LinkBusFixture : public ::testing::Test {
 protected:
  /// `first`: of three domains.
  explicit LinkBusFixture(int first) : first_(first) {}

  [[nodiscard]] BusOptions options(Role role) const {
    BusOptions options;
    options.name = options.host = to_string(role);
    options.role = role;
    options.qos_file = std::string(TOCSIN_REPOSITORY) + "/config/qos.yaml";
    options.traffic_file = std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml";
    options.host_domain = first_ + (role == Role::uxv ? 0 : 1);
    options.link_domain = first_ + 2;
    options.link_address = "127.0.0.1";
    options.link_peers = {"127.0.0.1"};
    return options;
  }
  /// An ordinary process of a host: it knows nothing of the link.
  [[nodiscard]] std::unique_ptr<Bus> process(Role role) const {
    return make_fast_dds_bus(ordinary(role));
  }
  [[nodiscard]] BusOptions ordinary(Role role) const {
    BusOptions ordinary = options(role);
    ordinary.link_address.clear();
    return ordinary;
  }
  template <class Topic>
  [[nodiscard]] static Endpoint endpoint(const char* user_data = "") {
    return {Topic::info, &type_info<typename Topic::Message>(), Writers::needed, user_data};
  }
  template <class Topic>
  [[nodiscard]] static bool write_until_heard(Publication& publication, Samples& samples) {
    return eventually([&] {
      (void)publication.write(std::make_shared<const typename Topic::Message>());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      return !samples.all().empty();
    });
  }

 private:
  const int first_;
};

}  // namespace tocsin
