// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace fairway {

/// A folder of its own, gone at the end of the test.
class TemporaryFolder {
 public:
  /// Throws std::runtime_error if there can be none.
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "fairway-").string();
    name += std::string(6, 'X');  // for mkdtemp to choose
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace fairway
