// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fairway/studies/cell.hpp"
#include "fairway/studies/uuv/encounter.hpp"
#include "fairway/studies/uuv/gathering.hpp"
#include "fairway/studies/uuv/silence.hpp"

namespace fairway::uuv {

/// The published value of a quantity, or nothing. The parallel goals have none: they are not the paper's as
/// adopted here.
std::optional<double> published(Encounter encounter, std::string_view quantity);

/// The setting that fits an encounter.
std::string_view fit_of(Encounter encounter);

/// The labels of the published cell of an encounter.
Labels published_labels(Encounter encounter, const Setting& setting, Hull hull, const Method& method);

/// RVO in every setting as the point, the encounter's fit first, in the chosen ones also as the unicycle;
/// then every other method of the plane in the common setting. One run each: nothing is drawn.
std::vector<Cell> published_cells();

/// Both encounters in `seeds` variations, common setting, every method.
std::vector<Cell> varied_cells(int seeds);

/// Every gathering, awareness and method that go together, `seeds` runs each. Those with 32 and more
/// vehicles have a fifth as many.
std::vector<Cell> gathering_cells(int seeds);

/// The cubes under perfect exchange, under every update rate and loss, and with the modem; `seeds` runs each.
std::vector<Cell> silence_cells(int seeds);

}  // namespace fairway::uuv
