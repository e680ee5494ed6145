// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/ompl_search.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <mutex>
#include <shared_mutex>
#include <utility>

namespace fairway {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Vec2 point_of(const ob::State* state) {
  const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

/// Straight lines against the map itself, not point by point.
class ExactMotion : public ob::MotionValidator {
 public:
  ExactMotion(const ob::SpaceInformationPtr& space, const PlanarMap& map)
      : ob::MotionValidator(space), map_{map} {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return map_.is_free(point_of(from), point_of(to));
  }

  /// A motion that is not valid is valid at its start alone.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(from, to)) return true;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, from);
    last_valid.second = 0.0;
    return false;
  }

 private:
  const PlanarMap& map_;
};

class SeededSampler : public ob::RealVectorStateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint32_t seed) : ob::RealVectorStateSampler(space) {
    rng_.setLocalSeed(seed);
  }
};

/// OMPL's tree of nearest neighbours. It draws its pivots, which decide between neighbours equally near.
template <class T>
class SeededNeighbours : public ompl::NearestNeighborsGNATNoThreadSafety<T> {
 public:
  SeededNeighbours() { (this->pivotSelector_.*Pivots::generator()).setLocalSeed(0); }

 private:
  struct Pivots : ompl::GreedyKCenters<T> {
    static ompl::RNG ompl::GreedyKCenters<T>::*generator() { return &Pivots::rng_; }
  };
};

/// RRT*, or what derives from it, whose tree can be read where it lies: OMPL would copy it into a graph.
template <class Base>
class WithTree : public Base {
 public:
  using Base::Base;

  std::vector<Vec2> tree() const {
    std::vector<typename Base::Motion*> motions;
    this->nn_->list(motions);
    if (motions.size() > max_tree_edges + 1) return {};
    std::vector<Vec2> edges;
    edges.reserve(2 * motions.size());
    for (const typename Base::Motion* motion : motions) {
      if (motion->parent == nullptr) continue;
      edges.push_back(point_of(motion->parent->state));
      edges.push_back(point_of(motion->state));
    }
    return edges;
  }
};

class SeededRrtStar : public WithTree<og::RRTstar> {
 public:
  SeededRrtStar(const ob::SpaceInformationPtr& space, std::uint32_t seed) : WithTree(space) {
    rng_.setLocalSeed(seed);
  }
};

using InformedRrtStar = WithTree<og::InformedRRTstar>;

/// What BIT* has of a tree is known to it alone.
std::vector<Vec2> tree_of(const og::BITstar& planner) {
  ob::PlannerData data(planner.getSpaceInformation());
  planner.getPlannerData(data);
  if (data.numEdges() > max_tree_edges) return {};
  std::vector<Vec2> edges;
  for (unsigned to = 0; to < data.numVertices(); ++to) {
    std::vector<unsigned> sources;
    data.getIncomingEdges(to, sources);
    for (const unsigned from : sources) {
      edges.push_back(point_of(data.getVertex(from).getState()));
      edges.push_back(point_of(data.getVertex(to).getState()));
    }
  }
  return edges;
}

/// What is searched: the box around all there is, widened by a tenth of its diagonal.
ob::RealVectorBounds bounds_of(const PlanarMap& map, const PathRequest& request) {
  Eigen::AlignedBox2d box = map.bounds();
  box.extend(request.start);
  box.extend(request.goal);
  const double margin = 0.1 * box.diagonal().norm();
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, box.min()[axis] - margin);
    bounds.setHigh(axis, box.max()[axis] + margin);
  }
  return bounds;
}

ob::SpaceInformationPtr space_of(const PlanarMap& map, const PathRequest& request) {
  const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  plane->setBounds(bounds_of(map, request));
  const std::uint32_t seed = request.seed + 1;  // not that of the planner
  plane->setStateSamplerAllocator(
      [seed](const ob::StateSpace* space) { return std::make_shared<SeededSampler>(space, seed); });

  auto space = std::make_shared<ob::SpaceInformation>(plane);
  space->setStateValidityChecker([&map](const ob::State* state) { return map.is_free(point_of(state)); });
  space->setMotionValidator(std::make_shared<ExactMotion>(space, map));
  space->setup();
  return space;
}

ob::ProblemDefinitionPtr problem_of(const ob::SpaceInformationPtr& space, const PathRequest& request) {
  ob::ScopedState<ob::RealVectorStateSpace> start(space), goal(space);
  for (unsigned axis = 0; axis < 2; ++axis) {
    start[axis] = request.start[axis];
    goal[axis] = request.goal[axis];
  }
  auto problem = std::make_shared<ob::ProblemDefinition>(space);
  problem->setStartAndGoalStates(start, goal);
  problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(space));
  return problem;
}

std::shared_ptr<SeededRrtStar> rrt_star(const ob::SpaceInformationPtr& space,
                                        const ob::ProblemDefinitionPtr& problem, const PathRequest& request) {
  auto planner = std::make_shared<SeededRrtStar>(space, request.seed);
  planner->setProblemDefinition(problem);
  planner->setRange(request.range_m);
  planner->setNearestNeighbors<SeededNeighbours>();
  return planner;
}

std::shared_ptr<InformedRrtStar> informed_rrt_star(const ob::SpaceInformationPtr& space,
                                                   const PathRequest& request) {
  auto planner = std::make_shared<InformedRrtStar>(space);
  planner->setRange(request.range_m);
  return planner;
}

std::vector<Vec2> solution_of(const ob::ProblemDefinition& problem) {
  std::vector<Vec2> path;
  if (!problem.hasExactSolution()) return path;
  for (const ob::State* state : problem.getSolutionPath()->as<og::PathGeometric>()->getStates())
    path.push_back(point_of(state));
  return path;
}

SearchResult solve(const PlanarMap& map, const PathRequest& request) {
  const ob::SpaceInformationPtr space = space_of(map, request);
  const ob::ProblemDefinitionPtr problem = problem_of(space, request);
  const auto solved_by = [&](ob::Planner& planner) {
    planner.setProblemDefinition(problem);
    planner.setup();
    ob::IterationTerminationCondition enough(static_cast<unsigned>(request.iterations_count));
    planner.solve(enough);
    return solution_of(*problem);
  };

  switch (request.search) {
    case PathSearch::rrt_star: {
      const auto planner = rrt_star(space, problem, request);
      std::vector<Vec2> path = solved_by(*planner);
      return {std::move(path), planner->tree()};
    }
    case PathSearch::informed_rrt_star: {
      const auto planner = informed_rrt_star(space, request);
      std::vector<Vec2> path = solved_by(*planner);
      return {std::move(path), planner->tree()};
    }
    case PathSearch::bit_star:
      break;
  }
  og::BITstar planner(space);
  std::vector<Vec2> path = solved_by(planner);
  return {std::move(path), tree_of(planner)};
}

void silence_once() {
  static std::once_flag silenced;
  std::call_once(silenced, ompl::msg::noOutputHandler);
}

}  // namespace

SearchResult search_path(const PlanarMap& map, const PathRequest& request) {
  silence_once();
  static std::shared_mutex generator;  // OMPL's, from which all its generators of a process take their seeds
  if (request.search == PathSearch::rrt_star) {
    const std::shared_lock beside_others{generator};
    return solve(map, request);
  }
  const std::unique_lock alone{generator};
  ompl::RNG::setSeed(std::uint_fast32_t{1} + request.seed);  // 0 would leave it as it is
  return solve(map, request);
}

}  // namespace fairway
