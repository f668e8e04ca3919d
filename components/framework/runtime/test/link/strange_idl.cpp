// SPDX-License-Identifier: Apache-2.0
// A package of message types that no program links, as of somebody's own service.
#include "idl_support/type_registry.hpp"

namespace {

const tocsin::TypeInfo& type_of(const char* name, const char* hash) {
  auto* const type = new tocsin::TypeInfo{};  // lives as long as the process
  type->name = name;
  type->ros_hash = hash;
  return *type;
}

const bool registered = [] {
  tocsin::register_type(
      type_of("strange_idl::srv::dds_::Ask_Request_",
              "RIHS01_bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb"));
  tocsin::register_type(
      type_of("strange_idl::srv::dds_::Ask_Response_",
              "RIHS01_cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc"));
  return true;
}();

}  // namespace
