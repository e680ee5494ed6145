// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "fairway/cli/program.hpp"
#include "fairway/core/text.hpp"
#include "fairway/studies/study.hpp"
#include "fairway/view/description.hpp"

namespace fairway::cli {
namespace {

using nlohmann::json;

json describe(const std::string& name, const Catalogs& catalogs) {
  std::vector<std::string_view> known;
  if (std::optional<json> found = description(name, catalogs, known)) return *std::move(found);
  for (const Study& study : builtin_studies()) {
    known.push_back(study.name);
    if (study.name == name) {
      return {{"kind", "study"}, {"name", name}, {"title", study.title}, {"source", study.source}};
    }
  }
  throw InputError("nothing is called \"" + name + "\"" + suggestion(name, known));
}

std::string text_of(const json& value) {
  if (value.is_null()) return "none";
  if (value.is_number()) return number_text(value.get<double>());
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// To three digits; a list in brackets.
std::string rounded(const json& value) {
  if (!value.is_array()) return fmt::format("{:.3g}", value.get<double>());
  return fmt::format("[{:.3g}]", fmt::join(value.get<std::vector<double>>(), ", "));
}

void print_entry(const json& entry, const std::string& list = {}) {
  const std::string name = list + entry["name"].get<std::string>();
  std::string range;
  if (entry.contains("range"))
    range = fmt::format("[{}, {}]", text_of(entry["range"][0]), text_of(entry["range"][1]));
  if (entry.contains("choices")) range = entry["choices"].dump();
  if (entry.contains("items")) range = "list";
  const std::string value = entry.contains("default") ? text_of(entry["default"]) : "";
  std::cout << fmt::format("  {:<32} {:<12} {:<24} {}\n", name, value, range,
                           entry["meaning"].get<std::string>());
  if (!entry.contains("items")) return;
  for (const json& item : entry["items"]) print_entry(item, name + "[i].");
}

void print_table(const json& entries, std::string_view title) {
  if (entries.empty()) return;
  std::cout << title << "\n";
  for (const json& entry : entries) print_entry(entry);
}

void print(const json& document) {
  for (const auto& [key, value] : document.items()) {
    if (value.is_array()) continue;
    std::cout << fmt::format("{:<18} {}\n", key, text_of(value));
  }
  print_table(document.value("actuators", json::array()), "actuators (name, limits, meaning)");
  const json envelope = document.value("envelope", json::array());
  if (!envelope.empty())
    std::cout << "envelope in still water, without limits of a mission (name, value, meaning)\n";
  for (const json& entry : envelope)
    std::cout << fmt::format("  {:<26} {:<28} {}\n", entry["name"].get<std::string>(),
                             rounded(entry["value"]), entry["meaning"].get<std::string>());
  print_table(document.value("parameters", json::array()), "parameters (name, default, range, meaning)");
}

}  // namespace

void add_describe(CLI::App& app, Program& program) {
  CLI::App* verb = app.add_subcommand(
      "describe", "An algorithm, vehicle, study, metric or kind of exchange: source, parameters");
  verb->footer("Example: fairway describe orca3d+stop_and_wait");
  auto name = std::make_shared<std::string>();
  auto as_json = std::make_shared<bool>(false);
  verb->add_option("name", *name, "as `fairway list` shows it")->required();
  verb->add_flag("--json", *as_json, "print JSON");
  program.on(*verb, [=, &program] {
    const json document = describe(*name, program.catalogs);
    if (*as_json) {
      std::cout << document.dump(2) << "\n";
    } else {
      print(document);
    }
    return ok;
  });
}

}  // namespace fairway::cli
