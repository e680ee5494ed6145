// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/decide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <istream>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

#include "fairway/cli/decide/situation_json.hpp"

namespace fairway {
namespace {

constexpr std::size_t max_line_bytes = 16 << 20;

/// Avoiders by the parameters that a line brings. Most lines bring none, or those of the line before,
/// so the last ones made are kept and copied.
class Prototypes {
 public:
  Prototypes(const Catalog& catalog, const DecideOptions& options)
      : catalog_{catalog}, options_{options}, plain_{make({})}, last_{plain_} {}

  const Avoider& of(const ParamValues& line_params, std::size_t line) {
    if (line_params.empty()) return plain_;
    if (line_params == last_params_) return last_;
    try {
      last_ = make(line_params);
      last_params_ = line_params;
      return last_;
    } catch (const InputError& error) {
      throw InputError(fmt::format("line {}: params.{}", line, error.what()));
    }
  }

 private:
  Avoider make(const ParamValues& line_params) const {
    return catalog_.make(options_.algorithm, merged(options_.params, line_params));
  }

  const Catalog& catalog_;
  const DecideOptions& options_;
  Avoider plain_;
  Avoider last_;
  ParamValues last_params_;
};

/// The avoiders that live on, one for each own id.
class Crew {
 public:
  Avoider& of(const DecideRequest& request, const Avoider& prototype) {
    const auto [place, fresh] =
        members_.try_emplace(number(request.without_others.own.id), Member{request.params, prototype});
    Member& member = place->second;
    if (!fresh && member.params != request.params) member = {request.params, prototype};
    return member.avoider;
  }

 private:
  struct Member {
    ParamValues params;
    Avoider avoider;
  };
  std::map<std::uint32_t, Member> members_;
};

void append_number(double value, std::string& out) {
  std::array<char, 32> digits{};
  const double no_negative_zero = value == 0.0 ? 0.0 : value;
  char* end = std::to_chars(digits.data(), digits.data() + digits.size(), no_negative_zero).ptr;
  out.append(digits.data(), end);
}

void append_answer(const Command& command, bool planar, std::string& out) {
  out += "{\"velocity\":[";
  append_number(command.velocity.x(), out);
  out += ',';
  append_number(command.velocity.y(), out);
  out += ',';
  append_number(planar ? 0.0 : command.velocity.z(), out);
  out += "],\"mode\":\"";
  out += EnumNames<Mode>::names.at(static_cast<std::size_t>(command.mode));
  out += '"';
  if (command.turn_rate) {
    out += ",\"turn_rate\":";
    append_number(*command.turn_rate, out);
  }
  if (command.wrench) {
    out += ",\"wrench\":[";
    for (Eigen::Index axis = 0; axis < 6; ++axis) {
      if (axis > 0) out += ',';
      append_number((*command.wrench)[axis], out);
    }
    out += ']';
  }
  if (!command.note.empty()) out += ",\"note\":" + nlohmann::json(command.note).dump();
  out += "}\n";
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

}  // namespace

void decide_lines(std::istream& in, std::ostream& out, const Catalog& catalog, const DecideOptions& options) {
  Prototypes prototypes{catalog, options};
  // a wrapper answers in the dimensions of what it wraps
  const bool planar = catalog.find(options.algorithm.substr(0, options.algorithm.find('+'))).info.planar;
  Crew crew;

  std::string text;
  std::string answers;
  const auto write_answers = [&] {
    out.write(answers.data(), static_cast<std::streamsize>(answers.size()));
    out.flush();
    answers.clear();
  };

  try {
    for (std::size_t line = 1; std::getline(in, text); ++line) {
      if (is_blank(text)) continue;
      if (text.size() > max_line_bytes)
        throw InputError(fmt::format("line {}: longer than {} bytes", line, max_line_bytes));
      const DecideRequest request = parse_situation(text, line);
      const Avoider& prototype = prototypes.of(request.params, line);
      Command command;
      if (options.keep_memory) {
        command = crew.of(request, prototype).decide(request.situation());
      } else {
        command = Avoider{prototype}.decide(request.situation());
      }
      append_answer(command, planar, answers);
      if (answers.size() > 65536 || in.rdbuf()->in_avail() <= 0) write_answers();
    }
  } catch (const InputError&) {
    write_answers();
    throw;
  }
  write_answers();
}

}  // namespace fairway
