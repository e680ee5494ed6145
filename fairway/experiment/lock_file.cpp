// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/lock_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "fairway/core/error.hpp"

namespace fairway {

namespace {

bool is_lockless(int error) { return error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP; }

}  // namespace

LockFile::LockFile(const std::string& guarded, Lockless lockless) {
  // one lock for one file, however it is spelled
  std::error_code ignored;
  path_ = std::filesystem::weakly_canonical(guarded, ignored).string();
  path_ = (path_.empty() ? guarded : path_) + ".lock";
  while (true) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw InputError(guarded + ": cannot be written: " + std::generic_category().message(errno));
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      if (lockless == Lockless::go_on && is_lockless(error)) return;
      ::close(descriptor_);
      if (error == EINTR) continue;
      if (error != EWOULDBLOCK) {
        throw InputError(guarded + ": cannot be locked: " + std::generic_category().message(error));
      }
      throw InputError(guarded + ": another process is writing to it; wait for it to end, or stop it: " +
                       "what it has stored is kept");
    }
    // the holder before may have removed the file between open and flock: then this lock guards nothing
    struct stat held {};
    struct stat named {};
    if (::fstat(descriptor_, &held) == 0 && ::stat(path_.c_str(), &named) == 0 &&
        held.st_ino == named.st_ino && held.st_dev == named.st_dev) {
      return;
    }
    ::close(descriptor_);
  }
}

LockFile::~LockFile() {
  ::unlink(path_.c_str());  // before letting go, so that nobody removes a successor's
  ::close(descriptor_);
}

}  // namespace fairway
