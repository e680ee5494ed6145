// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/sim/catalogs.hpp"
#include "fairway/studies/cubes/plan.hpp"
#include "fairway/studies/study.hpp"

namespace fairway::cubes {

/// raja2024: AUVs that cross a cube to the opposite vertex.
Study study();

/// What comes with fairway, and the published code's ways (as_coded.hpp).
const Catalogs& cube_catalogs();

/// Makes the runs of these cells that the options' store lacks, as make_cells().
bool make_crossings(std::vector<Cell>& cells, const StudyOptions& options);

/// The whole experiment: parameter phase and comparison phase as coded, five runs a cell, then the
/// comparison corrected, `options.seeds` runs a cell.
StudyResult run_cubes(const StudyOptions& options);

}  // namespace fairway::cubes
