// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/simulation/palpation_scene.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::simulation {

namespace bits = core::event_bits;

namespace {
std::uint8_t contactOf(const TissueYield& yield, const TissueYield& pinchYield,
                       const TissueResponse& response) noexcept {
    using namespace core::contact_bits;
    return static_cast<std::uint8_t>((response.beyondChecked ? kBeyondChecked : 0) |
                                     (yield.yielded() || pinchYield.yielded() ? kYielded : 0) |
                                     (yield.through() || pinchYield.through() ? kThrough : 0));
}
} // namespace

void PalpationScene::respond(const realtime::HapticTick&, const SceneInput& in, SceneOutput& out) noexcept {
    out = SceneOutput{};
    const int count = std::clamp(in.tools.count, 0, core::kMaxTools);
    m_buttons.follow(in.tools, count);
    const TrialCourse::Turn turn = m_course.advance(in, out);
    if (turn == TrialCourse::Turn::prepares)
        prepare();
    if (turn == TrialCourse::Turn::leaves)
        leave();
    touch(in, count, out);
    if (turn == TrialCourse::Turn::runs) {
        follow(in);
        endTrial(out);
    }
    m_course.write(in, out);
    if (m_course.present())
        fillQuantities(out);
    fillCues(out);
}

void PalpationScene::prepare() noexcept {
    m_moved = false;
    m_findings.clear();
    m_waiting.clear();
    m_nextReport = 0;
    m_map.clear();
    m_told.fill(0.0);
    m_tissue.setLumps(m_trials[m_course.trial()].list());
}

void PalpationScene::leave() noexcept {
    for (Finger& finger : m_fingers)
        finger.touch.release();
}

void PalpationScene::endTrial(SceneOutput& out) noexcept {
    if (m_findings.done())
        m_course.end(bits::kCompleted, out);
    else if (m_course.timeIsUp() && m_waiting.empty() && m_course.clock() >= m_nextReport)
        m_course.end(bits::kTimedOut, out);
}

void PalpationScene::moveLumps() noexcept {
    if (m_moveTicks == 0 || m_moved || m_course.clock() < m_moveTicks)
        return;
    if (std::any_of(m_fingers.begin(), m_fingers.end(),
                    [](const Finger& finger) { return finger.response.inContact; }))
        return;
    PalpationTrial moved = m_trials[m_course.trial()];
    for (Lump& lump : moved.lump)
        lump.place_m = palpationMovedPlace_m(m_parameters, lump.place_m);
    m_tissue.setLumps(moved.list());
    m_moved = true;
}

/// Scales all effects of the tissue by the share that it still bears. A finger that has gone through touches
/// nothing until it is out.
void PalpationScene::giveWay(Finger& finger, double dt_s) const noexcept {
    TissueResponse& response = finger.response;
    const double factor = finger.yield.step(response.force.norm(), !response.inContact, dt_s);
    if (factor == 1.0)
        return;
    response.force *= factor;
    response.normalForce_N *= factor;
    response.display.normalForce_N *= factor;
    response.energy_J *= factor;
    response.stiffness_N_per_m *= factor;
    response.damping_Ns_per_m *= factor;
    response.inContact = factor > 0.0;
    finger.squeeze_N *= factor;
}

/// Adds the squeeze of the jaws to the pad's force, and the pull of the held tissue to the tool's. Torn
/// tissue is whole again once nothing is between the jaws.
void PalpationScene::pinch(Finger& finger, const core::ToolState& tool, double dt_s) const noexcept {
    TissueResponse& response = finger.response;
    const PinchResponse pinched = pinchTissue(m_tissue, *m_parameters.pinch, tool, response, finger.pinched);
    const double factor = finger.pinchYield.step(pinched.force_N, !(pinched.compression_m > 0.0), dt_s);
    finger.squeeze_N = factor * pinched.force_N;
    response.force += factor * pinched.hold;
    response.display.normalForce_N += finger.squeeze_N;
    response.energy_J += factor * pinched.energy_J;
    response.stiffness_N_per_m += factor * pinched.stiffness_N_per_m;
    response.beyondChecked = response.beyondChecked || (pinched.beyondChecked && finger.squeeze_N > 0.0);
}

void PalpationScene::touchWith(Finger& finger, bool jaw, const core::ToolState& tool,
                               double mostDamping_Ns_per_m) const noexcept {
    finger.response = m_tissue.respond(tool, finger.touch, mostDamping_Ns_per_m);
    finger.squeeze_N = 0.0;
    if (jaw && !m_parameters.control.forceOff)
        pinch(finger, tool, core::kTickSeconds);
    if (!m_parameters.control.forceOff)
        giveWay(finger, core::kTickSeconds);
    finger.above_m = finger.response.depth_m > 0.0 ? 0.0 : (tool.p_WT - finger.response.surfacePoint).norm();
    if (!m_parameters.control.forceOff)
        return;
    TissueResponse nothing;
    nothing.surfacePoint = finger.response.surfacePoint;
    nothing.normal = finger.response.normal;
    nothing.depth_m = finger.response.depth_m;
    finger.response = nothing;
}

void PalpationScene::touch(const SceneInput& in, int count, SceneOutput& out) noexcept {
    const core::ToolStates& tools = in.tools;
    out.tissue.count = count;
    for (std::size_t i = 0; i < m_fingers.size(); ++i) {
        Finger& finger = m_fingers[i];
        const core::ToolState& tool = tools.tools[i];
        const bool there = static_cast<int>(i) < count;
        // A pose that is not finite touches nothing; the supervisor deals with the sample.
        finger.used = there && m_course.present() && tool.p_WT.allFinite() && tool.v_WT.allFinite() &&
                      tool.q_WT.coeffs().allFinite();
        if (finger.used) {
            touchWith(finger, hasJaw(i), tool, in.dampingBudget_Ns_per_m[i]);
        } else {
            finger.touch.release();
            finger.pinched.release();
            finger.response = TissueResponse{};
            finger.yield.reset();
            finger.pinchYield.reset();
            finger.squeeze_N = 0.0;
        }
        const TissueResponse& response = finger.response;
        out.contact[i] = contactOf(finger.yield, finger.pinchYield, response);
        if (there)
            out.p_WProxy[i] = finger.used && response.inContact ? response.surfacePoint : tool.p_WT;
        out.tissue.tools[i].force = response.force;
        out.display[i] = response.display;
        out.damping_Ns_per_m[i] = response.damping_Ns_per_m;
        out.storedEnergy_J += response.energy_J;
        out.contactStiffness_N_per_m = std::max(out.contactStiffness_N_per_m, response.stiffness_N_per_m);
        if (response.inContact != finger.touching)
            out.events |= response.inContact ? bits::kContactBegan : bits::kContactEnded;
        finger.touching = response.inContact;
    }
}

void PalpationScene::follow(const SceneInput& in) noexcept {
    search();
    moveLumps();
    if (m_course.clock() <= m_course.limit_ticks())
        takeReports(in);
    passReport();
}

void PalpationScene::search() noexcept {
    for (const Finger& finger : m_fingers)
        if (finger.response.inContact)
            m_map.press(finger.response.surfacePoint.head<2>(), finger.response.normalForce_N);
}

} // namespace chiron::simulation
