// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <string>
#include <string_view>

#include "fairway/experiment/run.hpp"

namespace fairway {

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
