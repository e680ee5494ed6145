// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace fairway {

/// A campaign that is cut into shards for several machines, as it is kept in a folder that all of them see:
/// submission.json, shards.sh and merge.sh, the shards' stores in parts/, what they say in logs/, and in the
/// end all.db.
struct Submission {
  std::string campaign;            ///< its name
  std::string file;                ///< of the campaign
  std::string digest;              ///< Campaign::digest
  std::string folder;              ///< where all of this lies, absolute
  std::string engine;              ///< slurm, local or mpi
  std::string program;             ///< the command, absolute
  std::string options;             ///< of every sweep, besides those that the scripts give
  std::string typed;               ///< what submits it again
  unsigned nodes{1};               ///< shards at a time
  unsigned cores{1};               ///< of each shard
  unsigned limit_s{1800};          ///< wall time that a shard may take
  std::vector<std::size_t> runs;   ///< of each shard
  std::vector<double> expected_s;  ///< of each shard, on one core
  double submitted_s{};            ///< when, in seconds since 1970
  std::size_t present{};           ///< runs that were there then
  std::vector<std::string> jobs;   ///< ids of the job arrays that were sent, the last one last

  std::uint32_t shards() const { return static_cast<std::uint32_t>(runs.size()); }
  std::string part(std::uint32_t shard) const;  ///< its store
  std::string said(std::uint32_t shard) const;  ///< what its process said, a file
  std::string merged() const { return folder + "/all.db"; }
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Submission, campaign, file, digest, folder, engine, program, options,
                                   typed, nodes, cores, limit_s, runs, expected_s, submitted_s, present, jobs)

inline constexpr const char* submission_file = "submission.json";

/// Throws InputError if there is none in the folder, or it is damaged.
Submission read_submission(const std::string& folder);

/// Cores of one shard, shards at a time, and what is to be known to cut a campaign into shards.
struct ShardSizing {
  double total_s{};          ///< work of the whole campaign, on one core
  std::size_t runs{};        ///< there are never more shards
  unsigned nodes{1};         ///< shards at a time
  unsigned cores{1};         ///< of each
  unsigned limit_s{1800};    ///< wall time that each may take
  std::uint32_t most{1001};  ///< that the scheduler takes in one array
};

/// What a shard takes at least, since a scheduler takes about a second to start one [s].
inline constexpr double least_shard_s = 30.0;

/// As many shards as are least_shard_s long, up to four for each node, so that all end at about the same time
/// and little is lost with one; more where they would not be done in half of the limit.
std::uint32_t shard_count(const ShardSizing& sizing);

/// "3,7-9" of {3, 7, 8, 9}.
std::string ranges_text(std::span<const std::uint32_t> numbers);

/// The scripts, to read, keep and edit. That of the shards makes those of `shards`. With mpi there is one
/// shard, whose runs are handed out one by one, and nothing to merge.
std::string shards_script(const Submission& submission, std::span<const std::uint32_t> shards);
std::string merge_script(const Submission& submission);

/// How far a shard is, by its store.
enum class ShardState { missing, begun, whole, damaged };

struct ShardProgress {
  ShardState state{};
  std::size_t runs{};    ///< that are stored
  std::size_t failed{};  ///< of these
};

/// Of every shard. One whose store cannot be read is damaged.
std::vector<ShardProgress> progress_of(const Submission& submission);

/// The error that is the last line of a shard's log; empty if it ended otherwise, or was told to stop.
std::string error_of(const Submission& submission, std::uint32_t shard);

/// Whether all runs are in the merged store.
bool is_merged(const Submission& submission);

}  // namespace fairway
