// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "fairway/scenario/tree.hpp"

namespace fairway {

/// A line of JSON as a tree that `yaml::Value` reads, placed at "line 17"; null is a word that nothing reads.
/// Throws InputError: "line 17: not JSON at column 5", a key given twice, nested too deep.
yaml::Tree parse_json(std::string_view text, std::size_t line);

}  // namespace fairway
