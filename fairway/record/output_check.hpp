// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace fairway {

/// A kind of file that we write, and how it is known again. Declared where it is written.
struct FileKind {
  std::string_view name;             ///< "a recording of fairway"
  std::string_view begins;           ///< its first bytes
  std::string_view holds;            ///< somewhere in the bytes that are searched
  bool is_table{false};              ///< text that may go to standard output, as "-"
  std::size_t searched_bytes{4096};  ///< of its beginning
};

/// True of an empty file too, in which nothing can be lost. Throws nothing: what cannot be read is of no
/// kind.
bool is_of_kind(const std::string& path, const FileKind& kind);

/// A file that is about to be written.
struct Output {
  std::string flag;  ///< or argument that names it, for messages: "--out"
  std::string path;  ///< nothing is written if empty
  FileKind kind;
};

/// Throws InputError, "--out a.mcap: …", unless every one of `outputs` can be written and nothing is lost by
/// it. Whatever is one of `inputs`, by whatever path or link, or of two outputs, is refused; so is a file
/// that is there and is not of the kind that is to be written, unless `force`. Pipes and devices are fine.
void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs, bool force);

}  // namespace fairway
