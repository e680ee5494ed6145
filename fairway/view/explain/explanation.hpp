// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/view/explain/found_decision.hpp"

namespace fairway {

struct ExplanationTable {
  using Cell = std::variant<std::string, double>;
  std::vector<std::string> columns;  ///< with their units; none: there is no table
  std::vector<std::vector<Cell>> rows;
};

struct ExplanationSection {
  std::string title;
  std::vector<std::string> lines;
  ExplanationTable table;
};

/// Why a decision is what it is, in words and tables: what follows from the situation, the command and what
/// was drawn, and nothing that would have to be guessed.
struct Explanation {
  std::size_t vehicle{};  ///< index
  double time{};          ///< of the frame asked about [s]
  std::string avoider;    ///< in force; empty where nothing was decided
  std::string headline;
  std::vector<ExplanationSection> sections;
};

/// `avoiders` says what the method is and which parameters it has. O(neighbours + obstacles + strokes).
Explanation explain(const Scenario& scenario, const FoundDecision& found, const Catalog& avoiders);

/// For the page; viewer/README.md describes its keys. Numbers are rounded to what is worth reading.
nlohmann::json page_json(const Explanation& explanation);

/// The same words, and the situation, the command, everything that was drawn and the facts that follow from
/// them, every number as it is; null where there is none or it is infinite.
nlohmann::json exact_json(const Scenario& scenario, const FoundDecision& found,
                          const Explanation& explanation);

/// The method and the strategies around it, in the order of their names. Throws InputError for unknown ones.
std::vector<const Catalog::Entry*> layers_of(std::string_view name, const Catalog& avoiders);

/// The parameters of a vehicle's method as they are in force.
std::vector<ParamInfo> params_in_force(const Choice& avoider, const Catalog& avoiders);

}  // namespace fairway
