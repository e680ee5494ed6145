// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/ompl_search.hpp"

#include <ompl/base/MotionValidator.h>
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

  /// Of a motion that is not valid, nothing but its start is.
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

class SeededRrtStar : public og::RRTstar {
 public:
  SeededRrtStar(const ob::SpaceInformationPtr& space, std::uint32_t seed) : og::RRTstar(space) {
    rng_.setLocalSeed(seed);
  }
};

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

ob::PlannerPtr rrt_star(const ob::SpaceInformationPtr& space, const ob::ProblemDefinitionPtr& problem,
                        const PathRequest& request) {
  const auto planner = std::make_shared<SeededRrtStar>(space, request.seed);
  planner->setProblemDefinition(problem);
  planner->setRange(request.range_m);
  planner->setNearestNeighbors<SeededNeighbours>();
  return planner;
}

ob::PlannerPtr informed_rrt_star(const ob::SpaceInformationPtr& space, const PathRequest& request) {
  const auto planner = std::make_shared<og::InformedRRTstar>(space);
  planner->setRange(request.range_m);
  return planner;
}

std::vector<Vec2> solve(const PlanarMap& map, const PathRequest& request) {
  const ob::SpaceInformationPtr space = space_of(map, request);
  const ob::ProblemDefinitionPtr problem = problem_of(space, request);
  const ob::PlannerPtr planner = request.search == PathSearch::rrt_star ? rrt_star(space, problem, request)
                                 : request.search == PathSearch::informed_rrt_star
                                     ? informed_rrt_star(space, request)
                                     : ob::PlannerPtr{std::make_shared<og::BITstar>(space)};
  planner->setProblemDefinition(problem);
  planner->setup();
  ob::IterationTerminationCondition enough(static_cast<unsigned>(request.iterations_count));
  planner->solve(enough);
  if (!problem->hasExactSolution()) return {};

  std::vector<Vec2> path;
  for (const ob::State* state : problem->getSolutionPath()->as<og::PathGeometric>()->getStates()) {
    path.push_back(point_of(state));
  }
  return path;
}

void silence_once() {
  static std::once_flag silenced;
  std::call_once(silenced, ompl::msg::noOutputHandler);
}

}  // namespace

std::vector<Vec2> search_path(const PlanarMap& map, const PathRequest& request) {
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
