// SPDX-License-Identifier: Apache-2.0
#include "fairway/exam/margins.hpp"

#include <algorithm>

#include "fairway/core/error.hpp"
#include "fairway/core/text.hpp"
#include "fairway/exam/entrance.hpp"

namespace fairway {
namespace {

bool is_margin(std::string_view name) { return name.ends_with("margin_m") || name == "standoff_m"; }

}  // namespace

std::string margins_of(const CampaignAlgorithm& method, const Catalog& methods) {
  const Choice choice = choice_of(method);
  std::string text;
  for (const Catalog::Entry* layer : methods.layers(choice.name)) {
    std::string own;
    for (const ParamInfo& param : layer->params) {
      if (!is_margin(param.name)) continue;
      const auto set = std::ranges::find(choice.params, param.name, &ParamValues::value_type::first);
      const double* value = std::get_if<double>(set == choice.params.end() ? &param.value : &set->second);
      if (value != nullptr) own += (own.empty() ? " " : ", ") + param.name + " " + number_text(*value);
    }
    if (!own.empty()) text += (text.empty() ? "" : "; ") + std::string(layer->info.name) + own;
  }
  return text;
}

ExamMargins margins_in(const ExamFile& exam, const ExamQuestion& question, const Catalog& methods) {
  ExamMargins margins;
  for (const ExamFamily& family : question.families) {
    for (const CampaignAlgorithm& method : exam.methods) {
      try {
        margins[{family.name, method.label}] = margins_of(method, methods);
      } catch (const InputError&) {  // of somebody else's catalog, and not asked
      }
    }
    for (const Candidate& candidate : question.candidates) {
      if (!candidate.families.empty() &&
          std::ranges::find(candidate.families, family.name) == candidate.families.end())
        continue;
      margins[{family.name, candidate.method.label + (candidate.tuned ? ", tuned" : "")}] =
          margins_of(candidate.method, methods);
    }
  }
  return margins;
}

}  // namespace fairway
