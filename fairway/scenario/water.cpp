// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/scenario/angle.hpp"
#include "fairway/scenario/parts.hpp"

namespace fairway::yaml {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// The strongest tidal streams, as in Saltstraumen, run some 10 m/s.
constexpr double fastest_flow = 10.0;
constexpr Bounds flow_speeds = from_to(-fastest_flow, fastest_flow);
/// A wave on deep water whose height is more than a seventh of its length breaks (Michell 1893).
constexpr double steepest_wave = 1.0 / 7.0;
constexpr Bounds wave_periods = from_to(0.1, 1000.0);
constexpr Bounds depths = from_to(-12000.0, 12000.0);
constexpr Bounds full_turn = from_to(-360.0, 360.0);

template <class T>
Form<std::optional<T>> optional(const Form<T>& form) {
  return {.read = [form](const Value& value) { return std::optional{form.read(value)}; },
          .write = [form](const std::optional<T>& given) -> std::optional<Tree> {
            return given ? form.write(*given) : std::nullopt;
          },
          .schema = form.schema};
}

template <class T>
Form<std::vector<T>> list_up_to(std::size_t most, const Form<T>& item, const std::string& of) {
  Form<std::vector<T>> form = list_of(item, of);
  form.read = [most, of, read = form.read](const Value& value) {
    const std::size_t count = value.tree().items.size();
    if (value.tree().is_list() && count > most)
      value.refuse(fmt::format("{} {}; at most {} are accepted", count, of, most));
    return read(value);
  };
  form.schema.set("maxItems", Tree::word(std::to_string(most)));
  return form;
}

/// Where something runs to, as a vector of any length or as an angle.
template <class Owner>
Block<Owner> direction(double Owner::*member, const std::string& of) {
  constexpr Bounds any = from_to(-1e6, 1e6);
  const Tree schema = Tree::map({{"type", Tree::quote("array")},
                                 {"items", number_schema(any)},
                                 {"minItems", Tree::word("2")},
                                 {"maxItems", Tree::word("2")}});
  Key<Owner> vector{.name = "direction",
                    .meaning = "Where " + of + " to, as a vector [n, e] of any length.",
                    .read =
                        [member, any](const Value& value, Owner& owner) {
                          if (!value.tree().is_list() || value.tree().items.size() != 2)
                            value.expected("two numbers [n, e]");
                          const double north = value.entry(0).number(any), east = value.entry(1).number(any);
                          if (north == 0.0 && east == 0.0) value.refuse("[0, 0] points nowhere");
                          owner.*member = math::atan2(east, north);
                        },
                    .write = [](const Owner&) -> std::optional<Tree> { return {}; },
                    .schema = schema};
  return joined<Owner>({{std::move(vector)},
                        angle("direction", "_deg", "_rad", member, full_turn,
                              "Where " + of + " to, 0 north, 90 east. Default {}.")});
}

/// Throws if no wave on deep water is so high and so short: [m], [s].
void check_steepness(const Value& value, double height, double period) {
  const double length = 9.81 * period * period / (2.0 * pi);
  if (height <= steepest_wave * length) return;
  value.refuse(fmt::format(
      "a wave that is {} m high breaks where it is {:.3g} m long, as one of {} s is; at most {:.2g} m",
      number_text(height), length, number_text(period), steepest_wave * length));
}

Form<WaveSpec> wave() {
  Form<WaveSpec> form = block_form(
      joined<WaveSpec>({{key("amplitude_m", &WaveSpec::amplitude_m, number(above_to(0.0, 100.0)),
                             "Half its height.", Needed::yes),
                         key("period_s", &WaveSpec::period_s, number(wave_periods),
                             "Its period, on deep water.", Needed::yes)},
                        direction(&WaveSpec::direction_rad, "it runs"),
                        angle("phase", "_deg", "_rad", &WaveSpec::phase_rad, full_turn,
                              "Of the elevation's cosine at the origin at the start. Default {}.")}));
  form.read = [read = form.read](const Value& value) {
    const WaveSpec wave = read(value);
    check_steepness(value, 2.0 * wave.amplitude_m, wave.period_s);
    return wave;
  };
  return form;
}

Form<double> peakedness() {
  Form<double> form = number(from_to(0.0, 7.0));
  form.read = [read = form.read](const Value& value) {
    const double gamma = read(value);
    if (gamma > 0.0 && gamma < 1.0) value.expected("0 or a number in [1, 7]");
    return gamma;
  };
  return form;
}

Form<SpectrumSpec> spectrum() {
  Key<SpectrumSpec> gamma =
      key("peakedness_ratio", &SpectrumSpec::peakedness_ratio, peakedness(),
          "Gamma of jonswap, 1 to 7; 0 takes it from height and period as DNV does. Default {}.");
  gamma.write = [](const SpectrumSpec& spec) -> std::optional<Tree> {
    if (spec.spectrum != SpectrumKind::jonswap) return {};
    return Tree::number(spec.peakedness_ratio);
  };
  Form<SpectrumSpec> form = block_form(joined<SpectrumSpec>(
      {{key("spectrum", &SpectrumSpec::spectrum, enumeration<SpectrumKind>("spectrum"), "Which one.",
            Needed::yes),
        key("significant_height_m", &SpectrumSpec::significant_height_m, number(above_to(0.0, 100.0)),
            "Four standard deviations of the elevation.", Needed::yes),
        key("peak_period_s", &SpectrumSpec::peak_period_s, number(wave_periods), "Where it is highest.",
            Needed::yes),
        gamma},
       direction(&SpectrumSpec::direction_rad, "the waves run"),
       {key("spreading_count", &SpectrumSpec::spreading_count, integer(0, 100),
            "The s of cos^2s of the angle to that direction. Default {}: all waves run there."),
        key("components_count", &SpectrumSpec::components_count,
            integer(1, static_cast<std::int32_t>(max_wave_components)),
            "Waves that are drawn. Default {}.")}}));
  form.read = [read = form.read](const Value& value) {
    const SpectrumSpec spec = read(value);
    const Tree* given = value.tree().find("peakedness_ratio");
    if (given != nullptr && spec.spectrum != SpectrumKind::jonswap)
      refuse_at(given->where, value.path() + ".peakedness_ratio", "only jonswap has one");
    check_steepness(value, spec.significant_height_m, spec.peak_period_s);
    return spec;
  };
  return form;
}

/// A list of waves, or a mapping of a spectrum.
Form<WavesSpec> waves() {
  const Form<std::vector<WaveSpec>> list = list_up_to(max_wave_components, wave(), "waves");
  const Form<SpectrumSpec> drawn = spectrum();
  return {.read =
              [list, drawn](const Value& value) {
                if (value.tree().is_map()) return WavesSpec{.components = {}, .spectrum = drawn.read(value)};
                if (value.tree().is_scalar()) value.expected("a list of waves, or a mapping of a spectrum");
                return WavesSpec{.components = list.read(value), .spectrum = {}};
              },
          .write = [list, drawn](const WavesSpec& spec) -> std::optional<Tree> {
            return spec.spectrum ? drawn.write(*spec.spectrum) : list.write(spec.components);
          },
          .schema = Tree::map({{"anyOf", Tree::list({list.schema, drawn.schema})}})};
}

Form<std::vector<ProfilePoint>> profile() {
  const Form<ProfilePoint> point =
      block_form<ProfilePoint>({key("depth_m", &ProfilePoint::depth_m, number(depths), "Where.", Needed::yes),
                                key("speed_mps", &ProfilePoint::speed_mps, number(flow_speeds),
                                    "How fast the water is there.", Needed::yes)});
  Form<std::vector<ProfilePoint>> form = list_up_to(max_profile_points, point, "points");
  form.read = [read = form.read](const Value& value) {
    std::vector<ProfilePoint> points = read(value);
    if (points.size() < 2)
      value.refuse(fmt::format("a profile needs at least two points, got {}", points.size()));
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i].depth_m > points[i - 1].depth_m) continue;
      value.entry(i).refuse(fmt::format("depth_m is {}, not below that of the point before, {}",
                                        number_text(points[i].depth_m), number_text(points[i - 1].depth_m)));
    }
    return points;
  };
  form.schema.set("minItems", Tree::word("2"));
  return form;
}

