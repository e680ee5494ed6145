// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/study.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/study_run.hpp"
#include "fairway/experiment/executor.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/record/recording_writer.hpp"
#include "fairway/report/page.hpp"
#include "fairway/view/playback.hpp"

namespace fairway::cli {
namespace {

struct StudyFlags {
  std::vector<std::string> names;
  unsigned jobs{0};
  int seeds{20};
  std::string out;
  bool json{false};
  std::vector<std::string> overrides;
  std::string only;
  std::string record;
  std::string shard;
};

/// "path=value" for each, as `--set` takes them.
std::vector<std::string> written(const Overrides& overrides) {
  std::vector<std::string> texts;
  for (const auto& [path, value] : overrides) texts.push_back(path + "=" + value);
  return texts;
}

std::vector<const Study*> found_studies(const std::vector<std::string>& names) {
  std::vector<const Study*> studies;
  for (const std::string& name : names) {
    const Study& study = find_study(name);
    if (std::ranges::find(studies, &study) != studies.end()) throw InputError(name + " is given twice");
    studies.push_back(&study);
  }
  return studies;
}

/// A study runs methods of its own under their names.
void refuse_methods(const Overrides& overrides) {
  for (const auto& [path, value] : overrides)
    if (names_avoider(path))
      throw InputError("--set " + path + ": the study sets it; expected a path of something else");
}

/// The rows, and what they were made under.
nlohmann::json document_of(const Study& study, const StudyResult& result, const Overrides& overrides) {
  nlohmann::json document = rows_json(study.name, result.rows);
  if (!overrides.empty()) document["set"] = written(overrides);
  return document;
}

/// The page, with what it was made under among its facts.
nlohmann::json page_under(const Overrides& overrides, nlohmann::json page) {
  for (const std::string& text : written(overrides))
    page["facts"].push_back({{"label", "Under"}, {"value", text}});
  return page;
}

constexpr FileKind rows_file{.name = "the rows of a study", .begins = "{", .holds = "\"rows\": ["};

/// What is written into the folder of a study that is run whole.
std::vector<Output> files_in(const std::filesystem::path& directory) {
  const auto file = [&](const char* name, const FileKind& kind) {
    return Output{"--out", (directory / name).string(), kind};
  };
  return {file("results.sqlite", store_file), file("results.csv", store_table), file("rows.json", rows_file),
          file("report.html", report_file)};
}

std::filesystem::path prepared(const std::string& out, const std::string& name, const char* part) {
  std::filesystem::path directory = std::filesystem::path(out) / name / part;
  make_folder(directory.string(), "--out");
  return directory;
}

/// Leaves results.csv, rows.json and report.html beside the store.
void write_results(const std::filesystem::path& directory, const Study& study, const StudyResult& result,
                   const Overrides& overrides, const Store& store) {
  OutputFile csv{(directory / "results.csv").string()};
  store.export_csv(csv.stream());
  csv.commit();
  write_file((directory / "rows.json").string(), document_of(study, result, overrides).dump(1) + "\n");
  write_page(page_under(overrides, result.page).dump(), (directory / "report.html").string());
}

/// Makes the playbacks of the runs that figures show, unless they are there.
void keep_playback(const std::filesystem::path& directory, const ShownRun& run, const Catalog& avoiders) {
  const std::filesystem::path page = directory / playback_path(run.spec);
  if (std::filesystem::exists(page)) return;
  try {
    make_shown(run, {.recording = {}, .playback = page}, avoiders);
  } catch (const RunAbandoned&) {
    // the study notices by itself that it is to stop
  }
}

/// `study --only`: one run, its measures, and what is to be kept of it.
int show_only(const Study& study, const StudyFlags& flags, const Outputs& outputs, const Program& program) {
  const std::filesystem::path directory =
      flags.out.empty() ? "" : prepared(flags.out, std::string(study.name), "runs").parent_path();
  const auto show = [&](const ShownRun& run) {
    const KeptRun kept{.recording = flags.record,
                       .playback = flags.out.empty() ? "" : directory / playback_path(run.spec)};
    outputs.judge({}, {{"--out", kept.playback.string(), playback_file}});
    print_shown(run, make_shown(run, kept, program.catalogs.avoiders), flags.json);
    if (!kept.playback.empty() && !flags.json)
      std::cout << "playback: " << std::filesystem::absolute(kept.playback).string() << "\n";
  };
  try {
    study.run({.seeds = flags.seeds,
               .stop = program.stop,
               .overrides = overrides_of(flags.overrides),
               .only = flags.only,
               .show = show});
  } catch (const RunAbandoned&) {
    std::cerr << "fairway: interrupted\n";
    return interrupted;
  }
  return ok;
}

int run_study(const Study& study, const StudyFlags& flags, const Outputs& outputs, const Program& program) {
  const std::string name{study.name};
  std::optional<Store> store;
  std::filesystem::path directory;
  if (!flags.out.empty()) {
    directory = prepared(flags.out, name, "runs").parent_path();
    outputs.judge({}, files_in(directory));
    store.emplace(Store::open((directory / "results.sqlite").string(),
                              outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse));
  }
  const Overrides overrides = overrides_of(flags.overrides);
  Progress progress{name};
  StudyOptions options{.jobs = flags.jobs,
                       .seeds = flags.seeds,
                       .store = store ? &*store : nullptr,
                       .progress = &progress,
                       .stop = program.stop,
                       .command = program.typed,
                       .overrides = overrides};
  if (!flags.shard.empty()) options.shard = parse_shard(flags.shard);
  if (store) {
    options.show = [&](const ShownRun& run) { keep_playback(directory, run, program.catalogs.avoiders); };
    options.playback = [&](const RunSpec& spec) {
      const std::string path = playback_path(spec);
      return std::filesystem::exists(directory / path) ? path : std::string();
    };
  }
  const StudyResult result = study.run(options);
  if (!options.shard.is_all() && !*program.stop) {
    std::cout << study.name << ", shard " << flags.shard << ": " << store->size() << " runs stored in "
              << (directory / "results.sqlite").string() << "\n";
    return ok;
  }
  if (!result.complete) {
    std::cerr << "fairway: interrupted; "
              << (store ? "the same command goes on from here" : "nothing was kept (no --out)") << "\n";
    return interrupted;
  }
  if (store) write_results(directory, study, result, overrides, *store);
  if (flags.json) {
    std::cout << document_of(study, result, overrides).dump() << "\n";
  } else {
    std::cout << study.title << "\n";
    for (const std::string& text : written(overrides)) std::cout << "under " << text << "\n";
    std::cout << rows_text(result.rows);
    if (store)
      std::cout << "report: " << std::filesystem::absolute(directory / "report.html").string() << "\n";
  }
  return ok;
}

}  // namespace

void add_study(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("study", "Reproduce a published experiment: published against measured");
  verb->footer(
      "Example: fairway study cubes --seeds 20 --out results\n"
      "With --out, results are kept there as they come, and the same command continues after an "
      "interruption.\n"
      "One run alone, as the report names it: fairway study cubes --only cube20_8/orca3d/corrected/1 --out "
      "results");
  auto flags = std::make_shared<StudyFlags>();
  verb->add_option("names", flags->names, "as `fairway list studies` shows them")->required();
  verb->add_option("--jobs", flags->jobs, "threads; 0 = as many as the machine has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_option("--seeds", flags->seeds, "variations per cell beyond what was published; 0 = none")
      ->capture_default_str()
      ->transform(whole_number(0, 100000));
  verb->add_option("--out", flags->out, "write results, rows and the report into this folder")
      ->check(not_empty())
      ->type_name("FOLDER");
  verb->add_flag("--json", flags->json, "print the rows as JSON");
  verb->add_option("--set", flags->overrides, "path=value, put into every scenario of the study");
  CLI::Option* only =
      verb->add_option(
              "--only", flags->only,
              "make this run alone and print its measures: a name as reports show it, or its beginning")
          ->check(not_empty());
  verb->add_option("--shard", flags->shard, "make only part I of N of the runs, from 0, and nothing of them")
      ->check(not_empty())
      ->type_name("I/N")
      ->excludes(only);
  auto outputs = std::make_shared<Outputs>(*verb);
  outputs->add("--record", flags->record, recording_file, "record that run to this MCAP file")->needs(only);
  program.on(*verb, [=, &program] {
    const std::vector<const Study*> studies = found_studies(flags->names);
    refuse_methods(overrides_of(flags->overrides));
    if (flags->json && studies.size() > 1) throw InputError("--json is of one study");
    if (!flags->shard.empty()) parse_shard(flags->shard);  // refused before a folder is made
    if (!flags->shard.empty() && flags->out.empty())
      throw InputError("--shard needs --out, where its runs go");
    if (!flags->only.empty() && studies.size() > 1) throw InputError("--only is of one study");
    if (!flags->only.empty()) return show_only(*studies.front(), *flags, *outputs, program);
    for (const Study* study : studies) {
      if (const int code = run_study(*study, *flags, *outputs, program); code != ok) return code;
    }
    return ok;
  });
}

}  // namespace fairway::cli
