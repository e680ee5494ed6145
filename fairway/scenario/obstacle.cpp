// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "fairway/scenario/parts.hpp"
#include "fairway/scenario/polygon.hpp"
#include "fairway/scenario/tagged.hpp"

namespace fairway::yaml {
namespace {

Form<std::vector<Vec3>> vertices() {
  Form<Vec3> vertex = vector(anywhere);
  vertex.read = [](const Value& value) { return value.vertex(anywhere); };
  vertex.schema.set("minItems", Tree::word("2"));
  Form<std::vector<Vec3>> form = list_of(vertex, "vertices [n, e]");
  form.schema.set("minItems", Tree::word("3"));
  form.schema.set("maxItems", Tree::word(std::to_string(max_vertices)));
  return form;
}

void check_segment(const Value& value, const ObstacleSpec& segment) {
  if (segment.from == segment.to)
    value.refuse("from_m and to_m are the same place; a segment needs a length");
}

void check_polygon(const Value& value, const ObstacleSpec& polygon) {
  const std::vector<Vec3>& vertices = polygon.vertices;
  const std::size_t count = vertices.size();
  if (count < 3 || count > max_vertices) {
    value.refuse(fmt::format("a polygon needs 3 to {} vertices_m, got {}", max_vertices, count));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if (vertices[i].head<2>() == vertices[next].head<2>()) {
      value.refuse(fmt::format("vertices_m[{}] and [{}] are the same place; leave one out", i, next));
    }
  }
  const double area = signed_area(vertices);
  if (area == 0.0) value.refuse("the vertices_m lie on one line; a polygon needs an area");
  if (const auto edges = crossing_edges(vertices))
    value.refuse(fmt::format(
        "the edges from vertices_m[{}] and [{}] cross or touch; a polygon goes round one area, once",
        edges->first, edges->second));
  if (area < 0.0) {
    value.refuse(
        "the vertices_m run clockwise; write them counter-clockwise with n as x and e as y, that is in "
        "reverse");
  }
}

Key<ObstacleSpec> charted() {
  return key("charted", &ObstacleSpec::charted, unless(true, flag()),
             "Known to everyone beforehand; else only once it is perceived. Default true.");
}

const Kinds<ObstacleSpec>& obstacle_kinds() {
  static const Kinds<ObstacleSpec> table{
      {"sphere",
       "A ball.",
       {key("position_m", &ObstacleSpec::position, vector(anywhere), "Its centre [n, e, d].", Needed::yes),
        key("radius_m", &ObstacleSpec::radius, number(above_to(0.0, 1e6)), "Its radius.", Needed::yes),
        key("velocity_mps", &ObstacleSpec::velocity, unless(Vec3::Zero(), vector(from_to(-100.0, 100.0))),
            "It drifts, [n, e, d] over ground, from its position at the start. Default: it does not."),
        charted()},
       {}},
      {"segment",
       "A thin wall.",
       {key("from_m", &ObstacleSpec::from, vector(anywhere), "One end [n, e, d].", Needed::yes),
        key("to_m", &ObstacleSpec::to, vector(anywhere), "The other end [n, e, d].", Needed::yes), charted()},
       check_segment},
      {"polygon",
       "A solid vertical prism through every depth.",
       {key("vertices_m", &ObstacleSpec::vertices, vertices(),
            "Its corners [n, e] or [n, e, d], counter-clockwise with n as x and e as y.", Needed::yes),
        charted()},
       check_polygon},
  };
  return table;
}

}  // namespace

Form<ObstacleSpec> obstacle() {
  return {.read = [](const Value& value) { return read_tagged(value, obstacle_kinds()); },
          .write = [](const ObstacleSpec& spec) -> std::optional<Tree> {
            return write_tagged(spec, obstacle_kinds());
          },
          .schema = Tree::map({{"oneOf", Tree::list(tagged_schemas(obstacle_kinds()))}})};
}

}  // namespace fairway::yaml
