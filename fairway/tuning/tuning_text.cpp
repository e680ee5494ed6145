// SPDX-License-Identifier: Apache-2.0
#include "fairway/tuning/tuning_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "fairway/experiment/ground_digest.hpp"
#include "fairway/experiment/version.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway {
namespace {

using nlohmann::json;

struct NamedSet {
  const char* name;
  const Appraisal* found;
  const Appraisal* usual;
};

std::array<NamedSet, 3> sets_of(const TuningResult& result) {
  return {{{"train", &result.train, &result.usual_train},
           {"validation", &result.validation, &result.usual_validation},
           {"test", &result.test, &result.usual_test}}};
}

/// What all estimates have: a value and its interval.
struct Interval {
  double value, low, high;

  Interval(const MeanEstimate& e) : value{e.mean}, low{e.low}, high{e.high} {}
  Interval(const RateEstimate& e) : value{e.rate}, low{e.low}, high{e.high} {}
  Interval(const RateDifference& e) : value{e.difference}, low{e.low}, high{e.high} {}
};

json interval_json(const Interval& e) { return {{"mean", e.value}, {"low", e.low}, {"high", e.high}}; }

std::string percent(const Interval& e) {
  return fmt::format("{:+.1f} % [{:+.1f}, {:+.1f}]", 100.0 * e.value, 100.0 * e.low, 100.0 * e.high);
}

json appraisal_json(const Appraisal& a) {
  json safer = interval_json(a.safer);
  safer["p"] = a.safer_p;
  return {{"runs", a.runs},
          {"collision_free_ratio", interval_json(a.collision_free)},
          {"arrived_ratio", interval_json(a.arrived)},
          {"navigation_time_s", interval_json(a.time_s)},
          {"safer_ratio", std::move(safer)},
          {"arrived_difference_ratio", interval_json(a.arrived_difference)},
          {"time_difference_ratio", interval_json(a.time_difference)}};
}

json score_json(const Score& score) {
  return {{"runs", score.runs},
          {"unsafe", score.unsafe},
          {"arrived_ratio", score.arrived},
          {"time_ratio", score.time_ratio}};
}

json setting_json(const TuningFile& tuning, const Setting& setting) {
  json object = json::object();
  for (std::size_t i = 0; i < setting.size(); ++i) {
    const TunedParameter& parameter = tuning.parameters[i];
    if (parameter.kind == TunedParameter::Kind::choice) {
      object[parameter.name] = value_text(parameter, setting[i]);
    } else {
      object[parameter.name] = setting[i];
    }
  }
  return object;
}

std::string row(const std::string& name, const Appraisal& a) {
  return fmt::format("  {:<24} {:>5}   {:.3f} [{:.3f}, {:.3f}]   {:.3f}   {:.4g} [{:.4g}, {:.4g}] s\n", name,
                     a.runs, a.collision_free.rate, a.collision_free.low, a.collision_free.high,
                     a.arrived.mean, a.time_s.mean, a.time_s.low, a.time_s.high);
}

/// What is shown of the result on the runs that the search never saw, in a sentence without its full stop.
std::string shown_text(const Appraisal& test) {
  switch (shown_by(test)) {
    case Shown::safer:
      return "it is shown to be safer than the method as written";
    case Shown::less_safe:
      return "it is shown to be less safe than the method as written";
    case Shown::more_arrive:
      return "more are shown to arrive than by the method as written";
    case Shown::fewer_arrive:
      return "fewer are shown to arrive than by the method as written";
    case Shown::quicker:
      return "it is shown to be quicker than the method as written";
    case Shown::slower:
      return "it is shown to be slower than the method as written";
    case Shown::nothing:
      break;
  }
  return "no gain over the method as written is shown";
}

std::string setting_text(const TuningFile& tuning, const Setting& setting) {
  std::string text;
  for (std::size_t i = 0; i < setting.size(); ++i)
    text += fmt::format(
        "  {:<32} {}{}\n", tuning.parameters[i].name, value_text(tuning.parameters[i], setting[i]),
        setting[i] == tuning.parameters[i].usual
            ? ""
            : fmt::format("   (it has {})", value_text(tuning.parameters[i], tuning.parameters[i].usual)));
  return text;
}

/// By which a copy of a scenario is known under another name; empty where the file is gone meanwhile.
std::string digest_of(const CampaignScenarioFile& scenario) {
  const std::string file =
      (std::filesystem::path(scenario.where.file).parent_path() / scenario.path).string();
  const std::optional<std::string> text = yaml::document_in(file);
  return text ? ground_digest(*text, file) : "";
}

}  // namespace

