// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "kobuki_driver/kobuki_driver.hpp"

namespace tocsin::kobuki {

/// Versions, id, battery and gains, a line each; "unknown" for what the base did not tell.
[[nodiscard]] std::string info_page(const KobukiDriver& driver, const Reading& reading);

/// The sensors of one frame on a page of at most 80 columns.
[[nodiscard]] std::string watch_page(const KobukiDriver& driver, const Reading& reading);

}  // namespace tocsin::kobuki
