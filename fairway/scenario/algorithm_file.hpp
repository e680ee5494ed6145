// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// Whether the name of an algorithm is that of a file with one, such as `fairway tune` leaves.
bool is_algorithm_file(const std::string& name);

/// An algorithm with its parameters, as a scenario's `avoider` has them. Throws InputError with file, line
/// and column. Names of algorithms and parameters are checked later, by the catalogs.
Choice load_algorithm(const std::string& file);

}  // namespace fairway
