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
#include "fairway/cli/exam_question.hpp"
#include "fairway/cli/listing.hpp"
#include "fairway/cli/numbers.hpp"
#include "fairway/cli/outputs.hpp"
#include "fairway/cli/own_methods.hpp"
#include "fairway/cli/paths.hpp"
#include "fairway/cli/program.hpp"
#include "fairway/cli/word_list.hpp"
#include "fairway/core/csv_field.hpp"
#include "fairway/exam/against.hpp"
#include "fairway/exam/entrance.hpp"
#include "fairway/exam/exam_page.hpp"
#include "fairway/exam/exam_text.hpp"
#include "fairway/exam/labels.hpp"
#include "fairway/exam/reference.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/report/page.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway::cli {
namespace {

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
    text += fmt::format("{},{},{},{},{:.4g},{:.4g}\n", csv_field(each.family), csv_field(each.method),
                        each.tuned, each.decisions, each.mean_us, each.worst_us);
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
               const std::map<std::string, std::string>& avoiders, const std::vector<DecisionTime>& times,
               const Program& program) {
  const ExamFiles files = exam_files_in(flags.out);
  const ExamTable table = exam_table(runs, order_of(exam, question, runs));
  const std::optional<ExamPlaybacks> playbacks =
      exam_playbacks(table, plan, flags.out, flags.playbacks, flags.jobs, program);
  if (!playbacks) return told_interrupted();
  ExamReference reference{
      .epoch = results_epoch, .maker = maker, .grounds = {}, .avoiders = avoiders, .runs = runs};
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
  store.refuse_other_epoch();
  Origin origin{.campaign = exam.name, .summary = exam.summary};
  for (const CampaignCell& cell : plan.campaign.cells) add_values(origin.order, cell.labels);
  store.note(origin);
  store.claim(plan.campaign.specs);
  if (!plan.campaign.specs.empty()) store.note(this_maker(false));
  return store;
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
  const std::optional<ExamReference> reference = reference_for(flags, exam, question);
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
  std::map<std::string, std::string> avoiders = avoiders_of(question);
  if (reference) avoiders.insert(reference->avoiders.begin(), reference->avoiders.end());
  return write_exam(flags, exam, question, plan, runs, maker, avoiders, clock.all(), program);
}

}  // namespace

void add_exam(CLI::App& app, Program& program) {
  CLI::App* verb =
      app.add_subcommand("exam", "Every method on every ground under the same seeds, in one table");
  verb->footer("Example: fairway exam --methods orca3d,apf --families cubes,spheres --seeds 20 --out exam");
  auto flags = std::make_shared<ExamFlags>();
  auto outputs = std::make_shared<Outputs>(*verb);
  add_word_list(*verb, "--methods", flags->methods,
                "names, or files such as mine.yaml; default: those of the exam");
  add_word_list(*verb, "--families", flags->families, "of the exam's; default: all");
  add_word_list(*verb, "--conditions", flags->conditions, "of the exam's; default: all");
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
