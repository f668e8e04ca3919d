// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/middleware/host_graph.hpp"

namespace tocsin::log_tool {

/// A host's domain that a test makes up.
class FakeGraph final : public HostGraph {
 public:
  [[nodiscard]] std::vector<GraphEnd> ends() const override { return known; }
  [[nodiscard]] std::vector<GraphNode> nodes() const override { return {}; }
  [[nodiscard]] std::unique_ptr<RawReading> read(
      const RawTopic& topic, std::function<void(RawSample&&)> on_sample) override {
    readers[topic.name] = std::move(on_sample);
    return std::make_unique<Reading>(*this, topic.name);
  }
  [[nodiscard]] std::unique_ptr<ClientEnd> call(const ServiceEndpoint&, ClientReceiver&) override {
    return nullptr;
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic& topic) override {
    return std::make_unique<Writing>(*this, topic.name);
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic& topic,
                                                  const QosProfile&) override {
    return write(topic);
  }

  void add_writer(const std::string& topic, const std::string& type) {
    GraphEnd end;
    end.topic = topic;
    end.type = type;
    end.writer = true;
    known.push_back(end);
  }
  /// To who reads the topic.
  void give(const std::string& topic, RawSample sample) {
    const auto reader = readers.find(topic);
    if (reader != readers.end()) reader->second(std::move(sample));
  }

  std::vector<GraphEnd> known;
  std::map<std::string, std::function<void(RawSample&&)>> readers;
  /// What was written, by topic; `on_write` is called with each.
  std::map<std::string, std::vector<std::vector<std::uint8_t>>> written;
  std::function<void(const std::string& topic)> on_write = [](const std::string&) {};

 private:
  class Reading final : public RawReading {
   public:
    Reading(FakeGraph& graph, std::string topic) : graph_(graph), topic_(std::move(topic)) {}
    ~Reading() override { graph_.readers.erase(topic_); }

   private:
    FakeGraph& graph_;
    const std::string topic_;
  };
  class Writing final : public RawWriting {
   public:
    Writing(FakeGraph& graph, std::string topic) : graph_(graph), topic_(std::move(topic)) {}
    bool write(const std::vector<std::uint8_t>& bytes) override {
      graph_.written[topic_].push_back(bytes);
      graph_.on_write(topic_);
      return true;
    }
    [[nodiscard]] int readers() const override { return 1; }

   private:
    FakeGraph& graph_;
    const std::string topic_;
  };
};

}  // namespace tocsin::log_tool
