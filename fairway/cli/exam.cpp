// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "fairway/cli/decision_clock.hpp"
#include "fairway/cli/exam_playbacks.hpp"
#include "fairway/cli/listing.hpp"
#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/exam/against.hpp"
#include "fairway/exam/entrance.hpp"
#include "fairway/exam/exam_page.hpp"
#include "fairway/exam/exam_text.hpp"
#include "fairway/exam/reference.hpp"
#include "fairway/exam/tuned.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/report/page.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

struct ExamFlags {
  std::string grounds = shipped("campaigns/exam/exam.yaml");
  std::vector<std::string> methods;
  std::vector<std::string> families;
  std::vector<std::string> conditions;
  std::optional<std::size_t> seeds;
  std::string against;
  std::string tuned;
  std::string out;
  unsigned jobs{0};
  bool add{false};
  bool as_it_is{false};
  bool playbacks{false};
  bool json{false};
};

/// What an exam leaves in its folder.
struct ExamFiles {
  std::string store, rows, document, latex, page, reference, decisions;
};

ExamFiles exam_files_in(const std::string& folder) {
  const std::filesystem::path out{folder};
  const auto file = [&](const char* name) { return (out / name).string(); };
  return {file("runs.sqlite"), file("exam.csv"),          file("exam.json"),         file("exam.tex"),
          file("exam.html"),   file("reference.csv.zst"), file("decision_times.csv")};
}

std::string decisions_csv(const std::vector<DecisionTime>& times) {
  std::string text{decision_times_file.holds};
  for (const DecisionTime& each : times)
    text += fmt::format("{},{},{},{},{:.4g},{:.4g}\n", each.family, each.method, each.tuned, each.decisions,
                        each.mean_us, each.worst_us);
  return text;
}

/// Makes a run of the exam, measures it and reads the clock at its decisions.
std::vector<Measure> examined(const Scenario& scenario, const Labels& labels, const Program& program,
                              DecisionClock& clock) {
  RunMetrics metrics = metrics_for(scenario, program.catalogs.vehicles);
  Simulation simulation{scenario, program.catalogs};
  simulation.time_decisions();
  std::vector<FrameSink*> sinks{&metrics};
  while (!simulation.is_done()) {
    if (program.stop->load(std::memory_order_relaxed)) throw RunAbandoned{};
    simulation.step(sinks);
  }
  simulation.refuse_divergence();
  clock.add(labels, simulation.decision_times());
  return measures_of(exam_outcome(metrics.measures(), scenario));
}

/// Stored results that newcomers are held against; none if there is no such flag. Unless families are named,
/// those that it has are left, and with --add all of them.
std::optional<ExamReference> reference_for(const ExamFlags& flags, const ExamFile& exam,
                                           std::vector<ExamFamily>& families) {
  if (flags.against.empty()) return {};
  ExamReference reference = parse_reference(read_maybe_compressed(flags.against), flags.against);
  if (flags.families.empty() && !flags.add)
    std::erase_if(families,
                  [&](const ExamFamily& family) { return !reference.grounds.contains(family.name); });
  for (const ExamFamily& family : families) {
    const auto known = reference.grounds.find(family.name);
    if (known == reference.grounds.end() && flags.add) continue;
    if (known == reference.grounds.end())
      throw InputError("--against " + flags.against + ": has no runs of the family " + family.name);
    if (known->second != digest_of(family, exam.conditions))
      throw InputError("--against " + flags.against + ": its runs of " + family.name +
                       " are of other scenarios than " + family.file + " has now");
  }
  return reference;
}

/// Says of stored runs how each is made, where this program knows their methods.
void add_commands(std::vector<ExamRun>& runs, const ExamFile& exam, ExamQuestion question,
                  const Program& program) {
  std::set<std::string> known;
  for (const ExamRun& run : runs)
    if (!run.tuned && run.method != exam.baseline.label) known.insert(run.method);
  question.candidates.clear();
  for (const std::string& method : known) {
    try {
      question.candidates.push_back(candidate_of(method, exam, program.catalogs.avoiders, ""));
    } catch (const InputError&) {  // somebody else's: its runs are shown without
    }
  }
  std::size_t most = 1;
  for (const ExamFamily& family : question.families) most = std::max(most, family.grounds.size());
  question.seeds = most;
  question.by_name = false;
  const ExamPlan plan = plan_exam(exam, question, program.catalogs.avoiders, {}, 1, own_methods(program));
  using Key = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<Key, std::string> commands;
  for (const RunSpec& spec : plan.campaign.specs) {
    const auto label = [&](const char* name) { return *find_label(spec.labels, name); };
    commands[{label("family"), label("condition"), label("method"), label("case")}] = spec.command;
  }
  for (ExamRun& run : runs)
    if (const auto found = commands.find({run.family, run.condition, run.method, run.ground});
        !run.tuned && found != commands.end())
      run.command = found->second;
}

