// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/study.hpp"

/// Blocks of a report document; viewer/README.md describes what the page makes of them.
namespace fairway::page {

/// A number, or null where it is not finite.
nlohmann::json number(double value);

/// A box of a box plot, or null of no values.
nlohmann::json box(std::vector<double> values);

/// A point of an interval chart.
nlohmann::json interval(const MeanEstimate& estimate, std::optional<double> published);

nlohmann::json note(std::string_view tone, std::string text);

nlohmann::json grid(int columns, std::vector<nlohmann::json> blocks);

/// Published against measured, one line a row.
nlohmann::json comparison_table(std::string title, std::span<const StudyRow> rows);

}  // namespace fairway::page
