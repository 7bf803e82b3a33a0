// SPDX-License-Identifier: GPL-3.0-or-later
// Making and destroying one touches the heap: apart from what the tick calls.
#include "mechanisms/scripted_motion.h"

#include <utility>

namespace chiron::mechanisms {

ScriptedMotion::ScriptedMotion(const core::Vec3& centre_D, std::vector<Term> terms)
    : m_centre_D(centre_D), m_terms(std::move(terms)) {}

ScriptedMotion::~ScriptedMotion() = default;

} // namespace chiron::mechanisms
