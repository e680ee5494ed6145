// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "fairway/record/output_check.hpp"
#include "fairway/tuning/tune.hpp"

namespace fairway {

/// The result for people: what was found, how it did on every set beside the method as written, and how much
/// of the gain was luck.
std::string tuning_text(const TuningFile& tuning, const TuningResult& result);

/// The same with full precision. What is unknown is null.
nlohmann::json to_json(const TuningFile& tuning, const TuningResult& result);

/// An avoider as scenarios, campaigns and `run --algorithm` take it, with where it comes from in comments.
std::string tuned_avoider(const TuningFile& tuning, const TuningResult& result, const std::string& command);

/// Throws InputError where `document`, a result of the same search that lies in `file`, was made with a
/// larger budget than this one: what was found with less would take the place of what was found with more.
void refuse_smaller_budget(const nlohmann::json& document, const std::string& file, std::size_t budget);

/// tuned_avoider() as a file.
inline constexpr FileKind tuned_file{
    .name = "an avoider that fairway tuned", .begins = "# Tuned by fairway", .holds = "algorithm:"};

/// to_json() as a file.
inline constexpr FileKind tuning_document{
    .name = "a result of fairway tune",
    .begins = "{",
    .holds = "\"fairway_tuning_result\"",
    .searched_bytes = std::size_t{16} << 20U};  // keys are sorted, and the whole curve comes before this one

}  // namespace fairway
