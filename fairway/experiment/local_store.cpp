// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/local_store.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "fairway/core/error.hpp"
#include "fairway/experiment/merge.hpp"
#include "fairway/record/output_file.hpp"

namespace fairway {
namespace {

constexpr const char* local_name = "/results.db";

/// False if there is nothing whose runs are to be taken over.
bool is_to_be_continued(const std::string& path, Store::Foreign foreign) {
  std::error_code missing;
  const auto size = std::filesystem::file_size(path, missing);
  if (missing || size == 0) return false;
  return foreign == Store::Foreign::refuse || is_of_kind(path, store_file);
}

}  // namespace

LocalStore::Folder::Folder() {
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  if (error) throw InputError("no place for temporary files: TMPDIR is no folder");
  path = (place / ("fairway-" + std::string(6, 'X'))).string();
  if (::mkdtemp(path.data()) == nullptr)
    throw InputError(path + ": cannot be made a folder: " + std::generic_category().message(errno));
}

LocalStore::Folder::~Folder() {
  std::error_code ignored;
  if (!is_kept) std::filesystem::remove_all(path, ignored);
}

LocalStore::LocalStore(std::string path, Store::Foreign foreign) : path_{std::move(path)} {
  std::error_code none;
  const std::filesystem::file_status there = std::filesystem::status(path_, none);
  if (!std::filesystem::exists(there) || std::filesystem::is_regular_file(there))
    lock_.emplace(path_, LockFile::Lockless::go_on);
  const bool continued = is_to_be_continued(path_, foreign);
  if (continued) Store::open_existing(path_);  // refuses what is none, before anything is made
  folder_.emplace();
  store_.emplace(Store::open(folder_->path + local_name));
  if (continued) merge_into(*store_, path_, std::array{path_});
}

void LocalStore::publish() {
  const std::string local = folder_->path + local_name;
  try {
    OutputFile file{path_};
    std::ifstream bytes{local, std::ios::binary};
    file.stream() << bytes.rdbuf();
    if (!bytes) throw InputError(local + ": cannot be read");
    file.commit();
  } catch (const InputError& error) {
    folder_->is_kept = true;
    throw InputError(std::string(error.what()) + "; its runs are kept in " + local);
  }
}

}  // namespace fairway
