// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/paths.hpp"

#include <filesystem>
#include <system_error>

#include "fairway/core/error.hpp"

namespace fairway::cli {

void make_folder(const std::string& folder, const std::string& flag) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(flag + " " + folder + ": cannot be made a folder: " + error.message());
}

}  // namespace fairway::cli
