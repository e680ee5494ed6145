// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/experiment/statistics.hpp"
#include "fairway/studies/cell.hpp"

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

/// One quantity of every method by place, with its interval, where it is among the rows.
nlohmann::json method_intervals(std::span<const StudyRow> rows, std::span<const Method> methods,
                                std::string_view quantity, const char* label,
                                const std::vector<std::string>& places);

nlohmann::json section(const char* id, const char* title, std::vector<std::string> paragraphs,
                       std::vector<nlohmann::json> blocks);

/// The obstacles and goal seen from above, and the ways through them (`vehicles` of the block
/// `trajectories`).
nlohmann::json scene(const std::string& title, nlohmann::json tracks, std::span<const ObstacleSpec> obstacles,
                     const Vec3& goal);

}  // namespace fairway::page
