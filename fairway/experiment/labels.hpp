// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/experiment/run.hpp"

namespace fairway {

/// The values of each label, in the order of a campaign's file: {"method", {"orca3d", "apf"}}.
using LabelValues = std::vector<std::pair<std::string, std::vector<std::string>>>;

/// Adds what is not there yet, at the ends.
void add_values(LabelValues& known, const Labels& labels);
void add_values(LabelValues& known, const LabelValues& more);

/// Those of the label `name`; none if it is not there.
std::vector<std::string> values_of(const LabelValues& known, std::string_view name);

/// The value of the label `name`, or null.
const std::string* find_label(const Labels& labels, std::string_view name);

/// The labels but `name`, in their order.
Labels without_label(const Labels& labels, std::string_view name);

/// "case=cube20_8 method=orca3d".
std::string labels_text(const Labels& labels);

/// A total order of label values in which numbers come before words and 6 before 10.
std::strong_ordering natural_order(std::string_view a, std::string_view b);

/// The order of results everywhere: label by label, names as text and values naturally.
std::strong_ordering label_order(const Labels& a, const Labels& b);

/// True if `name` may be a label: not empty, and no column of the CSV export.
bool can_be_label(std::string_view name);

}  // namespace fairway
