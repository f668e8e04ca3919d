// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ros_idl/std_srvs.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin {

/// The service of a lamp, std_srvs/SetBool, under a name and for a node of the test's own.
inline ServiceEndpoint lamp_endpoint(const std::string& name, const std::string& node = "") {
  return {name, &type_info<std_srvs::srv::SetBool_Request>(),
          &type_info<std_srvs::srv::SetBool_Response>(), node};
}

/// Answers in a thread of the test.
class LampServer : public ServerReceiver {
 public:
  LampServer(Bus& bus, const ServiceEndpoint& service) : end_(bus.serve(service, *this)) {}
  void receive(ServiceRequest&& request) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    requests_.push_back(std::move(request));
  }
  void wake() override {}
  /// Replies to all that has come, with what was asked. How many there were.
  int answer() {
    end_->flush();
    int count = 0;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (; !requests_.empty(); requests_.pop_front(), ++count) {
      const auto& request = requests_.front();
      auto response = std::make_shared<std_srvs::srv::SetBool_Response>();
      response->success(
          std::static_pointer_cast<const std_srvs::srv::SetBool_Request>(request.message)->data());
      end_->reply(request.id, response);
    }
    return count;
  }

 private:
  std::mutex mutex_;
  std::deque<ServiceRequest> requests_;
  std::unique_ptr<ServerEnd> end_;
};

class LampClient : public ClientReceiver {
 public:
  /// By a Bus or a HostGraph.
  template <class Caller>
  LampClient(Caller& caller, const ServiceEndpoint& service) : end_(caller.call(service, *this)) {}
  void receive(ServiceReply&& reply) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    replies_.push_back(std::move(reply));
  }
  void wake() override {}
  [[nodiscard]] bool available() const { return end_->available(); }
  std::optional<std::int64_t> ask(bool on) {
    auto request = std::make_shared<std_srvs::srv::SetBool_Request>();
    request->data(on);
    return end_->send(request);
  }
  std::vector<ServiceReply> replies() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return replies_;
  }

 private:
  std::mutex mutex_;
  std::vector<ServiceReply> replies_;
  std::unique_ptr<ClientEnd> end_;
};

}  // namespace tocsin
