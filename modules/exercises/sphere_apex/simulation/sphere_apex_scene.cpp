// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"

#include "core/units.h"
#include "cues/laparoscopy_cues.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace bits = core::event_bits;

void SphereApexScene::respond(const realtime::HapticTick& now, const SceneInput& in,
                              SceneOutput& out) noexcept {
    out = SceneOutput{};
    advance(now.index(), in, out);
    if (m_dome && m_dome->update(now.index(), in.slow))
        out.events |= bits::kSlowApplied;
    touch(in, out);
    if (m_dome && m_course.present())
        m_dome->ask(now.index());
    if (const DeformableOrgan* organ = m_dome ? m_dome->organ() : nullptr;
        organ != nullptr && m_course.present()) {
        out.quantities[apex_quantity::kPredictionError] = organ->predictionError().predicted_m;
        out.quantities[apex_quantity::kHeldError] = organ->predictionError().held_m;
    }
    m_course.write(in, out);
    fillCues(out);
}

void SphereApexScene::advance(std::uint64_t tick, const SceneInput& in, SceneOutput& out) noexcept {
    const bool pressed =
        markPressed(in); // called in every tick, so that an edge during a pause is seen and ignored
    const TrialCourse::Turn turn = m_course.advance(in, out);
    if (turn == TrialCourse::Turn::prepares)
        prepare(tick);
    if (turn != TrialCourse::Turn::runs)
        return;
    if (pressed)
        m_course.end(bits::kMarked, out);
    else if (m_course.timeIsUp())
        m_course.end(bits::kTimedOut, out);
}

bool SphereApexScene::markPressed(const SceneInput& in) noexcept {
    const bool down = in.tools.count > 0 && (in.tools.tools[0].buttons & core::kButtonMark) != 0;
    const bool edge = down && !m_buttonWasDown;
    m_buttonWasDown = down;
    return edge || in.mark;
}

void SphereApexScene::prepare(std::uint64_t tick) noexcept {
    m_contact = HemisphereContact(sphereApexContact(m_parameters, m_trials[m_course.trial()]));
    m_yields.fill(ContactYield(m_parameters.yield));
    if (m_dome)
        m_dome->begin(m_course.trial(), tick);
}

/// Bounds how fast the force changes with position in any direction. The ball's force turns with the nearest
/// point, by d/(R − d) of the stiffness. A dimple adds 2 k ‖∇h‖ + k ‖∇h‖² + k d ‖∇∇h‖, whose last term is at
/// most 8 D/w².
double SphereApexScene::steepest(const ContactResponse& response, const core::Vec3& p_WT) const noexcept {
    const double R = m_parameters.radius_m, d = response.depth_m;
    double share = std::max(1.0, d / std::max(R - d, (1.0 - kDeepestShare) * R));
    const Dimple& dimple = m_contact.parameters().dimple;
    if (const HeightSample micro = dimple.sample(p_WT.x(), p_WT.y()); micro.height_m != 0.0) {
        const double slope = micro.gradient.norm();
        share += 2.0 * slope + slope * slope +
                 d * 8.0 * dimple.depth_m / (dimple.halfWidth_m * dimple.halfWidth_m);
    }
    return share * response.stiffness_N_per_m;
}

ContactResponse SphereApexScene::touchExact(std::size_t tool, const core::ToolState& state,
                                            double mostDamping_Ns_per_m) noexcept {
    ContactResponse response =
        m_contact.respond(state.p_WT, state.v_WT, m_bristles[tool], mostDamping_Ns_per_m);
    ContactYield& yield = m_yields[tool];
    if (response.inContact)
        response.stiffness_N_per_m = steepest(response, state.p_WT);
    const bool tooDeep = response.depth_m > kDeepestShare * m_parameters.radius_m;
    const double holds = yield.step(response.force.norm(), !response.inContact, yield.everYields() && tooDeep,
                                    core::kTickSeconds);
    scale(response, holds);
    response.bits = yield.bits();
    if (tooDeep && holds > 0.0) // earlier content has no yield force, and its dome never gives way
        response.bits |= core::contact_bits::kBeyondChecked;
    return response;
}

ContactResponse SphereApexScene::touchWith(std::size_t tool, const core::ToolState& state,
                                           double mostDamping_Ns_per_m) noexcept {
    if (m_dome)
        return m_dome->respond(tool, state.p_WT, state.v_WT, mostDamping_Ns_per_m);
    if (m_parameters.surface == ApexSurface::exact)
        return touchExact(tool, state, mostDamping_Ns_per_m);
    // The dome could not be made; another surface would be another exercise, so the trials run out untouched
    ContactResponse nothing;
    nothing.surfacePoint = state.p_WT;
    return nothing;
}

void SphereApexScene::touch(const SceneInput& in, SceneOutput& out) noexcept {
    const core::ToolStates& tools = in.tools;
    const int count = std::clamp(tools.count, 0, core::kMaxTools);
    out.tissue.count = count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(core::kMaxTools); ++i) {
        ContactResponse response;
        const bool used = i < static_cast<std::size_t>(count);
        const core::ToolState& tool = tools.tools[i];
        // A pose that is not finite must not stay in the bristle; the supervisor deals with the sample.
        if (used && m_course.present() && tool.p_WT.allFinite() && tool.v_WT.allFinite()) {
            response = touchWith(i, tool, in.dampingBudget_Ns_per_m[i]);
            out.p_WProxy[i] = response.surfacePoint;
        } else {
            m_bristles[i].release();
            m_yields[i].reset();
            if (m_dome)
                m_dome->release(i);
            if (used)
                out.p_WProxy[i] = tool.p_WT;
        }
        out.tissue.tools[i].force = response.force;
        out.contact[i] = response.bits;
        out.damping_Ns_per_m[i] = response.damping_Ns_per_m;
        out.load_N[i] = response.load_N;
        out.storedEnergy_J += response.energy_J;
        out.contactStiffness_N_per_m = std::max(out.contactStiffness_N_per_m, response.stiffness_N_per_m);
        if (response.inContact != m_touching[i])
            out.events |= response.inContact ? bits::kContactBegan : bits::kContactEnded;
        m_touching[i] = response.inContact;
    }
}

void SphereApexScene::fillCues(SceneOutput& out) const noexcept {
    core::VisibleCues& cues = out.cues;
    if (!m_course.present())
        return;
    cues.timeLeft_s = m_course.timeLeft_s();
    if (!m_showsObject)
        return;
    const core::Vec2& centre = m_trials[m_course.trial()].centre_m;
    cues.objectShown = true;
    cues.p_WObject = core::Vec3(centre.x(), centre.y(), m_parameters.planeHeight_m);
    cues.objectRadius_m = m_parameters.radius_m;
    if (m_dome) { // its bumps lie elsewhere in each trial, because it is rotated about the vertical
        const double half_rad = 0.5 * m_trials[m_course.trial()].turn_rad;
        cues.exercise.own<core::LaparoscopyCues>().body[0].q_W = {std::cos(half_rad), 0.0, 0.0,
                                                                  std::sin(half_rad)};
    }
}

} // namespace chiron::simulation
