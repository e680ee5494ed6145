// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/decide/decide.hpp"

#include <fmt/format.h>

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
class Deciders {
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

void append_value(double value, std::string& out) { append_number(value, out); }
void append_value(bool value, std::string& out) { out += value ? "true" : "false"; }
void append_value(Mode mode, std::string& out) { out.append("\"").append(enum_name(mode)).append("\""); }
void append_value(std::string_view text, std::string& out) { out += nlohmann::json(text).dump(); }
template <int Rows>
void append_value(const Eigen::Matrix<double, Rows, 1>& values, std::string& out) {
  for (Eigen::Index i = 0; i < Rows; ++i) {
    out += i == 0 ? '[' : ',';
    append_number(values[i], out);
  }
  out += ']';
}
template <class T>
void append_value(const std::optional<T>& value, std::string& out) {
  append_value(*value, out);
}

/// Velocity and mode always; of the rest what is not as usual.
void append_answer(Command command, bool planar, std::string& out) {
  static const Command usual;
  if (planar) command.velocity.z() = 0.0;
  const std::size_t begin = out.size();
  for_each_member<Command>([&](const auto& m) {
    const bool always = m.name == "velocity" || m.name == "mode";
    if (!always && command.*m.at == usual.*m.at) return;
    out.append(out.size() == begin ? "{\"" : ",\"").append(m.name).append("\":");
    append_value(command.*m.at, out);
  });
  out += "}\n";
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

}  // namespace

void decide_lines(std::istream& in, std::ostream& out, const Catalog& catalog, const DecideOptions& options) {
  Prototypes prototypes{catalog, options};
  // a wrapper answers in the dimensions of what it wraps
  const bool planar = catalog.find(options.algorithm.substr(0, options.algorithm.find('+'))).info.planar;
  Deciders deciders;

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
        command = deciders.of(request, prototype).decide(request.situation());
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