ExamQuestion question_of(const ExamFlags& flags, const ExamFile& exam, const Catalog& methods) {
  ExamQuestion question{.families = chosen_by_name(exam.families, flags.families, "--families"),
                        .conditions = chosen_by_name(exam.conditions, flags.conditions, "--conditions"),
                        .candidates = {},
                        .by_name = !flags.methods.empty()};
  expect_known(exam.baseline, methods);
  for (const std::string& name : flags.methods) {
    question.candidates.push_back(candidate_of(name, exam, methods, "--methods"));
    if (name.ends_with(".yaml") && !is_search_told("--methods", name, question.families))
      std::cerr << "fairway: --methods " << name
                << ": was tuned, and no tuning.json beside it says on which seeds; they may be test seeds\n";
  }
  if (flags.methods.empty() && (flags.against.empty() || flags.add))
    for (const CampaignAlgorithm& method : exam.methods)
      question.candidates.push_back(candidate_of(method.label, exam, methods, "methods:"));
  if (!flags.tuned.empty())
    for (Candidate& candidate : tuned_candidates(flags.tuned, question.families, methods))
      question.candidates.push_back(std::move(candidate));
  return question;
}

std::vector<std::string> exam_inputs(const ExamFlags& flags, const ExamFile& exam) {
  std::vector<std::string> inputs{flags.grounds};
  for (const ExamFamily& family : exam.families) {
    inputs.push_back(family.file);
    for (const ExamGround& ground : family.grounds) inputs.push_back(ground.file);
  }
  for (const std::string& method : flags.methods)
    if (method.ends_with(".yaml")) inputs.push_back(method);
  if (!flags.against.empty()) inputs.push_back(flags.against);
  return inputs;
}

ExamOrder order_of(const ExamFile& exam, const ExamQuestion& question, const std::vector<ExamRun>& runs) {
  ExamOrder order{
      .families = {}, .conditions = {}, .methods = {exam.baseline.label}, .baseline = exam.baseline.label};
  for (const ExamFamily& family : question.families) order.families.push_back(family.name);
  for (const ExamCondition& condition : question.conditions) order.conditions.push_back(condition.name);
  const auto add = [&](const std::string& method) {
    if (std::ranges::find(order.methods, method) == order.methods.end()) order.methods.push_back(method);
  };
  for (const CampaignAlgorithm& method : exam.methods) add(method.label);
  std::set<std::string> others;  // newcomers, in an order that does not depend on who was run now
  for (const ExamRun& run : runs) others.insert(run.method);
  for (const std::string& other : others) add(other);
  return order;
}

/// Who made the runs of a store, in one line.
std::string makers_of(const Store& store) {
  std::string text;
  for (const std::string& kind : kinds_of(store.origin().makers)) text += (text.empty() ? "" : "; ") + kind;
  return text;
}

int told_interrupted() {
  std::cerr << "fairway: interrupted; the same command goes on from here\n";
  return interrupted;
}

