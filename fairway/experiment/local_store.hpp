// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "fairway/experiment/lock_file.hpp"
#include "fairway/experiment/store.hpp"

namespace fairway {

/// A store that is made on local disk and put in its place whole: for disks that machines share, on which no
/// database should be opened to write. Nobody else sees it before publish(). Holds `path` + ".lock" while it
/// lives, as a store that is opened there does, so that nothing of what two would publish is lost; but not of
/// a pipe or a device, nor on a disk that knows no locks.
class LocalStore {
 public:
  /// Begins it in a folder of its own where temporary files go (TMPDIR), with the runs of the store that is
  /// to be at `path`, if one is there. Throws InputError if that is damaged, or something else that is not to
  /// be replaced, if another process writes to it, or if there is no room for temporary files.
  explicit LocalStore(std::string path, Store::Foreign foreign = Store::Foreign::refuse);

  Store& store() { return *store_; }
  const Store& store() const { return *store_; }

  /// Puts a copy, as it is now, in its place. May be called again and again, between two put(). Throws
  /// InputError if it cannot be written; then what was there stays, and so does the local one, whose name is
  /// told.
  void publish();

 private:
  /// Removed in the end, with what is in it.
  struct Folder {
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string path;
    bool is_kept{false};
  };
  std::string path_;
  std::optional<LockFile> lock_;  // let go of last
  std::optional<Folder> folder_;
  std::optional<Store> store_;  // closed before its folder goes
};

}  // namespace fairway
