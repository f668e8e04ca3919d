// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <map>

#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin {

/// Seconds as Fast DDS has them; infinity stays infinity.
[[nodiscard]] eprosima::fastdds::dds::Duration_t dds_duration(double s);

/// Whether a topic's type has a key: then the history holds for each of any number of instances.
enum class Keys { none, some };

/// A profile in the words of Fast DDS.
[[nodiscard]] eprosima::fastdds::dds::DataWriterQos writer_qos(const QosProfile& profile,
                                                               Keys keys = Keys::none);
/// A heartbeat is answered after 5 ms at least.
[[nodiscard]] eprosima::fastdds::dds::DataReaderQos reader_qos(const QosProfile& profile,
                                                               Keys keys = Keys::none);

}  // namespace tocsin
