// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fairway/metrics/measure.hpp"

namespace fairway {

/// What tells one cell of a campaign from another, in order: {"case","cube20_8"},{"method","orca3d"}.
using Labels = std::vector<std::pair<std::string, std::string>>;

/// One run to be made. Equal keys mean equal runs: a store that has the key need not make it again.
struct RunSpec {
  std::string key;  ///< unique: a digest of everything that decides the run's outcome
  Labels labels;
  std::uint64_t seed{};
  std::string command;    ///< that makes this run alone, up to the seed, which ends it; empty if not known
  std::string version{};  ///< of its cell: runs of two are not of one case; empty if not known
};

/// The whole command line that makes a run alone, or empty if it is not known.
inline std::string command_of(const RunSpec& spec) {
  return spec.command.empty() ? "" : spec.command + std::to_string(spec.seed);
}

/// A run that was made.
struct RunRecord {
  RunSpec spec;
  std::vector<Measure> measures;  ///< results proper: the same on every machine and any number of threads
  double wall_s{};                ///< how long it took; kept apart from the results
  std::string failure;            ///< why there are no measures, or empty
  std::string campaign{};         ///< digest of the campaign that asked for it last; empty if not known
};

}  // namespace fairway
