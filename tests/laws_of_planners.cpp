// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/builtin.hpp"
#include "tests/laws.hpp"

namespace fairway::laws {
namespace {

std::vector<std::string> planners() {
  Catalog catalog;
  add_planners(catalog);
  std::vector<std::string> names{"rrt_star+safety_filter"};
  for (const Catalog::Entry& entry : catalog.entries()) names.emplace_back(entry.info.name);
  return names;
}

}  // namespace

Catalog catalog() {
  Catalog all = builtin_avoiders();
  add_planners(all);
  return all;
}

INSTANTIATE_TEST_SUITE_P(OfThePlanners, Laws, testing::ValuesIn(planners()), test_name);

}  // namespace fairway::laws
