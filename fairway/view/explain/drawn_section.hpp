// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "fairway/scenario/scenario.hpp"
#include "fairway/view/explain/explanation.hpp"
#include "fairway/view/explain/stroke_facts.hpp"

namespace fairway {

/// What the method drew of its thinking, by meaning; and if it drew half-spaces, each of them, the one that
/// the preferred velocity is farthest outside of first.
std::vector<ExplanationSection> drawn_sections(const Scenario& scenario, std::span<const StrokeFacts> drawn,
                                               const Vec3& preferred, const Vec3& commanded);

}  // namespace fairway
