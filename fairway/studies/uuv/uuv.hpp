// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/studies/study.hpp"

namespace fairway::uuv {

/// cao2022: two UUVs that avoid each other and ships by velocity obstacles, in both published encounters;
/// then every other method on them, gatherings of up to fifty with sonar and acoustic exchange, and
/// raja2024's cubes over an acoustic channel that tells less and less.
Study study();

}  // namespace fairway::uuv
