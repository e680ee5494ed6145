// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/avoidance/catalog.hpp"

namespace fairway {

/// Adds the algorithms that plan: rrt_star, blend.
void add_planners(Catalog& catalog);

}  // namespace fairway
