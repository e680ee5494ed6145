// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fairway/studies/cell.hpp"
#include "fairway/studies/transport/field.hpp"
#include "fairway/studies/transport/transport_case.hpp"

namespace fairway::transport {

/// Tells the published runs from those on the same cases under the common rules.
inline constexpr std::string_view published_part = "published";

/// The four published runs on both plants.
std::vector<Cell> published_cells();

/// What is compared beyond the publication: its methods as printed, corrected and filtered, the blend, and
/// other methods of the catalog that command velocities.
std::span<const Method> compared_methods();

/// Every method on the two cases and on the one with an unknown obstacle.
std::vector<Cell> case_cells();

/// Every method on `seeds` random fields of each kind.
std::vector<Cell> field_cells(int seeds);

}  // namespace fairway::transport
