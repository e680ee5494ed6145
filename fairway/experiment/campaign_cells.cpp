// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/campaign_cells.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/labels.hpp"

namespace fairway {
namespace {

/// Every combination, the last axis fastest.
std::vector<Overrides> combinations(const std::vector<CampaignAxis>& grid) {
  std::vector<Overrides> all{{}};
  for (const CampaignAxis& axis : grid) {
    std::vector<Overrides> longer;
    longer.reserve(all.size() * axis.values.size());
    for (const Overrides& settings : all) {
      for (const std::string& value : axis.values) {
        longer.push_back(settings);
        longer.back().emplace_back(axis.path, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// `a=1 b=2`: of those in which two cells of one scenario differ.
std::string differing(const CampaignCell& cell, const CampaignCell& other) {
  Labels labels;
  for (std::size_t i = 0; i < cell.labels.size(); ++i)
    if (cell.labels[i] != other.labels[i]) labels.push_back(cell.labels[i]);
  return labels_text(labels);
}

}  // namespace

std::vector<CampaignCell> expanded_cells(const CampaignFile& written, std::span<const std::string> cases) {
  std::vector<std::optional<CampaignAlgorithm>> algorithms(written.algorithms.begin(),
                                                           written.algorithms.end());
  if (algorithms.empty()) algorithms.emplace_back();
  const std::vector<Overrides> rows = written.zip.empty() ? std::vector<Overrides>{{}} : written.zip;
  const std::vector<Overrides> grid = combinations(written.grid);

  std::vector<CampaignCell> cells;
  for (std::size_t s = 0; s < cases.size(); ++s) {
    for (const auto& algorithm : algorithms) {
      for (const Overrides& row : rows) {
        for (const Overrides& settings : grid) {
          CampaignCell cell{.labels = {{"case", cases[s]}}, .scenario = s, .algorithm = {}, .overrides = {}};
          cell.labels.emplace_back("method", algorithm ? algorithm->label : "as_written");
          if (algorithm) {
            cell.algorithm = algorithm->avoider;
            cell.place = algorithm->place;
            cell.overrides.emplace_back("vehicles[*].avoider", algorithm->avoider);
          }
          for (const Overrides* part : {&row, &settings})
            cell.labels.insert(cell.labels.end(), part->begin(), part->end());
          for (const Overrides* part : {&written.set, &row, &settings})
            cell.overrides.insert(cell.overrides.end(), part->begin(), part->end());
          cells.push_back(std::move(cell));
        }
      }
    }
  }
  return cells;
}

void refuse_cells_alike(const std::string& file, std::span<const CampaignCell> cells,
                        const std::function<std::string(std::size_t)>& run_of) {
  std::map<std::string, const CampaignCell*> first;  // of each scenario, method and run
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CampaignCell& cell = cells[i];
    const Labels place{cell.labels.begin(), cell.labels.begin() + 2};
    const std::string key = Digest{}.add(labels_text(place)).add(run_of(i)).hex();
    const auto [found, is_new] = first.try_emplace(key, &cell);
    if (is_new) continue;
    const CampaignCell& other = *found->second;
    throw InputError(file + ": in " + labels_text(place) + ": " + differing(other, cell) + " and " +
                     differing(cell, other) +
                     " are the same run; what is varied is set again elsewhere, or by every vehicle");
  }
}

}  // namespace fairway
