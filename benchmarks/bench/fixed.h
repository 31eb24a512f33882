// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace stiction::bench {

/// Benchmarks whose work can be done a fixed number of times, to be counted by a tool like
/// callgrind: every part of the step on the slab at about 1000 contacts, the same one in each batch; and of
/// each family at its smallest size steps that go on, kStepsInARow a batch, with what the search asks for
/// in some of them alone.
std::vector<std::string> fixed_names();

/// Does that work exactly `batches` times, without a clock, and describes it as one line of JSON:
/// name, batches, contacts, contact_updates, sweeps, allocations, hash, error; the hash of steps is that of
/// the state. Of two runs that differ in `batches` the difference is the batches' alone. Throws InputError
/// for an unknown name, and std::runtime_error when the workload, with the usual rule, is not at rest.
std::string run_fixed(const std::string& name, int batches);

}  // namespace stiction::bench
