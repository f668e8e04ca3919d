// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <mutex>
#include <ros_idl/std_msgs.hpp>

#include "peer.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::interop {
namespace {

using Message = std_msgs::msg::String;

class TocsinPeer : public Peer, private Receiver {
 public:
  explicit TocsinPeer(int domain) : bus_(make_bus(domain)) {
    const Endpoint endpoint{{topic_name, "event", Scope::host}, &type_info<Message>()};
    subscription_ = bus_->subscribe(endpoint, *this);
    publication_ = bus_->advertise(endpoint);
  }

  void write(const std::string& text) override {
    auto message = std::make_shared<Message>();
    message->data(text);
    (void)publication_->write(message);
  }
  std::vector<std::string> take() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(texts_, {});
  }

 private:
  static std::unique_ptr<Bus> make_bus(int domain) {
    BusOptions options;
    options.name = "interop_" + std::to_string(getpid());
    options.host_domain = domain;
    return make_fast_dds_bus(options);
  }
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    texts_.push_back(static_cast<const Message*>(sample.message.get())->data());
  }

  std::mutex mutex_;
  std::vector<std::string> texts_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Subscription> subscription_;
  std::unique_ptr<Publication> publication_;
};

}  // namespace

std::unique_ptr<Peer> make_tocsin_peer(int domain) { return std::make_unique<TocsinPeer>(domain); }

}  // namespace tocsin::interop
