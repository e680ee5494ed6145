// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway {

/// Heap allocations made by this process so far. Link only into tests and benchmarks.
long allocation_count();

}  // namespace fairway
