// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/reference.hpp"

#include <fmt/format.h>
#include <zstd.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <tuple>

#include "fairway/core/error.hpp"
#include "fairway/exam/exam_file.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/experiment/version.hpp"

namespace fairway {
namespace {

constexpr std::string_view labels = "family,condition,method,tuned,ground,seed";
constexpr std::size_t max_bytes = std::size_t{1} << 30U;

std::string header() {
  std::string line{labels};
  for (const OutcomeMember& member : outcome_members()) line += "," + std::string(member.name);
  return line + "\n";
}

std::string table_of(const ExamReference& reference) {
  std::string table = header();
  for (const ExamRun& run : reference.runs) {
    table += fmt::format("{},{},{},{},{},{}", run.family, run.condition, run.method, run.tuned, run.ground,
                         run.seed);
    for (const OutcomeMember& member : outcome_members()) {
      const double value = run.outcome.*member.member;
      table += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
    }
    table += "\n";
  }
  return table;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// One line after the other, with its number.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : text_{text}, file_{std::move(file)} {}

  bool is_at_end() const { return text_.empty(); }
  std::string_view rest() const { return text_; }
  std::string_view next() {
    const std::size_t end = text_.find('\n');
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
    ++number_;
    return line;
  }
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError({file_, number_, 1}, "", message);
  }

 private:
  std::string_view text_;
  std::string file_;
  int number_{};
};

template <class Number>
Number number_in(std::string_view text, const Lines& lines) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size())
    lines.refuse("expected a number, got \"" + std::string(text) + "\"");
  return number;
}

ExamRun run_in(std::string_view line, const Lines& lines) {
  const std::vector<std::string_view> fields = fields_of(line);
  if (fields.size() != 6 + outcome_members().size())
    lines.refuse("expected " + std::to_string(6 + outcome_members().size()) + " columns, got " +
                 std::to_string(fields.size()));
  if (fields[3] != "true" && fields[3] != "false") lines.refuse("tuned is neither true nor false");
  ExamRun run{.family = std::string(fields[0]),
              .condition = std::string(fields[1]),
              .method = std::string(fields[2]),
              .tuned = fields[3] == "true",
              .ground = std::string(fields[4]),
              .seed = number_in<std::uint64_t>(fields[5], lines),
              .outcome = failed_exam(),
              .command = {}};
  for (std::size_t i = 0; i < outcome_members().size(); ++i)
    run.outcome.*outcome_members()[i].member = fields[6 + i].empty()
                                                   ? std::numeric_limits<double>::quiet_NaN()
                                                   : number_in<double>(fields[6 + i], lines);
  return run;
}

}  // namespace

std::string reference_text(const ExamReference& reference) {
  const std::string table = table_of(reference);
  std::string text = "# fairway exam\n# epoch " + std::to_string(reference.epoch) + "\n";
  text += "# made by " + reference.maker + "\n";
  for (const auto& [family, digest] : reference.grounds) text += "# grounds " + family + " " + digest + "\n";
  for (const auto& [label, digest] : reference.avoiders) text += "# avoider " + digest + " " + label + "\n";
  return text + "# table " + Digest::of(table) + "\n" + table;
}

ExamReference parse_reference(std::string_view text, const std::string& file) {
  Lines lines{text, file};
  ExamReference reference;
  std::string digest;
  if (lines.next() != "# fairway exam") lines.refuse("not stored results of an exam");
  while (lines.rest().starts_with("# ")) {
    const std::string_view line = lines.next().substr(2);
    const std::size_t space = line.find(' ');
    const std::string_view key = line.substr(0, space);
    const std::string_view value = space == std::string_view::npos ? "" : line.substr(space + 1);
    if (key == "epoch") reference.epoch = number_in<int>(value, lines);
    if (key == "epoch" && reference.epoch != results_epoch)
      lines.refuse("is of the results epoch " + std::string(value) + ", and this fairway is of " +
                   std::to_string(results_epoch) + ": the same scenarios come to other numbers");
    if (key == "made") reference.maker = value.substr(value.find(' ') + 1);
    if (key == "table") digest = value;
    if (key != "grounds" && key != "avoider") continue;
    const std::size_t end = value.find(' ');
    if (end == std::string_view::npos) lines.refuse(std::string(key) + " without a digest");
    const std::string first{value.substr(0, end)}, rest{value.substr(end + 1)};
    if (key == "grounds") reference.grounds[first] = rest;
    if (key == "avoider") reference.avoiders[rest] = first;
  }
  if (Digest::of(lines.rest()) != digest) lines.refuse("the table is not the one that its digest is of");
  if (std::string{lines.next()} + "\n" != header()) lines.refuse("has other columns: " + header());
  while (!lines.is_at_end()) reference.runs.push_back(run_in(lines.next(), lines));
  return reference;
}

std::string compressed(std::string_view text) {
  constexpr int level = 19;
  std::string bytes(ZSTD_compressBound(text.size()), '\0');
  const std::size_t size = ZSTD_compress(bytes.data(), bytes.size(), text.data(), text.size(), level);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  bytes.resize(size);
  return bytes;
}

std::string read_maybe_compressed(const std::string& file) {
  std::string bytes = text_of_file(file);
  if (!bytes.starts_with(reference_file.begins)) return bytes;
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > max_bytes)
    throw InputError({file, 0, 0}, "", "is damaged: no whole zstd frame of a known size");
  std::string text(size, '\0');
  const std::size_t got = ZSTD_decompress(text.data(), text.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) != 0 || got != size)
    throw InputError({file, 0, 0}, "", "is damaged: no whole zstd frame of a known size");
  return text;
}

}  // namespace fairway
