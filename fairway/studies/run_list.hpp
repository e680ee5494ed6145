// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/run.hpp"

namespace fairway::page {

/// The key `runs` of a report document: the runs that its marks and rows lead to, by their places in it.
class RunList {
 public:
  /// Adds a run; `playback` is the path of a page beside the report, or empty. Runs that are added one after
  /// the other and differ in their seeds alone are written as one entry. Gives the run's place.
  std::size_t add(const std::string& label, const RunSpec& spec, const std::string& playback);

  nlohmann::json document() const;
  std::size_t size() const { return size_; }

 private:
  struct Entry {
    std::string label;
    std::string command;
    std::vector<std::uint64_t> seeds;
    nlohmann::json playbacks = nlohmann::json::object();  ///< by place among the seeds
  };

  std::vector<Entry> entries_;
  std::size_t size_{};
};

/// Places in the list: [[0, 19], 40].
nlohmann::json references(std::span<const std::size_t> places);

/// Numbers as a list of runs shows them, to six digits; null for what is not finite.
nlohmann::json shown_values(std::span<const double> values);

/// `mark` with the runs that made it and what each came to; as it is if `runs` is null or nothing is marked.
nlohmann::json linked(nlohmann::json mark, nlohmann::json runs, nlohmann::json values);

}  // namespace fairway::page
