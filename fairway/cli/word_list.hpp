// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fairway::cli {

/// An option of several words with commas between, as `--families cubes,spheres`, each of which goes through
/// `each`. An empty one, and one that is given twice, are refused: whoever types them means something else.
/// `words` must live as long as the verb does.
CLI::Option* add_word_list(CLI::App& verb, const std::string& flag, std::vector<std::string>& words,
                           const std::string& help, const CLI::Validator& each = {});

}  // namespace fairway::cli
