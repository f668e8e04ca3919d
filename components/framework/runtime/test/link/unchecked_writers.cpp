// SPDX-License-Identifier: Apache-2.0
#include "link/unchecked_writers.hpp"

#include <dlfcn.h>

#include <atomic>
#include <cstdint>

#include "runtime/fast_dds/symbols.hpp"

// CHECK_CREATE_DATAWRITER is called in the place of Fast DDS's own: the dynamic linker looks in the
// program first.
#define TEXT_OF(name) #name
#define NAME_OF(name) TEXT_OF(name)

namespace tocsin {
namespace {

std::atomic<bool> unchecked{false};

}  // namespace

UncheckedWriters::UncheckedWriters() { unchecked = true; }
UncheckedWriters::~UncheckedWriters() { unchecked = false; }

// NOLINTNEXTLINE(readability-function-size): the parameters are those of Fast DDS.
extern "C" bool CHECK_CREATE_DATAWRITER(void* self, const void* handle, std::uint32_t domain,
                                        const void* topic, const void* partitions, void* error) {
  using Check = bool (*)(void*, const void*, std::uint32_t, const void*, const void*, void*);
  static const auto original =
      reinterpret_cast<Check>(dlsym(RTLD_NEXT, NAME_OF(CHECK_CREATE_DATAWRITER)));
  return unchecked || original(self, handle, domain, topic, partitions, error);
}

}  // namespace tocsin
