// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/avoider_setup.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <type_traits>

#include "fairway/core/envelope_numbers.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/names.hpp"
#include "fairway/core/record.hpp"
#include "fairway/core/text.hpp"
#include "fairway/scenario/algorithm_file.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/agent.hpp"

namespace fairway::bridge {
namespace {

constexpr std::string_view envelope_prefix = "envelope.";
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// What settings change.
struct Draft {
  Scenario scenario;
  std::size_t own{};  ///< of the scenario's vehicles
  double period{};    ///< between decisions [s]
  HelmSetup helm;
  Settings envelope{};  ///< numbers of what the vehicle can do, if they are given
  Catalogs catalogs{builtin_catalogs()};

  VehicleSpec& vehicle() { return scenario.vehicles[own]; }
};

struct Setting {
  std::string name;
  std::function<void(Draft&, const std::string& text)> set;
};

double number_of(std::string_view name, const std::string& text, double lo, double hi) {
  const ParamValue value = parse_value(text);
  const double* given = std::get_if<double>(&value);
  if (given == nullptr || !(*given >= lo && *given <= hi)) {
    throw InputError(
        {}, std::string(name),
        "is \"" + text + "\"; expected a number in [" + number_text(lo) + ", " + number_text(hi) + "]");
  }
  return *given;
}

std::int32_t whole_of(std::string_view name, const std::string& text, double lo) {
  const double value = number_of(name, text, lo, 2147483647.0);
  if (value != std::floor(value)) {
    throw InputError({}, std::string(name), "is \"" + text + "\"; expected a whole number");
  }
  return static_cast<std::int32_t>(value);
}

template <class Target>
Setting number(const std::string& name, double lo, double hi, Target target, double factor = 1.0) {
  return {name, [=](Draft& draft, const std::string& text) {
            target(draft) = factor * number_of(name, text, lo, hi);
          }};
}

bool flag_of(std::string_view name, const std::string& text) {
  if (text != "true" && text != "false")
    throw InputError({}, std::string(name), "is \"" + text + "\"; expected true or false");
  return text == "true";
}

template <class Target>
Setting flag(const std::string& name, Target target) {
  return {name, [=](Draft& draft, const std::string& text) { target(draft) = flag_of(name, text); }};
}

/// Parameters that the algorithm in the scenario had and the one in its place has too are kept, unless that
/// comes of a file with its own.
void choose_algorithm(Draft& draft, const std::string& name) {
  Choice& avoider = draft.vehicle().avoider.edit();
  if (is_algorithm_file(name)) {
    avoider = load_algorithm(name);
    return;
  }
  const std::vector<ParamInfo> known = draft.catalogs.avoiders.params(name);
  std::erase_if(avoider.params, [&](const auto& param) {
    return std::ranges::none_of(
        known, [&](const ParamInfo& info) { return info.name == list_of_param(param.first); });
  });
  avoider.param_where.clear();
  avoider.name = name;
}

/// The limits are those of their record.
std::vector<Setting> made_settings() {
  std::vector<Setting> all{
      {"algorithm", choose_algorithm},
      {"model",
       [](Draft& d, const std::string& text) { d.vehicle().model = Choice{.name = text, .path = "model"}; }},
      {"steering",
       [](Draft& d, const std::string& text) {
         d.vehicle().steering = Choice{.name = text, .path = "steering"};
       }},
      {"priority",
       [](Draft& d, const std::string& t) { d.vehicle().priority = whole_of("priority", t, -2147483648.0); }},
      {"id", [](Draft& d,
                const std::string& t) { d.vehicle().id = static_cast<std::uint32_t>(whole_of("id", t, 0)); }},
      number("radius_m", 0.0, 1e4, [](Draft& d) -> double& { return d.vehicle().radius_m; }),
      number("period_s", 1e-3, 60.0, [](Draft& d) -> double& { return d.period; }),
      number("record_period_s", 1e-3, 60.0, [](Draft& d) -> double& { return d.helm.record_period; }),
      number("arrival_m", 1e-3, 1e4, [](Draft& d) -> double& { return d.helm.arrival; }),
      number("range_m", 0.0, unlimited, [](Draft& d) -> double& { return d.helm.range; }),
      number(
          "max_turn_rate_degps", 0.0, 1e5,
          [](Draft& d) -> double& { return d.vehicle().limits.max_turn_rate; }, radians(1.0)),
  };
  for_each_member<Limits>([&](const auto& m) {
    const auto target = [at = m.at](Draft& d) -> auto& { return d.vehicle().limits.*at; };
    if constexpr (std::is_same_v<decltype(m.at), bool Limits::*>) {
      all.push_back(flag(m.name_with_unit(), target));
    } else {
      all.push_back(number(m.name_with_unit(), math::fmax(m.least, -1e5), 1e5, target));
    }
  });
  return all;
}

const std::vector<Setting>& settings() {
  static const std::vector<Setting> all = made_settings();
  return all;
}

void put(ParamValues& params, const std::string& name, const std::string& text) {
  params = merged(std::move(params), {{name, parse_value(text)}});
}

void set_policy(OnboardPolicy& policy, const std::string& name, const std::string& text) {
  try {
    set_param(policy, name, parse_value(text));
  } catch (const InputError& error) {
    throw InputError("policy." + std::string(error.what()));
  }
}

TeamMate& mate_of(Draft& draft, const std::string& setting, std::string_view name) {
  std::vector<std::string_view> known;
  for (TeamMate& mate : draft.helm.team) {
    if (mate.name == name) return mate;
    known.push_back(mate.name);
  }
  throw InputError({}, setting,
                   "nobody of the team is called " + std::string(name) + suggestion(name, known));
}

/// `team.NAME.radius_m` and so on.
void set_mate(Draft& draft, const std::string& setting, const std::string& text) {
  const std::size_t dot = setting.rfind('.');
  const std::size_t begin = std::string_view("team.").size();
  const std::string what = setting.substr(dot + 1);
  TeamMate& mate = mate_of(draft, setting, dot > begin ? setting.substr(begin, dot - begin) : "");
  if (what == "radius_m") {
    mate.radius = number_of(setting, text, 0.0, 1e4);
  } else if (what == "arrival_m") {
    mate.arrival = number_of(setting, text, 0.0, 1e4);
  } else if (what == "priority") {
    mate.priority = whole_of(setting, text, -2147483648.0);
  } else if (what == "id") {
    mate.id = VehicleId{static_cast<std::uint32_t>(whole_of(setting, text, 0))};
  } else if (what == "reacts") {
    mate.reacts = flag_of(setting, text);
  } else {
    throw InputError(
        {}, setting,
        "unknown setting" + suggestion(what, {"radius_m", "arrival_m", "priority", "id", "reacts"}));
  }
}

[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<std::string>& also_known) {
  const std::string_view policy = nearest_name(name, param_names<OnboardPolicy>());
  std::vector<std::string_view> known = setting_names();
  known.insert(known.end(), also_known.begin(), also_known.end());
  const bool means_policy = nearest_name(name, known).empty() && !policy.empty();
  throw InputError({}, name,
                   "unknown setting" + (means_policy ? "; did you mean policy." + std::string(policy) + "?"
                                                     : suggestion(name, known)));
}

void apply(Draft& draft, const std::string& name, const std::string& text,
           const std::vector<std::string>& also_known) {
  const auto tail_of = [&](std::string_view head) { return name.substr(head.size()); };
  if (name.starts_with("params."))
    return put(draft.vehicle().avoider.edit().params, tail_of("params."), text);
  if (name.starts_with("model.")) return put(draft.vehicle().model.edit().params, tail_of("model."), text);
  if (name.starts_with("steering."))
    return put(draft.vehicle().steering.edit().params, tail_of("steering."), text);
  if (name.starts_with("policy.")) return set_policy(draft.helm.policy, tail_of("policy."), text);
  if (name.starts_with(envelope_prefix)) {
    draft.envelope.emplace_back(tail_of(envelope_prefix), text);
    return;
  }
  if (name.starts_with("team.")) return set_mate(draft, name, text);
  const auto found = std::ranges::find(settings(), name, &Setting::name);
  if (found == settings().end()) refuse_unknown(name, also_known);
  found->set(draft, text);
}

/// In which order settings are carried out: their parameters are for what was chosen, and others are as this
/// vehicle is unless it is said what they are.
enum class Stage { choices, own, team };

Stage stage_of(const std::string& name) {
  if (name == "algorithm" || name == "model" || name == "steering") return Stage::choices;
  return name.starts_with("team.") ? Stage::team : Stage::own;
}

void apply_stage(Draft& draft, const AvoiderOptions& options, Stage stage) {
  for (const auto& [name, text] : options.settings) {
    if (name != "team" && stage_of(name) == stage) apply(draft, name, text, options.also_known);
  }
}

/// The envelope that is given, if it is. What it says that the vehicle cannot do limits it.
std::optional<Envelope> take_envelope(Draft& draft) {
  if (draft.envelope.empty()) return {};
  const Envelope envelope = envelope_of_numbers(draft.envelope, envelope_prefix);
  Limits& limits = draft.vehicle().limits;
  limits.min_speed = math::fmax(limits.min_speed, envelope.least);
  limits.sternway = limits.sternway && envelope.astern > 0.0;
  limits.sway = limits.sway && envelope.sideways > 0.0;
  return envelope;
}

void check(Draft& draft) {
  const VehicleSpec& own = draft.vehicle();
  if (own.limits.min_depth > own.limits.max_depth) {
    throw InputError({}, "min_depth_m",
                     "is " + number_text(own.limits.min_depth) + ", below max_depth_m, " +
                         number_text(own.limits.max_depth) + "; expected the ceiling above the floor");
  }
  std::vector<std::uint32_t> ids{own.id};
  for (const TeamMate& mate : draft.helm.team) {
    const std::uint32_t id = number(mate.id);
    const auto same =
        std::ranges::find(ids, id % record_ids, [](std::uint32_t other) { return other % record_ids; });
    if (same != ids.end()) {
      const std::string which = std::to_string(id);
      throw InputError({}, "id",
                       *same == id ? which + " is that of two vehicles, one of them " + mate.name
                                   : which + ", of " + mate.name + ", and " + std::to_string(*same) +
                                         " are the same in a team record, which tells them modulo " +
                                         std::to_string(record_ids));
    }
    ids.push_back(id);
  }
}

std::vector<std::string> words_of(std::string text) {
  if (text.find_first_of("[]'\"") != std::string::npos)
    throw InputError({}, "team", "is " + text + "; expected names with blanks or commas between them");
  std::ranges::replace(text, ',', ' ');
  std::istringstream words{text};
  return {std::istream_iterator<std::string>{words}, {}};
}

/// A vehicle that nothing is known of but its name, among others of which no more is known. Everyone who is
/// told the same names numbers them alike, in their order as text.
Scenario scenario_of_names(const std::string& own, std::vector<std::string> names) {
  names.push_back(own);
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  Scenario scenario;
  for (std::size_t i = 0; i < names.size(); ++i) {
    scenario.vehicles.push_back({.id = static_cast<std::uint32_t>(i),
                                 .name = names[i],
                                 .model = Choice{.name = "kinematic", .path = "model"},
                                 .avoider = Choice{.name = "orca3d", .path = "algorithm"},
                                 .priority = static_cast<std::int32_t>(i)});
  }
  return scenario;
}

std::size_t index_of(const Scenario& scenario, const std::string& vehicle, const std::string& file) {
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    if (scenario.vehicles[i].name == vehicle) return i;
    known.push_back(scenario.vehicles[i].name);
  }
  throw InputError({}, "vehicle", "\"" + vehicle + "\" is not in " + file + suggestion(vehicle, known));
}

/// The only transit's, for what is known of others is one goal; 0 if there is another number of them.
double arrival_of(const VehicleSpec& spec) {
  const auto is_transit = [](const Leg& leg) { return leg.kind == LegKind::transit; };
  if (std::ranges::count_if(spec.mission, is_transit) != 1) return 0.0;
  return std::ranges::find_if(spec.mission, is_transit)->arrival_m;
}

TeamMate mate_of(const VehicleSpec& spec) {
  return {.id = VehicleId{spec.id},
          .name = spec.name,
          .radius = spec.radius_m,
          .priority = spec.cooperative ? spec.priority : first_priority,
          .reacts = spec.cooperative,
          .arrival = arrival_of(spec)};
}

Draft draft_of(const AvoiderOptions& options, const std::optional<std::vector<std::string>>& team) {
  if (options.vehicle.empty()) throw InputError({}, "vehicle", "is empty; expected the name of a vehicle");
  const bool has_file = !options.scenario.empty();
  Draft draft{.scenario = has_file
                              ? load_scenario(options.scenario, {}, options.seed)
                              : scenario_of_names(options.vehicle, team.value_or(std::vector<std::string>{})),
              .helm = {}};
  if (!has_file) draft.scenario.seed = options.seed.value_or(1);
  draft.own = index_of(draft.scenario, options.vehicle, has_file ? options.scenario : "the team");

  const Scenario& scenario = draft.scenario;
  HelmSetup& helm = draft.helm;
  draft.period = scenario.steps_per_decision * scenario.step_s;
  helm.wall_clock = options.wall_clock;
  helm.record_period = scenario.step_s;
  helm.range = scenario.perception.range_m;
  for (const Leg& leg : draft.vehicle().mission) {
    if (leg.kind == LegKind::transit) helm.arrival = leg.arrival_m;
  }
  for (const VehicleSpec& spec : scenario.vehicles) {
    const bool is_mate = !team || std::ranges::find(*team, spec.name) != team->end();
    if (is_mate && spec.name != options.vehicle) helm.team.push_back(mate_of(spec));
  }
  if (has_file && team) {
    for (const std::string& name : *team) {
      if (name != options.vehicle) index_of(scenario, name, options.scenario);
    }
  }
  return draft;
}

}  // namespace

