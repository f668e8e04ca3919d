// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::bench {

/// Children of this program (argument `--child ...`) measure themselves and print one line each.
void print_start_costs();
/// Restart after kill -9, by UDP and by shared memory.
void print_restarts(int times);
/// What a child does; the exit code.
int run_child(int argc, char** argv);

}  // namespace tocsin::bench
