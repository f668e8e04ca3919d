// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deployment/deployment.hpp"

namespace tocsin::deployment {

/// Puts the channel, keystore, QoS and traffic files of the command line in place of the bringup
/// file's. Throws ConfigError for one that is not there, and for a channel without a radio.
void replace_files(const Overrides& overrides, Deployment& deployment);

}  // namespace tocsin::deployment
