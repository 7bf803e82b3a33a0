// SPDX-License-Identifier: GPL-3.0-or-later
// Construction and destruction use the heap, so they are kept apart from the code that the tick calls.
#include "mechanisms/scripted_motion.h"

#include <utility>

namespace chiron::mechanisms {

ScriptedMotion::ScriptedMotion(const core::Vec3& centre_D, std::vector<Term> terms)
    : m_centre_D(centre_D), m_terms(std::move(terms)) {}

ScriptedMotion::~ScriptedMotion() = default;

} // namespace chiron::mechanisms
