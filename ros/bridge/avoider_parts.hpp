// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/avoidance/drawing.hpp"
#include "fairway/onboard/helm.hpp"
#include "ros/bridge/avoider_host.hpp"

namespace fairway::bridge {

Fix fix_of(const Motion& motion);
Triple triple_of(const Vec3& v);
Vec3 vec_of(const Triple& v);

/// What is to be told of a helm at `now` [s], in words and numbers.
Diagnosis diagnosis_of(const Helm& helm, double now);

/// What was drawn of a decision of `own`, as primitives at positions [m, NED]: velocities are shown from the
/// vehicle as the way of ten seconds. Pictures over velocities are left out.
std::vector<Mark> marks_of(const Drawing& drawing, const Ownship& own, double max_speed);

}  // namespace fairway::bridge
