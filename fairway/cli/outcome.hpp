// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <vector>

#include "fairway/cli/runner.hpp"

namespace fairway::cli {

/// An expectation as `run --json` and `test --json` print it; what is not known is null.
nlohmann::json document_of(const Judgement& judgement);

/// What came of a run, as `fairway run --json` prints it.
nlohmann::json document_of(const Scenario& scenario, const RunOutcome& outcome,
                           const std::vector<Judgement>& judgements);

/// The same for people.
void print(const Scenario& scenario, const RunOutcome& outcome, const std::vector<Judgement>& judgements,
           std::ostream& out);

}  // namespace fairway::cli
