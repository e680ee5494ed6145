// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "fairway/core/error.hpp"

namespace fairway {
namespace {

namespace fs = std::filesystem;

/// What a chain of links ends at, be it there or not. It ends in /proc, where links are descriptors.
fs::path followed(fs::path path) {
  std::error_code none;
  constexpr int most_links = 40;  // as Linux
  for (int i = 0; i < most_links && fs::is_symlink(path, none); ++i) {
    if (path.string().starts_with("/proc/")) break;
    const fs::path to = fs::read_symlink(path, none);
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return path;
}

/// A file that can be replaced, or a name that nothing has; else a pipe, a device or a descriptor.
bool is_replaceable(const std::string& target) {
  std::error_code none;
  const fs::file_status status = fs::status(target, none);
  return !target.starts_with("/proc/") && (!fs::exists(status) || fs::is_regular_file(status));
}

/// The name of a temporary file, where a signal's handler finds it.
struct PartName {
  std::atomic<bool> is_taken{false};
  std::atomic<bool> is_whole{false};
  std::array<char, PATH_MAX> path{};
};
std::array<PartName, 64> part_names;

/// A rename is on the disk when its folder is.
void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

/// Writes to a descriptor, and remembers the first error.
class OutputFile::Buffer : public std::streambuf {
 public:
  explicit Buffer(int descriptor) : descriptor_{descriptor}, bytes_(std::size_t{1} << 16U) { empty(); }
  ~Buffer() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  int error() const { return error_; }

  /// Brings the bytes to the disk. Not every file system can.
  void sync_to_disk() {
    if (error_ == 0 && ::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOSYS && errno != EROFS)
      error_ = errno;
  }

  void close() {
    if (::close(std::exchange(descriptor_, -1)) != 0 && error_ == 0) error_ = errno;
  }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

  int sync() override {
    const char* from = pbase();
    while (error_ == 0 && from != pptr()) {
      const ssize_t written = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
      if (written >= 0) {
        from += written;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    empty();
    return error_ == 0 ? 0 : -1;
  }

 private:
  void empty() { setp(bytes_.data(), bytes_.data() + bytes_.size()); }

  int descriptor_;
  int error_{};
  std::vector<char> bytes_;
};

/// Lists a temporary file while it lives. Of very many some are not listed.
class OutputFile::ListedPart {
 public:
  explicit ListedPart(const std::string& path) {
    if (path.size() >= PATH_MAX) return;
    for (PartName& name : part_names) {
      if (name.is_taken.exchange(true)) continue;
      std::memcpy(name.path.data(), path.c_str(), path.size() + 1);
      name.is_whole = true;
      name_ = &name;
      return;
    }
  }
  ~ListedPart() {
    if (name_ == nullptr) return;
    name_->is_whole = false;
    name_->is_taken = false;
  }
  ListedPart(const ListedPart&) = delete;
  ListedPart& operator=(const ListedPart&) = delete;

 private:
  PartName* name_{};
};

void remove_parts() noexcept {
  for (const PartName& name : part_names)
    if (name.is_whole) ::unlink(name.path.data());
}

OutputFile::OutputFile(std::string path) : path_{std::move(path)}, target_{followed(path_).string()} {
  std::error_code none;
  if (fs::is_directory(target_, none)) fail(EISDIR);
  if (is_replaceable(target_)) {
    begin_part();
  } else {
    part_ = target_;
    const int descriptor = ::open(part_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor < 0) fail(errno);
    buffer_ = std::make_unique<Buffer>(descriptor);
  }
  stream_.rdbuf(buffer_.get());
}

/// A file of a name that nobody has, with the rights of the one that it is to replace.
void OutputFile::begin_part() {
  constexpr int most_attempts = 1000;
  int descriptor = -1;
  for (int i = 0; descriptor < 0 && i < most_attempts; ++i) {
    part_ = target_ + "." + std::to_string(::getpid()) + (i == 0 ? "" : "-" + std::to_string(i)) + ".part";
    descriptor = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) fail(errno);
  }
  if (descriptor < 0) fail(EEXIST);
  listed_ = std::make_unique<ListedPart>(part_);
  buffer_ = std::make_unique<Buffer>(descriptor);
  struct stat replaced {};
  if (::stat(target_.c_str(), &replaced) == 0)
    static_cast<void>(::fchmod(descriptor, replaced.st_mode & 07777U));
}

OutputFile::~OutputFile() {
  if (!committed_ && part_ != target_) ::unlink(part_.c_str());
}

void OutputFile::fail(int error) const {
  throw InputError(path_ + ": cannot be written: " + std::generic_category().message(error));
}

void OutputFile::check() const {
  if (buffer_->error() != 0) fail(buffer_->error());
  if (!stream_) fail(EIO);  // what was to be copied could not be read
}

void OutputFile::commit() {
  if (committed_) return;
  stream_.flush();
  const bool replaces = part_ != target_;
  if (replaces) buffer_->sync_to_disk();
  buffer_->close();
  check();
  if (replaces) {
    if (::rename(part_.c_str(), target_.c_str()) != 0) fail(errno);
    listed_.reset();
    sync_folder(fs::path{target_}.parent_path());
  }
  committed_ = true;
}

void write_file(const std::string& path, std::string_view bytes) {
  OutputFile file{path};
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

}  // namespace fairway