int write_exam(const ExamFlags& flags, const ExamFile& exam, const ExamQuestion& question,
               const ExamPlan& plan, const std::vector<ExamRun>& runs, const std::string& maker,
               const std::vector<DecisionTime>& times, const Program& program) {
  const ExamFiles files = exam_files_in(flags.out);
  const ExamTable table = exam_table(runs, order_of(exam, question, runs));
  const std::optional<ExamPlaybacks> playbacks =
      exam_playbacks(table, plan, flags.out, flags.playbacks, flags.jobs, program);
  if (!playbacks) return told_interrupted();
  ExamReference reference{.epoch = results_epoch, .maker = maker, .grounds = {}, .runs = runs};
  for (const ExamFamily& family : question.families)
    if (std::ranges::find(runs, family.name, &ExamRun::family) != runs.end())
      reference.grounds[family.name] = digest_of(family, exam.conditions);
  std::ranges::stable_sort(reference.runs, {}, [](const ExamRun& run) {
    return std::tie(run.family, run.condition, run.method, run.tuned, run.seed);
  });
  const nlohmann::json document = to_json(table, plan.absences);
  write_file(files.rows, rows_csv(table));
  write_file(files.document, document.dump(1) + "\n");
  write_file(files.latex, latex_of(table));
  write_file(files.reference, compressed(reference_text(reference)));
  if (!times.empty()) write_file(files.decisions, decisions_csv(times));
  write_page(exam_page(table, {.families = question.families,
                               .conditions = question.conditions,
                               .absences = plan.absences,
                               .decision_times = times,
                               .playback = [&](const ExamRun& run) { return page_of(*playbacks, run); },
                               .margins = margins_in(exam, question, program.catalogs.avoiders),
                               .command = program.typed,
                               .origin = "Made by " + maker + "."})
                 .dump(),
             files.page);
  std::cout << (flags.json ? document.dump(2) + "\n"
                           : table_text(table, plan.absences) + "wrote " + files.page + "\n");
  return ok;
}

/// A table of runs lies there that this folder's exam cannot have made, since it has no runs.
bool is_of_other_runs(const ExamFiles& files) {
  std::error_code none;
  return std::filesystem::exists(files.reference, none) &&
         !std::filesystem::is_empty(files.reference, none) && !std::filesystem::exists(files.store, none);
}

/// The store in the exam's folder, which is made; refuses to write over what is of another kind, or is asked
/// of.
Store open_store(const ExamFlags& flags, const ExamFile& exam, const ExamPlan& plan, const Outputs& outputs) {
  const ExamFiles files = exam_files_in(flags.out);
  if (std::filesystem::exists(flags.out))
    outputs.judge(exam_inputs(flags, exam), {{"--out", files.store, store_file},
                                             {"--out", files.rows, exam_rows_file},
                                             {"--out", files.document, exam_document},
                                             {"--out", files.latex, exam_latex},
                                             {"--out", files.page, report_file},
                                             {"--out", files.reference, reference_file},
                                             {"--out", files.decisions, decision_times_file}});
  if (!outputs.force() && is_of_other_runs(files))
    throw InputError("--out " + files.reference + ": is there, and no " + files.store +
                     " with its runs; expected another folder, or --force to replace it");
  make_folder(flags.out, "--out");
  Store store = Store::open(files.store, outputs.force() ? Store::Foreign::replace : Store::Foreign::refuse);
  Origin origin{.campaign = exam.name, .summary = exam.summary};
  for (const CampaignCell& cell : plan.campaign.cells) add_values(origin.order, cell.labels);
  store.note(origin);
  store.claim(plan.campaign.specs);
  if (!plan.campaign.specs.empty()) store.note(this_maker(false));
  return store;
}

/// Says where a method that is named costs what the exam would have spared.
void tell_what_is_not_left_out(const ExamFile& exam, const ExamQuestion& question) {
  if (!question.by_name) return;
  for (const ExamOmission& omission : exam.omissions) {
    std::string families;
    for (const ExamFamily& family : question.families)
      if (std::ranges::find(omission.families, family.name) != omission.families.end())
        families += (families.empty() ? "" : ",") + family.name;
    const auto is_named = [&](const Candidate& candidate) {
      return !candidate.tuned && candidate.method.label == omission.method;
    };
    if (families.empty() || std::ranges::none_of(question.candidates, is_named)) continue;
    std::cerr << "fairway: " << omission.method << " is named, so that " << families << " is not left out ("
              << omission.why << "); --families takes others\n";
  }
}

ExamPlan listed_plan(const ExamFlags& flags, const ExamFile& exam, const ExamQuestion& question,
                     const Program& program) {
  Listing listing{exam.name, program.stop};
  const auto check = [&](const Scenario& scenario) { Simulation{scenario, program.catalogs}; };
  return plan_exam(exam, question, program.catalogs.avoiders, check, flags.jobs, own_methods(program),
                   std::ref(listing));
}

