// SPDX-License-Identifier: Apache-2.0
#include "tests/laws.hpp"

namespace fairway::laws {

Catalog catalog() { return builtin_avoiders(); }

INSTANTIATE_TEST_SUITE_P(OfTheCatalog, Laws,
                         testing::ValuesIn(everybody({"apf+stop_and_wait", "orca3d+stop_and_wait",
                                                      "orca3d+safety_filter", "wall_following+safety_filter",
                                                      "apf+inflate", "orca3d+inflate", "orca3d+trackable",
                                                      "hrvo+trackable", "orca2d+way_round"})),
                         test_name);

}  // namespace fairway::laws
