// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/studies/study.hpp"

namespace fairway::surface {

/// campos2019: AVOA against TEB with one surface vessel, on the paper's five courses as proposed here, and
/// then what five single runs cannot show: both and everything else of the catalog that works in the plane,
/// on seeded variations in waves and current.
Study study();

}  // namespace fairway::surface
