// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/un.h>

#include <optional>
#include <string>

#include "file_descriptor.hpp"

namespace tocsin::kobuki {

/// A Unix datagram socket without blocking.
class DatagramSocket {
 public:
  struct Message {
    std::string text;
    std::string sender;  ///< path; empty when the sender has none and cannot be answered
  };

  /// A socket that only sends.
  DatagramSocket();
  /// A socket bound to `path`. Replaces a socket that a dead process left there. Throws ConfigError
  /// when the path is in use, too long or cannot be created.
  explicit DatagramSocket(const std::string& path);
  ~DatagramSocket();
  DatagramSocket(const DatagramSocket&) = delete;
  DatagramSocket& operator=(const DatagramSocket&) = delete;

  [[nodiscard]] int descriptor() const { return socket_.get(); }
  /// The next message that waits; empty when none does.
  [[nodiscard]] std::optional<Message> receive();
  /// Lost without notice when nobody listens at `path`.
  void send(const std::string& path, const std::string& text);

 private:
  FileDescriptor socket_;
  std::string path_;
};

}  // namespace tocsin::kobuki
