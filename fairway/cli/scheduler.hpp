// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

namespace fairway::cli {

/// What is asked of Slurm, by its own commands. Each throws InputError with the first line of what such a
/// command says where it fails or is not installed.
namespace slurm {

/// Sends a batch script; gives the job's id. `options` are sbatch's own, each a word.
std::string send(std::span<const std::string> options, const std::string& script);

/// The state, as "RUNNING", of each task of these job arrays that is still in the queue, by its number in the
/// array.
std::map<std::uint32_t, std::string> queued(std::span<const std::string> jobs);

/// The most tasks that an array may have.
std::uint32_t most_tasks();

/// The cores of the smallest node.
unsigned cores_of_a_node();

}  // namespace slurm
}  // namespace fairway::cli
