// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin {

/// As long as it lives, Fast DDS in this process makes writers of topics that its identity may not
/// write, as a peer with a library of its own would.
class UncheckedWriters {
 public:
  UncheckedWriters();
  ~UncheckedWriters();
  UncheckedWriters(const UncheckedWriters&) = delete;
  UncheckedWriters& operator=(const UncheckedWriters&) = delete;
};

}  // namespace tocsin
