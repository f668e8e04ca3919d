// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::bench {

/// Children of this program (argument `--child ...`) measure themselves and print one line each.
void print_start_costs();
/// What a child does; the exit code.
int run_child(int argc, char** argv);

}  // namespace tocsin::bench
