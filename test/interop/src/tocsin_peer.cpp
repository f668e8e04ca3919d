// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <mutex>
#include <ros_idl/std_msgs.hpp>

#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::interop {
namespace {

using Message = std_msgs::msg::String;

class TocsinPeer : public Peer, private Receiver {
 public:
  explicit TocsinPeer(const PeerSettings& settings) : bus_(make_bus(settings)) {
    const Endpoint endpoint{{topic_name, "interop", Scope::host}, &type_info<Message>()};
    subscription_ = bus_->subscribe(endpoint, *this);
    publication_ = bus_->advertise(endpoint);
  }

  void write(const std::string& text) override {
    auto message = std::make_shared<Message>();
    message->data(text);
    (void)publication_->write(message);
  }
  std::vector<HeardText> take() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(texts_, {});
  }

 private:
  static std::unique_ptr<Bus> make_bus(const PeerSettings& settings) {
    const TemporaryFolder folder;
    std::string profile = "reliability: reliable, depth: 100, heartbeat_period_s: 0.1";
    if (settings.lifespan_ms > 0) {
      profile += fmt::format(", lifespan_s: {}", 1e-3 * settings.lifespan_ms);
    }
    BusOptions options;
    options.qos_file = folder.write("qos.yaml", "interop: {" + profile + "}\n");
    options.name = "interop_" + std::to_string(getpid());
    options.host_domain = settings.domain;
    return make_fast_dds_bus(options);
  }
  void receive(const Sample& sample) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    texts_.push_back({static_cast<const Message*>(sample.message.get())->data(), now_ms()});
  }

  std::mutex mutex_;
  std::vector<HeardText> texts_;
  std::unique_ptr<Bus> bus_;
  std::unique_ptr<Subscription> subscription_;
  std::unique_ptr<Publication> publication_;
};

}  // namespace

std::unique_ptr<Peer> make_tocsin_peer(const PeerSettings& settings) {
  return std::make_unique<TocsinPeer>(settings);
}

}  // namespace tocsin::interop
