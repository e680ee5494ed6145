// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/companions.hpp"

#include <chrono>
#include <iterator>
#include <system_error>
#include <utility>

#include "fairway/core/error.hpp"

namespace fairway {
namespace {

// within it a file may have been written twice and bear the same time
constexpr std::chrono::seconds same_instant{2};

}  // namespace

Companions::Companions(std::string folder, Shard shard, const Origin& search, Store::Foreign foreign)
    : folder_{std::move(folder)},
      shard_{shard},
      digest_{search.digest},
      local_{file_of(shard.index), foreign},
      read_(shard.count) {
  refuse_another_search(store(), shard.index);
  store().refuse_other_epoch();
  store().note(search);
}

std::string Companions::file_of(std::uint32_t part) const {
  return (std::filesystem::path{folder_} / (std::to_string(part) + ".db")).string();
}

void Companions::refuse_another_search(const Store& store, std::uint32_t part) const {
  const std::string digest = store.origin().digest;
  if (!digest.empty() && digest != digest_)
    throw InputError(file_of(part) +
                     ": holds the runs of another search: of another specification, budget, seed or number "
                     "of shards; take another folder");
}

std::vector<RunRecord> Companions::news() {
  std::vector<RunRecord> all;
  for (std::uint32_t part = 0; part < shard_.count; ++part) {
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(file_of(part), missing);
    if (part == shard_.index || missing || written == read_[part]) continue;
    const Store store = Store::open_existing(file_of(part));
    refuse_another_search(store, part);
    store.refuse_other_epoch();
    std::vector<RunRecord> runs = store.all();
    all.insert(all.end(), std::make_move_iterator(runs.begin()), std::make_move_iterator(runs.end()));
    if (std::filesystem::file_time_type::clock::now() - written > same_instant) read_[part] = written;
  }
  return all;
}

}  // namespace fairway
