// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The names of Fast DDS 3, also where Fast DDS 2.9 is installed. This folder is the only place
/// that knows which one it is.

#include "runtime/fast_dds/version.hpp"

#if TOCSIN_FAST_DDS >= 3

#include <fastdds/dds/core/ReturnCode.hpp>
#include <fastdds/dds/core/Time_t.hpp>
#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <fastdds/rtps/attributes/RTPSParticipantAttributes.hpp>
#include <fastdds/rtps/common/Guid.hpp>
#include <fastdds/rtps/common/InstanceHandle.hpp>
#include <fastdds/rtps/common/Locator.hpp>
#include <fastdds/rtps/common/SampleIdentity.hpp>
#include <fastdds/rtps/common/SerializedPayload.hpp>
#include <fastdds/rtps/common/WriteParams.hpp>
#include <fastdds/utils/IPLocator.hpp>
#include <fastdds/utils/md5.hpp>

#else

#include <fastdds/rtps/attributes/RTPSParticipantAttributes.h>
#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/common/InstanceHandle.h>
#include <fastdds/rtps/common/Locator.h>
#include <fastdds/rtps/common/SampleIdentity.h>
#include <fastdds/rtps/common/SerializedPayload.h>
#include <fastdds/rtps/common/Time_t.h>
#include <fastdds/rtps/common/WriteParams.h>
#include <fastrtps/types/TypesBase.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/utils/md5.h>

#include <fastdds/dds/core/policy/QosPolicies.hpp>

namespace eprosima::fastdds {
using ::MD5;

namespace rtps {
using namespace eprosima::fastrtps::rtps;
}

namespace dds {
using eprosima::fastrtps::c_TimeInfinite;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::types::ReturnCode_t;
inline constexpr auto RETCODE_OK = ReturnCode_t::RETCODE_OK;
}  // namespace dds
}  // namespace eprosima::fastdds

#endif

namespace tocsin::fast_dds {

/// What a write has answered.
[[nodiscard]] inline bool is_ok(bool written) { return written; }
[[nodiscard]] inline bool is_ok(const eprosima::fastdds::dds::ReturnCode_t& code) {
  return code == eprosima::fastdds::dds::RETCODE_OK;
}

}  // namespace tocsin::fast_dds
