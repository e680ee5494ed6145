// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/studies/cell.hpp"
#include "fairway/studies/run_list.hpp"

namespace fairway {

/// Finds the runs of a study that a mark or a row of its report was made of. A cell is named by the labels of
/// its runs. What is not known is null: then nothing leads anywhere.
class RunIndex {
 public:
  /// The runs of these cells, in the order of their results; options and results must outlive this.
  RunIndex(const StudyOptions& options, std::initializer_list<const std::vector<Cell>*> groups);

  /// All runs of a cell.
  nlohmann::json runs_of(const Labels& cell) const;
  /// The run of a cell that has this seed.
  nlohmann::json run_of(const Labels& cell, std::uint64_t seed) const;
  /// A quantity in each run of a cell: run_value().
  nlohmann::json values_of(const Labels& cell, std::string_view quantity) const;

  /// A mark of an interval chart that shows a quantity of a cell.
  nlohmann::json mark(nlohmann::json point, const Labels& cell, std::string_view quantity) const;
  /// A line of a table likewise.
  nlohmann::json line(nlohmann::json row, const Labels& cell, std::string_view quantity) const;

  /// All of them, as the report lists them.
  const page::RunList& list() const { return list_; }

 private:
  struct Group {
    std::size_t first{};  ///< place of its first run
    std::vector<std::uint64_t> seeds;
    std::span<const std::vector<Measure>> results;
  };
  void add(const Cell& cell);
  const Group* find(const Labels& cell) const;

  const StudyOptions& options_;
  std::map<std::string, Group, std::less<>> groups_;
  page::RunList list_;
};

/// The labels of the cell that a row is of.
Labels cell_of(const StudyRow& row);

}  // namespace fairway
