// SPDX-License-Identifier: GPL-3.0-or-later
// The jaws of the world: taking hold, squeezing, slipping and letting go.
#include "core/session_state.h"
#include "modules/exercises/object_handling/simulation/handling_world.h"

#include <algorithm>
#include <limits>

namespace chiron::simulation {

namespace bits = core::event_bits;

namespace {

/// Share of the squeeze limit below which a new over-squeeze counts again (models.md §6, trauma).
constexpr double kRearmShare = 0.8;

} // namespace

void HandlingWorld::updateGrip(const HandlingTool& tool, HandlingAnswer& answer) noexcept {
    if (!tool.present) {
        if (m_held != kNone)
            letGo(tool);
        m_latch.lose();
    } else {
        const double thickness_m = 2.0 * m_parameters.radius_m;
        const int near = m_held == kNone ? nearestInReach(tool) : m_held;
        switch (m_latch.update(tool.opening_m, thickness_m, thickness_m + m_parameters.releaseClearance_m,
                               near != kNone)) {
        case GraspChange::grasped:
            takeHold(near, tool);
            answer.events |= bits::kGrasped;
            break;
        case GraspChange::released:
            letGo(tool);
            answer.events |= bits::kReleased;
            break;
        case GraspChange::none:
            // It has slid out: reported now, and not again when it lands
            if (m_held != kNone && slidShare() >= 1.0) {
                m_latch.lose();
                Body& slid = m_bodies[static_cast<std::size_t>(m_held)];
                letGo(tool);
                slid.dropCounts = false;
                answer.events |= bits::kSlipped;
            }
            break;
        }
    }
    squeezeHeld(tool, answer);
}

int HandlingWorld::nearestInReach(const HandlingTool& tool) const noexcept {
    double nearest = m_parameters.graspReach_m;
    int found = kNone;
    for (std::size_t i = 0; i < m_count; ++i) {
        const double away = (tool.p_W - m_bodies[i].it.p_W).norm() - m_bodies[i].it.radius_m();
        if (away <= nearest) {
            nearest = away;
            found = static_cast<int>(i);
        }
    }
    return found;
}

void HandlingWorld::takeHold(int which, const HandlingTool& tool) noexcept {
    Body& body = m_bodies[static_cast<std::size_t>(which)];
    m_held = which;
    m_grip_m = body.it.p_W - tool.p_W;
    m_slide.reset();
    body.dropCounts = false; // an earlier fall no longer counts
    body.it.v_W = tool.v_W;
    body.tip.reset();
}

void HandlingWorld::letGo(const HandlingTool& tool) noexcept {
    Body& body = m_bodies[static_cast<std::size_t>(m_held)];
    if (!tool.present)
        body.it.v_W.setZero();
    else
        body.dropCounts = !body.it.onBed(); // setting down is not a drop
    body.inside = body.embraced = true;     // the jaws are still around it
    m_held = kNone;
}

/// Share of the distance out of the jaws (half its thickness) that it has slid, 0..1.
double HandlingWorld::slidShare() const noexcept {
    return m_slide.offset().norm() / m_parameters.radius_m;
}

void HandlingWorld::squeezeHeld(const HandlingTool& tool, HandlingAnswer& answer) noexcept {
    m_squeeze = Squeeze{};
    if (m_held != kNone) {
        const double s = std::min(1.0, slidShare());
        // The jaws hold an object less and less while it slides out
        const double grips = 1.0 - s * s * (3.0 - 2.0 * s);
        const double thickness_m = 2.0 * m_parameters.radius_m;
        const double pressed_m = grips * std::max(0.0, thickness_m - tool.opening_m);
        m_squeeze = Squeeze::of(m_object.elastic(), thickness_m, thickness_m - pressed_m);
        checkRange(0.5 * m_squeeze.compression_m, answer); // half of it at each jaw
    }
    if (m_damageArmed && m_squeeze.force_N > m_parameters.squeezeLimit_N) {
        m_damageArmed = false;
        answer.events |= bits::kDamaged;
    } else if (m_squeeze.force_N < kRearmShare * m_parameters.squeezeLimit_N) {
        m_damageArmed = true;
    }
}

} // namespace chiron::simulation
