// SPDX-License-Identifier: Apache-2.0
#include "odom_watch.hpp"

#include <string>
#include <utility>

#include "tocsin_idl/topics.hpp"

namespace tocsin::bench {
namespace {

class Watched final : public Publication {
 public:
  Watched(std::unique_ptr<Publication> to, const std::function<void()>& on_write)
      : to_(std::move(to)), on_write_(on_write) {}
  Status write(const std::shared_ptr<const void>& message) override {
    on_write_();
    return to_->write(message);
  }

 private:
  std::unique_ptr<Publication> to_;
  const std::function<void()>& on_write_;
};

}  // namespace

std::unique_ptr<Publication> OdomWatch::advertise(const Endpoint& endpoint) {
  auto publication = bus_.advertise(endpoint);
  if (std::string(endpoint.topic.name) != topic::Odom::info.name) return publication;
  return std::make_unique<Watched>(std::move(publication), on_odom_);
}

}  // namespace tocsin::bench
