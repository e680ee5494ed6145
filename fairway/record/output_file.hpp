// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <string_view>

namespace fairway {

/// A file that appears under its name whole or not at all: what is written goes to a temporary file beside
/// it, which commit() puts in its place. Whoever never commits, by an exception or by dying, leaves what was
/// there before. A link is followed, so that it stays one; a pipe or a device gets the bytes as they come.
/// A temporary file that outlives its process ends in ".part".
class OutputFile {
 public:
  /// Begins the temporary file. Throws InputError, "`path`: cannot be written: …", as every member does.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& path() const { return path_; }

  /// Where the bytes lie until commit(), for whoever opens files by name.
  const std::string& part() const { return part_; }

  /// To write to. It fails for good at the first error, which check() throws.
  std::ostream& stream() { return stream_; }
  void check() const;

  /// Puts the file in its place, on the disk and not only in its cache. Nothing may be written after it.
  void commit();

 private:
  class Buffer;
  class ListedPart;
  [[noreturn]] void fail(int error) const;
  void begin_part();

  std::string path_;    // as it was given
  std::string target_;  // the same, links followed
  std::string part_;    // target_ itself where that is no plain file
  std::unique_ptr<ListedPart> listed_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_{nullptr};
  bool committed_{false};
};

/// Removes the temporary files of this process, for whoever ends it from within a signal's handler.
void remove_parts() noexcept;

/// OutputFile with all of its bytes at once.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace fairway
