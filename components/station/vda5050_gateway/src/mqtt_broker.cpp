// SPDX-License-Identifier: Apache-2.0
#include <mosquitto.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

#include "foundation/error.hpp"
#include "vda5050_gateway/broker.hpp"

namespace tocsin::vda5050 {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int keep_alive_s = 5;
constexpr int loop_ms = 200;                            // how long the thread waits for packets
constexpr auto before_next = std::chrono::seconds(1);   // attempt to connect
constexpr auto for_farewell = std::chrono::seconds(1);  // to be sent, at the end
constexpr std::size_t most_waiting = 64;

/// Once in a process.
void use_library() {
  static const int used = mosquitto_lib_init();
  if (used != MOSQ_ERR_SUCCESS) throw ConfigError("libmosquitto does not start");
}

void require(int result, const std::string& what) {
  if (result != MOSQ_ERR_SUCCESS) throw ConfigError(what + ": " + mosquitto_strerror(result));
}

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw ConfigError("password_file: cannot read " + path);
  return line;
}

const char* or_null(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }

class MqttBroker final : public Broker {
 public:
  MqttBroker(const BrokerAddress& address, const Message& will,
             std::vector<std::string> subscriptions)
      : subscriptions_(std::move(subscriptions)),
        client_(mosquitto_new(address.client_id.c_str(), true, this), &mosquitto_destroy) {
    if (!client_) throw ConfigError("client id '" + address.client_id + "' cannot be used");
    prepare(address, will);
    mosquitto_connect_callback_set(client_.get(), &on_connect);
    mosquitto_disconnect_callback_set(client_.get(), &on_disconnect);
    mosquitto_message_callback_set(client_.get(), &on_message);
    require(mosquitto_threaded_set(client_.get(), true), "threads");
    thread_ = std::thread([this, address] { run(address); });
  }
  ~MqttBroker() override {
    end_by_ = Clock::now() + for_farewell;
    ends_ = true;
    mosquitto_disconnect(client_.get());
    thread_.join();
  }
  MqttBroker(const MqttBroker&) = delete;
  MqttBroker& operator=(const MqttBroker&) = delete;

  [[nodiscard]] std::uint64_t connections() const override { return connections_; }
  [[nodiscard]] bool is_connected() const override { return is_connected_; }
  bool publish(const Message& message) override {
    if (!is_connected_) return false;
    return mosquitto_publish(client_.get(), nullptr, message.topic.c_str(),
                             static_cast<int>(message.payload.size()), message.payload.data(),
                             message.qos, message.is_retained) == MOSQ_ERR_SUCCESS;
  }
  [[nodiscard]] std::optional<Received> take() override {
    const std::lock_guard lock(mutex_);
    if (waiting_.empty()) return std::nullopt;
    Received oldest = std::move(waiting_.front());
    waiting_.pop_front();
    return oldest;
  }
  [[nodiscard]] std::string trouble() const override {
    const std::lock_guard lock(mutex_);
    return trouble_;
  }

 private:
  void prepare(const BrokerAddress& address, const Message& will) {
    if (!address.user.empty()) {
      const std::string password =
          address.password_file.empty() ? "" : first_line(address.password_file);
      require(mosquitto_username_pw_set(client_.get(), address.user.c_str(), or_null(password)),
              "user");
    }
    if (!address.ca_file.empty()) {
      require(
          mosquitto_tls_set(client_.get(), address.ca_file.c_str(), nullptr,
                            or_null(address.certificate_file), or_null(address.key_file), nullptr),
          "ca_file, certificate_file, key_file");
    }
    require(
        mosquitto_will_set(client_.get(), will.topic.c_str(), static_cast<int>(will.payload.size()),
                           will.payload.data(), will.qos, will.is_retained),
        "topic " + will.topic);
  }
  /// The first reason of an attempt says most.
  void tell(const std::string& trouble) {
    if (std::exchange(has_told_, true)) return;
    const std::lock_guard lock(mutex_);
    trouble_ = trouble;
  }
  void receive(const mosquitto_message& message) {
    const auto bytes = static_cast<std::size_t>(message.payloadlen);
    // Larger ones are cut, which the reader finds out: it refuses them by their size.
    const std::size_t taken = std::min(bytes, most_message_bytes + 1);
    const std::lock_guard lock(mutex_);
    if (waiting_.size() == most_waiting) waiting_.pop_front();
    waiting_.push_back(
        {message.topic, std::string(static_cast<const char*>(message.payload), taken)});
  }

  /// Connects, and again whenever the connection has gone. The library's own thread would wait for
  /// ever where its first attempt fails at once, and ends where a name is not resolved.
  void run(const BrokerAddress& address) {
    while (!ends_) {
      has_told_ = false;
      int result =
          mosquitto_connect_async(client_.get(), address.host.c_str(), address.port, keep_alive_s);
      while (result == MOSQ_ERR_SUCCESS && (!ends_ || Clock::now() < end_by_)) {
        result = mosquitto_loop(client_.get(), loop_ms, 1);
      }
      is_connected_ = false;
      tell(mosquitto_strerror(result));
      const auto next = Clock::now() + before_next;
      while (!ends_ && Clock::now() < next) {
        std::this_thread::sleep_for(std::chrono::milliseconds(loop_ms));
      }
    }
  }

  // On that thread.
  static void on_connect(mosquitto* client, void* self, int code) {
    auto& broker = *static_cast<MqttBroker*>(self);
    if (code != 0) return broker.tell(mosquitto_connack_string(code));
    for (const std::string& topic : broker.subscriptions_) {
      mosquitto_subscribe(client, nullptr, topic.c_str(), 0);
    }
    broker.tell("");
    broker.has_told_ = false;
    broker.is_connected_ = true;
    ++broker.connections_;
  }
  static void on_disconnect(mosquitto* /*client*/, void* self, int code) {
    auto& broker = *static_cast<MqttBroker*>(self);
    broker.is_connected_ = false;
    broker.tell(mosquitto_strerror(code));
  }
  static void on_message(mosquitto* /*client*/, void* self, const mosquitto_message* message) {
    static_cast<MqttBroker*>(self)->receive(*message);
  }

  const std::vector<std::string> subscriptions_;
  std::unique_ptr<mosquitto, decltype(&mosquitto_destroy)> client_;
  std::thread thread_;
  std::atomic<bool> ends_{false};
  Clock::time_point end_by_{};  // once it ends
  std::atomic<bool> is_connected_{false};
  std::atomic<std::uint64_t> connections_{0};
  bool has_told_ = false;  // the thread's
  mutable std::mutex mutex_;
  std::string trouble_;
  std::deque<Received> waiting_;
};

}  // namespace

void check_files(const BrokerAddress& address) {
  const std::pair<const char*, const std::string&> files[] = {
      {"password_file", address.password_file},
      {"ca_file", address.ca_file},
      {"certificate_file", address.certificate_file},
      {"key_file", address.key_file}};
  for (const auto& [name, file] : files) {
    if (file.empty() || std::ifstream(file).good()) continue;
    throw ConfigError(std::string(name) + ": cannot read " + file);
  }
  if (address.certificate_file.empty() != address.key_file.empty()) {
    throw ConfigError("certificate_file and key_file belong together; only one of them is given");
  }
}

std::unique_ptr<Broker> connect_mqtt(const BrokerAddress& address, const Message& will,
                                     std::vector<std::string> subscriptions) {
  use_library();
  return std::make_unique<MqttBroker>(address, will, std::move(subscriptions));
}

}  // namespace tocsin::vda5050
