// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "fairway/experiment/local_store.hpp"
#include "fairway/experiment/shard.hpp"

namespace fairway {

/// Those who make the same search at the same time, on machines that see one folder. Each of them makes its
/// part of the runs that the search asks for, leaves them in a store of its own, PART.db, and reads those of
/// the others. So all go the same way, and none tells another where to go.
class Companions {
 public:
  /// Part `shard` of the search whose stores lie in `folder`. `search` says which search it is; its digest
  /// tells it from every other. Throws InputError if a part that is there is of another search or damaged.
  Companions(std::string folder, Shard shard, const Origin& search, Store::Foreign foreign);

  /// Whose the run with this number is, in the order in which the search asks for runs.
  std::uint32_t part_of(std::size_t run) const { return static_cast<std::uint32_t>(run % shard_.count); }
  bool is_mine(std::size_t run) const { return part_of(run) == shard_.index; }

  /// Of this part.
  Store& store() { return local_.store(); }
  void publish() { local_.publish(); }

  /// The runs of those parts of the others that have changed since they were asked last. Throws InputError as
  /// the constructor does.
  std::vector<RunRecord> news();

  /// The file of a part.
  std::string file_of(std::uint32_t part) const;

 private:
  void refuse_another_search(const Store& store, std::uint32_t part) const;

  std::string folder_;
  Shard shard_;
  std::string digest_;
  LocalStore local_;
  std::vector<std::filesystem::file_time_type> read_;  ///< when what was read of each part was written
};

}  // namespace fairway
