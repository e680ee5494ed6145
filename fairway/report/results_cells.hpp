// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fairway/experiment/compare.hpp"
#include "fairway/studies/run_list.hpp"

namespace fairway {

/// What the groups of a comparison are called: by those labels alone in which they differ, and by the values
/// alone where that is one label.
class GroupNames {
 public:
  explicit GroupNames(const Comparison& comparison);

  std::string of(const Labels& group) const;
  const std::string& label() const { return label_; }  ///< of the axis: "case", "case, range_m"
  bool several() const { return several_; }

 private:
  std::vector<std::string> varying_;
  std::string label_;
  bool several_{};
};

/// The runs of the cells, and where they stand in the document.
class CellRuns {
 public:
  CellRuns(std::span<const RunRecord> records, const std::string& by);

  /// Places of the runs of a cell that count.
  const std::vector<std::size_t>& of(const Labels& group, const std::string& candidate) const {
    return places_.at({group, candidate});
  }
  const RunRecord& operator[](std::size_t place) const { return records_[place]; }

  /// A quantity in each of them, run_value(); NaN in a run that failed.
  std::vector<double> values(const Labels& group, const std::string& candidate,
                             const std::string& quantity) const;

  /// A line of a table, which leads to the runs of its cell; beside each its value.
  nlohmann::json line(nlohmann::json line, const Labels& group, const std::string& candidate,
                      const std::string& quantity) const;

  const page::RunList& list() const { return list_; }

 private:
  std::span<const RunRecord> records_;
  std::map<std::pair<Labels, std::string>, std::vector<std::size_t>> places_;
  page::RunList list_;
};

}  // namespace fairway
