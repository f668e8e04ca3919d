// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cyclone_service.hpp"
#include "fast_dds_service.hpp"
#include "headed_services.h"

namespace tocsin::interop {

using Bytes = std::vector<std::uint8_t>;

/// `/lamp/set`, a std_srvs/srv/SetBool.
inline const FastDdsService::Half requests{"rq/lamp/setRequest",
                                           "std_srvs::srv::dds_::SetBool_Request_"};
inline const FastDdsService::Half replies{"rr/lamp/setReply",
                                          "std_srvs::srv::dds_::SetBool_Response_"};
inline const Bytes request_bytes{0, 1, 0, 0, 1};
/// success, then the text "on" with its length.
inline const Bytes response_bytes{0, 1, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 'o', 'n', 0};

class CycloneClient : public CycloneService<headed_SetBoolResponse, headed_SetBoolRequest> {
 public:
  explicit CycloneClient(int domain)
      : CycloneService(domain, headed_SetBoolRequest_desc, requests, headed_SetBoolResponse_desc,
                       replies) {}
};

class CycloneServer : public CycloneService<headed_SetBoolRequest, headed_SetBoolResponse> {
 public:
  explicit CycloneServer(int domain)
      : CycloneService(domain, headed_SetBoolResponse_desc, replies, headed_SetBoolRequest_desc,
                       requests) {}
};

}  // namespace tocsin::interop
