// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace fairway::cli {

/// Of a flag or argument that names something, a file or folder most of all, as `option->check(not_empty())`:
/// an empty name is that of a shell variable that is not set, and no wish for nothing.
inline CLI::Validator not_empty() {
  return {[](std::string& text) -> std::string { return text.empty() ? "is empty; expected a name" : ""; },
          ""};
}

/// Makes a folder and those that it lies in, unless they are there. Throws InputError, which begins with
/// `flag`.
void make_folder(const std::string& folder, const std::string& flag);

}  // namespace fairway::cli