Form<ShearedCurrentSpec> sheared() {
  return block_form(joined<ShearedCurrentSpec>(
      {direction(&ShearedCurrentSpec::direction_rad, "it flows"),
       {key("profile", &ShearedCurrentSpec::profile, profile(),
            "Its speed at depths, downwards: linear between them, and beyond them as at the nearest.",
            Needed::yes)}}));
}

Form<GaussMarkovCurrentSpec> gauss_markov() {
  using Spec = GaussMarkovCurrentSpec;
  constexpr Bounds time = above_to(0.0, 1e7);
  Form<Spec> form = block_form(joined<Spec>(
      {{key("mean_speed_mps", &Spec::mean_speed_mps, number(flow_speeds), "Its mean speed.", Needed::yes),
        key("deviation_mps", &Spec::deviation_mps, number(from_to(0.0, fastest_flow)),
            "Standard deviation of the speed.", Needed::yes),
        key("correlation_time_s", &Spec::correlation_time_s, number(time), "Of the speed. Default {}."),
        key("min_speed_mps", &Spec::min_speed_mps, number(flow_speeds), "It is never slower. Default {}."),
        key("max_speed_mps", &Spec::max_speed_mps, unless(unlimited, number(flow_speeds)),
            "It is never faster. Default: no such limit.")},
       direction(&Spec::direction_rad, "it flows"),
       angle("direction_deviation", "_deg", "_rad", &Spec::direction_deviation_rad, from_to(0.0, 360.0),
             "Standard deviation of the direction. Default {}."),
       {key("direction_correlation_time_s", &Spec::direction_correlation_time_s, number(time),
            "Of the direction. Default {}.")}}));
  form.read = [read = form.read](const Value& value) {
    const Spec spec = read(value);
    if (spec.min_speed_mps > spec.max_speed_mps) value.refuse("min_speed_mps is above max_speed_mps");
    const double reached = spec.mean_speed_mps + 3.0 * spec.deviation_mps;
    if (reached > fastest_flow && spec.max_speed_mps == unlimited)
      value.refuse(
          fmt::format("mean_speed_mps and three times deviation_mps come to {} m/s; expected at most {}, or "
                      "a max_speed_mps",
                      number_text(reached), number_text(fastest_flow)));
    if (spec.mean_speed_mps < spec.min_speed_mps || spec.mean_speed_mps > spec.max_speed_mps)
      value.refuse(fmt::format("mean_speed_mps is {}, not in [{}, {}] of min_speed_mps and max_speed_mps",
                               number_text(spec.mean_speed_mps), number_text(spec.min_speed_mps),
                               number_text(spec.max_speed_mps)));
    return spec;
  };
  return form;
}

Form<CurrentSpec> current() {
  return block_form<CurrentSpec>(
      {key("sheared", &CurrentSpec::sheared, optional(sheared()), "Its speed depends on the depth."),
       key("gauss_markov", &CurrentSpec::gauss_markov, optional(gauss_markov()),
           "Its speed and direction wander about a mean.")});
}

}  // namespace

Form<WaterSpec> water() {
  Key<WaterSpec> uniform = key("current_mps", &WaterSpec::current_n, vector(flow_speeds),
                               "Uniform [n, e, d]. Default none. Either this or current.");
  uniform.write = [write = uniform.write](const WaterSpec& spec) {
    return spec.current.none() ? write(spec) : std::nullopt;
  };
  return block_form<WaterSpec>(
      {key("density_kgpm3", &WaterSpec::density_kgpm3, number(above_to(0.0, 20000.0)), "Default {}."),
       uniform,
       key("current", &WaterSpec::current, current(),
           "One that changes with depth, with time, or both, which then add."),
       key("waves", &WaterSpec::waves, waves(),
           "One by one, or drawn from a spectrum. Default: a calm surface.")});
}

}  // namespace fairway::yaml