std::string tuning_text(const TuningFile& tuning, const TuningResult& result) {
  std::string text = fmt::format("{}: {} settings of {} in {} generations, {} runs\n", tuning.name,
                                 result.tried, tuning.method.label, result.generations, result.runs);
  if (result.is_usual) {
    text += "  nothing was better on the runs to train on than the method as it is written\n";
  } else {
    text += setting_text(tuning, result.best);
  }
  text +=
      fmt::format("  {:<24} {:>5}   collision-free [95 %]     arrived   mean time under way\n", "", "runs");
  for (const NamedSet& set : sets_of(result)) {
    text += row(std::string{set.name} + ", as written", *set.usual);
    if (!result.is_usual) text += row(std::string{set.name} + ", tuned", *set.found);
  }
  if (result.is_usual) return text;
  for (const NamedSet& set : sets_of(result))
    text += fmt::format("  {}: time {}, run by run; collision-free {}, p {:.2g}\n", set.name,
                        percent(set.found->time_difference), percent(set.found->safer), set.found->safer_p);
  text +=
      fmt::format("  of what was gained on train, luck (lost again on test): time {}; collision-free {}\n",
                  percent(result.luck), percent(result.safety_luck));
  text += "  on test " + shown_text(result.test) + "\n";
  for (const Ablation& ablation : result.ablations)
    text +=
        fmt::format("  without {}: time {} on validation, collision-free {:+.1f} %\n", ablation.parameter,
                    percent(ablation.appraisal.time_difference), 100.0 * ablation.appraisal.safer.difference);
  return text;
}

json to_json(const TuningFile& tuning, const TuningResult& result) {
  json document{{"fairway_tuning_result", 1},
                {"name", tuning.name},
                {"method", tuning.method.avoider},
                {"results_epoch", results_epoch},
                {"best", setting_json(tuning, result.best)},
                {"better_than_default", !result.is_usual},
                {"budget", result.budget},
                {"runs", result.runs},
                {"generations", result.generations},
                {"tried", result.tried},
                {"luck_ratio", interval_json(result.luck)},
                {"safety_luck_ratio", interval_json(result.safety_luck)},
                {"default", {{"parameters", setting_json(tuning, usual_setting(tuning.parameters))}}},
                {"curve", json::array()},
                {"front", json::array()},
                {"ablations", json::array()}};
  for (const auto& [path, value] : tuning.train.set) document["set"][path] = value;
  for (const auto& [name, set] :
       {std::pair{"train", &tuning.train}, std::pair{"validation", &tuning.validation}}) {
    json& seen = document["seen"][name];
    seen = {{"first_seed", set->first_seed}, {"seed_count", set->seed_count}};
    for (const CampaignScenarioFile& scenario : set->scenarios) {
      seen["scenarios"].push_back(std::filesystem::path(scenario.path).stem().string());
      seen["digests"].push_back(digest_of(scenario));
    }
  }
  for (const NamedSet& set : sets_of(result)) {
    document[set.name] = appraisal_json(*set.found);
    document["default"][set.name] = appraisal_json(*set.usual);
  }
  for (const TuningStep& step : result.curve) {
    json point = score_json(step.score);
    point["spent"] = step.runs;
    document["curve"].push_back(std::move(point));
  }
  for (const auto& [setting, score] : result.front)
    document["front"].push_back(
        {{"parameters", setting_json(tuning, setting)}, {"train", score_json(score)}});
  for (const Ablation& ablation : result.ablations)
    document["ablations"].push_back(
        {{"parameter", ablation.parameter}, {"validation", appraisal_json(ablation.appraisal)}});
  return document;
}

void refuse_smaller_budget(const json& document, const std::string& file, std::size_t budget) {
  const bool notes_it = document.contains("budget");  // else what it spent is known
  const json& noted = document.value(notes_it ? "budget" : "runs", json{});
  if (!noted.is_number_unsigned() || noted.get<std::size_t>() <= budget) return;
  throw InputError(fmt::format(
      "{}: was made with a budget of {}{} runs, and --budget {} is smaller; expected at least {} to "
      "go on from there, another --out, or --force to replace it",
      file, notes_it ? "" : "at least ", noted.get<std::size_t>(), budget, noted.get<std::size_t>()));
}

std::string tuned_avoider(const TuningFile& tuning, const TuningResult& result, const std::string& command) {
  const Appraisal& test = result.test;
  std::string typed = command;
  std::ranges::replace(typed, '\n', ' ');
  std::string text = fmt::format(
      "# Tuned by fairway {}, results epoch {}: {}\n# {}\n# On {} runs that the search never saw: "
      "collision-free "
      "{:.4g} [{:.4g}, {:.4g}], time {} of the method as written;\n# {}.\n",
      FAIRWAY_VERSION, results_epoch, tuning.name, typed, test.runs, test.collision_free.rate,
      test.collision_free.low, test.collision_free.high, percent(test.time_difference), shown_text(test));
  const std::string avoider = result.is_usual
                                  ? tuning.method.avoider
                                  : avoider_text(tuning.method.avoider, tuning.parameters, result.best);
  if (!avoider.starts_with('{')) return text + "algorithm: " + avoider + "\n";
  return text + avoider + "\n";
}

}  // namespace fairway
