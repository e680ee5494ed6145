// SPDX-License-Identifier: Apache-2.0
// In place of record's: there are no files, and what is committed is kept for the page.
#include "fairway/record/output_file.hpp"

#include <sstream>
#include <utility>

#include "bindings/web/output_file.hpp"

namespace fairway {
namespace web {
namespace {

std::string committed;

}  // namespace

std::string taken_file() { return std::exchange(committed, {}); }

}  // namespace web

class OutputFile::Buffer : public std::stringbuf {};
class OutputFile::ListedPart {};

OutputFile::OutputFile(std::string path)
    : path_{std::move(path)}, target_{path_}, part_{path_}, buffer_{std::make_unique<Buffer>()} {
  stream_.rdbuf(buffer_.get());
}

OutputFile::~OutputFile() = default;

void OutputFile::check() const {}

void OutputFile::commit() {
  web::committed = std::move(*buffer_).str();
  committed_ = true;
}

}  // namespace fairway
