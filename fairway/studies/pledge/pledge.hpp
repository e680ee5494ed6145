// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/studies/study.hpp"

namespace fairway::pledges {

/// Nothing of it is published: what `pledge` keeps of its promise where words are lost, water flows, places
/// drift and a member breaks, and what others come to under the same seeds.
Study study();

}  // namespace fairway::pledges