int hold_exam(const ExamFlags& flags, const Outputs& outputs, const Program& program) {
  const Catalogs& catalogs = program.catalogs;
  const ExamFile exam = load_exam(flags.grounds);
  ExamQuestion question = question_of(flags, exam, catalogs.avoiders);
  const std::optional<ExamReference> reference = reference_for(flags, exam, question.families);
  question.seeds = flags.seeds.value_or(20);
  if (reference && !flags.add) {
    const std::size_t stored = seeds_in(*reference, question.families);
    question.seeds = flags.seeds.value_or(stored);
    if (question.seeds > stored)
      throw InputError(
          fmt::format("--seeds {}: --against {} has {} seeds of each family; expected at most as "
                      "many, or --add to make the others",
                      question.seeds, flags.against, stored));
  }
  if (!flags.as_it_is) tell_what_is_not_left_out(exam, question);
  ExamPlan plan = listed_plan(flags, exam, question, program);
  if (reference && flags.add)
    keep_lacking(plan, *reference);
  else if (reference)
    keep_news(plan, *reference, exam.baseline.label);

  Store store = open_store(flags, exam, plan, outputs);
  DecisionClock clock;
  Progress progress{exam.name};
  if (flags.as_it_is) {
    keep_complete_cells(plan, store);
  } else if (run_missing(plan.campaign.specs,
                         [&](std::size_t i) {
                           return examined(plan.campaign.scenario_of(i), plan.campaign.specs[i].labels,
                                           program, clock);
                         },
                         store, {.jobs = flags.jobs, .progress = &progress, .stop = program.stop})
                 .stopped) {
    return told_interrupted();
  }
  std::vector<ExamRun> runs;
  for (const RunRecord& record : records_of(plan.campaign, store)) runs.push_back(exam_run_of(record));
  if (reference) {
    std::vector<ExamRun> beside = runs_beside(*reference, question, flags.add);
    add_commands(beside, exam, question, program);
    runs.insert(runs.end(), beside.begin(), beside.end());
  }
  std::string maker = makers_of(store);
  if (reference) maker += (maker.empty() ? "" : "; held against runs by ") + reference->maker;
  return write_exam(flags, exam, question, plan, runs, maker, clock.all(), program);
}

}  // namespace

void add_exam(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("exam", "Every method on every ground under the same seeds, in one table");
  verb->footer("Example: fairway exam --methods orca3d,apf --families cubes,spheres --seeds 20 --out exam");
  auto flags = std::make_shared<ExamFlags>();
  auto outputs = std::make_shared<Outputs>(*verb);
  verb->add_option("--methods", flags->methods,
                   "names, or files such as mine.yaml; default: those of the exam")
      ->check(not_empty())
      ->delimiter(',')
      ->type_name("NAMES");
  verb->add_option("--families", flags->families, "of the exam's; default: all")
      ->delimiter(',')
      ->type_name("NAMES");
  verb->add_option("--conditions", flags->conditions, "of the exam's; default: all")
      ->delimiter(',')
      ->type_name("NAMES");
  verb->add_option("--seeds", flags->seeds, "test seeds of each family; default 20, or as --against has")
      ->transform(whole_number<std::size_t>(1, 1'000'000));
  verb->add_option(
          "--against", flags->against,
          "stored results: \"stored\", those that come with fairway, or reference.csv.zst of another exam")
      ->check(not_empty())
      ->type_name("STORED");
  verb->add_flag("--add", flags->add, "make what --against lacks: families, conditions, methods and seeds")
      ->needs("--against");
  verb->add_option("--tuned", flags->tuned, "what tune found: best.yaml, or a folder of such")
      ->check(not_empty())
      ->type_name("PATH");
  CLI::Option* grounds = verb->add_option("--grounds", flags->grounds, "the exam: families and conditions");
  grounds->check(not_empty())->type_name("YAML")->capture_default_str();
  verb->add_option("--out", flags->out, "folder for runs, tables and page; goes on where it is there")
      ->check(not_empty())
      ->required()
      ->type_name("FOLDER");
  verb->add_option("--jobs", flags->jobs, "threads; 0 = as many as the machine has")
      ->transform(whole_number(0U, max_jobs))
      ->capture_default_str();
  verb->add_flag("--as-it-is", flags->as_it_is,
                 "make no run: the table is of the cells that are stored whole");
  verb->add_flag("--playbacks", flags->playbacks,
                 "leave a page that plays and explains the worst run of each method in each family, of the "
                 "runs that are not of --against");
  verb->add_flag("--json", flags->json, "print the results as JSON");
  program.on(*verb, [=, &program] {
    if (grounds->count() == 0) expect_shipped(flags->grounds, "--grounds");
    if (flags->against == "stored") flags->against = shipped("campaigns/exam/reference.csv.zst");
    return hold_exam(*flags, *outputs, program);
  });
}

}  // namespace fairway::cli
