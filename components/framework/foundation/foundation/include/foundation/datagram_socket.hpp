// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/un.h>

#include <optional>
#include <string>
#include <system_error>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// A Unix datagram socket with a pathname, so that programs in any network namespace reach it.
/// Nothing blocks.
class DatagramSocket {
 public:
  struct Message {
    std::string text;
    std::string sender;  ///< path; empty when the sender has none and cannot be answered
  };

  /// A socket that only sends.
  DatagramSocket();
  /// A socket bound to `path`, which goes with it. Replaces a socket that a dead process left
  /// there. Throws ConfigError when the path is in use, too long or cannot be created.
  explicit DatagramSocket(const std::string& path);
  ~DatagramSocket();
  DatagramSocket(const DatagramSocket&) = delete;
  DatagramSocket& operator=(const DatagramSocket&) = delete;

  [[nodiscard]] int descriptor() const { return socket_.get(); }
  /// The next message that waits; empty when none does. A longer one is cut at 2048 bytes.
  [[nodiscard]] std::optional<Message> receive();
  /// What hindered it, such as that nobody listens at `path`; `@name` is a socket without a file
  /// (unix(7), abstract).
  std::error_code send(const std::string& path, const std::string& text);

 private:
  FileDescriptor socket_;
  std::string path_;
};

}  // namespace tocsin
