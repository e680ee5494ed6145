// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/studies/study.hpp"

namespace fairway::transport {

/// rehman2021: an underwater transport system of four vehicles among obstacles.
Study study();

/// The published runs on both plants, every method on the cases, and on `options.seeds` random fields of each
/// kind.
StudyResult run_transport(const StudyOptions& options);

}  // namespace fairway::transport
