// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/builtin.hpp"

#include "fairway/planning/blend/blend.hpp"
#include "fairway/planning/rrt_star/rrt_star.hpp"
#include "fairway/planning/teb/teb.hpp"

namespace fairway {

void add_planners(Catalog& catalog) { catalog.add<RrtStar>().add<Blend>().add<Teb>(); }

}  // namespace fairway