std::vector<std::string_view> setting_names() {
  std::vector<std::string_view> names{"team"};
  for (const Setting& setting : settings()) names.push_back(setting.name);
  return names;
}

AvoiderSetup avoider_setup(const AvoiderOptions& options) {
  std::optional<std::vector<std::string>> team;
  for (const auto& [name, text] : options.settings) {
    if (name == "team") team = words_of(text);
  }
  Draft draft = draft_of(options, team);
  apply_stage(draft, options, Stage::choices);
  apply_stage(draft, options, Stage::own);
  const std::optional<Envelope> envelope = take_envelope(draft);
  if (envelope && options.scenario.empty()) draft.vehicle().tracking = Tracking::automatic;
  if (options.scenario.empty()) {
    for (TeamMate& mate : draft.helm.team) mate.radius = draft.vehicle().radius_m;
  }
  apply_stage(draft, options, Stage::team);
  check(draft);

  const VehicleSpec& own = draft.vehicle();
  const Catalog& avoiders = draft.catalogs.avoiders;
  Particulars ship =
      particulars_of(own, make_vehicle(own, draft.catalogs.vehicles), draft.scenario, avoiders);
  if (envelope) ship.envelope = envelope;
  const Limits limits = ship.limits;
  AvoiderSetup setup{.algorithm = avoider_in_force(own, limits, draft.scenario.obstacles, avoiders),
                     .pilot = {std::move(ship), draft.period},
                     .helm = std::move(draft.helm),
                     .avoider = make_avoider(own, limits, draft.scenario, avoiders)};
  setup.obstacles = std::move(draft.scenario.obstacles);
  for (const ObstacleSpec& obstacle : setup.obstacles) {
    if (obstacle.charted && !obstacle.moves()) setup.helm.chart.push_back(obstacle.view());
  }
  return setup;
}

}  // namespace fairway::bridge
