// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeindex>
#include <utility>

#include "devices/device.hpp"
#include "foundation/error.hpp"

namespace tocsin {

/// The devices of a computer: one maker for each type. A component cannot tell whose makers they
/// are. Any thread may open once no maker is added any more, as far as the makers allow it.
class Devices {
 public:
  /// What is at an address of a type without a maker.
  enum class Unknown {
    absent,  ///< nothing
    silent   ///< a D by its own default functions
  };
  /// Called when something came to a device without a descriptor (see Device), on the thread of its
  /// component, until the device is destroyed.
  using Readable = std::function<void()>;
  template <class D>
  using Maker = std::function<Opened<D>(const typename D::Address& address, Readable readable)>;

  explicit Devices(Unknown unknown = Unknown::absent) : unknown_(unknown) {}

  /// Replaces the maker of D. It may throw ConfigError for an address that can never be one, and
  /// EnvironmentError for what this process may not do.
  template <class D>
  void add(Maker<D> maker) {
    makers_[typeid(D)] = std::make_shared<Maker<D>>(std::move(maker));
  }

  /// For a device that may come later; the answer says why it is not there. Throws what the maker
  /// throws.
  template <class D>
  [[nodiscard]] Opened<D> try_open(const typename D::Address& address = {},
                                   Readable readable = {}) const {
    Opened<D> opened;
    if (const auto found = makers_.find(typeid(D)); found != makers_.end()) {
      opened = (*static_cast<const Maker<D>*>(found->second.get()))(address, std::move(readable));
    } else if (unknown_ == Unknown::silent) {
      opened = std::make_unique<D>();
    }
    if (!opened.device && opened.reason.empty()) {
      opened.reason = D::text(address) + ": no such device";
    }
    return opened;
  }

  /// Never null. Throws ConfigError, which names kind and address, when it is not there.
  template <class D>
  [[nodiscard]] std::unique_ptr<D> open(const typename D::Address& address = {},
                                        Readable readable = {}) const {
    Opened<D> opened = try_open<D>(address, std::move(readable));
    if (!opened.device) throw ConfigError(std::string(D::kind) + " " + opened.reason);
    return std::move(opened.device);
  }

 private:
  Unknown unknown_;
  std::map<std::type_index, std::shared_ptr<const void>> makers_;
};

}  // namespace tocsin
