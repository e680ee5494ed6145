// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "fairway/avoidance/trackable/foresight.hpp"
#include "fairway/core/angles.hpp"

namespace fairway::trackable {

/// Plans as columns.
struct Columns {
  std::array<double, most_courses> cosines, sines;
  Courses courses{.north = 1.0, .side = 1.0, .cosines = cosines.data(), .sines = sines.data(), .speeds = {}};

  explicit Columns(const std::vector<Plan>& plans) {
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      const Plan& plan = plans[std::min(i, plans.size() - 1)];
      cosines[i] = plan.direction.x();
      sines[i] = plan.direction.y();
      courses.speeds[i] = plan.speed;
      courses.quickest = std::max(courses.quickest, plan.speed);
    }
  }
};

inline Prospect prospect_of(const Foresight& foresight, const Plan& plan) {
  return foresight.best_of(plan, Columns{{plan}}.courses, 1).prospect;
}

inline Foresight foresight_of(const TurnLaw& law, const Situation& s, const Outlook& outlook) {
  return {law, s, unit_at(s.own.yaw), outlook};
}

}  // namespace fairway::trackable
