// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway {

/// Held by at most one process at a time; let go of by the system when the process dies, however it
/// dies. The empty file it leaves behind then is no obstacle.
class LockFile {
 public:
  /// Where the disk knows no locks, as some do that machines share.
  enum class Lockless { refuse, go_on };

  /// Throws InputError, about the file `guarded`, if another holds it or it cannot be made.
  explicit LockFile(const std::string& guarded, Lockless lockless = Lockless::refuse);
  ~LockFile();
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

 private:
  std::string path_;
  int descriptor_{-1};
};

}  // namespace fairway
