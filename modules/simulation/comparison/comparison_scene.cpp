// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/comparison/comparison_scene.h"

#include "core/contact_bits.h"
#include "core/units.h"
#include "cues/laparoscopy_cues.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace chiron::simulation {

using core::TrialPhase;
namespace bits = core::event_bits;

void ComparisonScene::respond(const realtime::HapticTick&, const SceneInput& in, SceneOutput& out) noexcept {
    out = SceneOutput{};
    m_paused = in.paused;
    hear(in);
    advance(in, out);
    touch(in, out);
    m_course.write(in, out);
    fillCues(out);
}

/// Called in every tick, also while paused, so that no command is lost.
void ComparisonScene::hear(const SceneInput& in) noexcept {
    if (in.present && known(core::decodePresentation(in.presented))) {
        m_next = core::decodePresentation(in.presented);
        m_pending = true;
    }
    if (in.answer && in.answered == kAnswerFinish)
        m_finish = true;
    else if (in.answer && m_course.phase() == TrialPhase::running) {
        m_answering = true;
        m_answerWord = in.answered;
    }
}

void ComparisonScene::advance(const SceneInput& in, SceneOutput& out) noexcept {
    const int pressed = buttonAnswer(in);
    if (pressed >= 0 && !in.paused && m_course.phase() == TrialPhase::running && !m_answering) {
        m_answering = true;
        m_answerWord = static_cast<std::uint16_t>(pressed);
    }
    const TrialCourse::Signals signals{
        .paused = in.paused, .forceReady = in.forceReady, .next = m_pending, .stop = m_finish};
    const TrialCourse::Turn turn = m_course.advance(signals, out);
    if (turn == TrialCourse::Turn::prepares)
        prepare();
    else if (turn == TrialCourse::Turn::runs)
        run(out);
    else if (turn == TrialCourse::Turn::leaves)
        leave();
}

void ComparisonScene::prepare() noexcept {
    m_begun = true;
    m_pending = m_answering = false;
    m_answered = -1;
    m_touched = 0;
    m_word = m_next;
    setPlaces(false);
}

void ComparisonScene::run(SceneOutput& out) noexcept {
    if (m_pending && m_parameters.adjusts) {
        m_word = m_next;
        m_pending = false;
    }
    if (m_parameters.adjusts)
        setPlaces(true);
    if (m_answering && m_answerWord != kAnswerSpoiled) {
        m_answered = m_answerWord;
        m_course.end(bits::kCompleted, out);
    } else if (m_answering || m_finish) {
        m_course.end(bits::kFailed, out);
    } else if (!freely() && m_course.timeIsUp()) {
        m_course.end(bits::kTimedOut, out);
    }
}

void ComparisonScene::leave() noexcept {
    for (ComparedObject& object : m_objects)
        object.clear();
}

/// Sets the objects at all places. `onlyChanged`: sets only places whose word has changed and that nobody
/// touches.
void ComparisonScene::setPlaces(bool onlyChanged) noexcept {
    constexpr std::uint64_t kOdd =
        0x9E3779B97F4A7C15ull; // golden ratio: streams of trials and places stay apart
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_parameters.places); ++i) {
        if (onlyChanged && (m_set[i] == m_word || !m_objects[i].free()))
            continue;
        m_set[i] = m_word;
        const std::uint64_t seed = m_seed + kOdd * (static_cast<std::uint64_t>(m_course.trial()) * 4 + i + 1);
        if (const auto value = valueAt(m_word, static_cast<int>(i)))
            m_objects[i].set(m_parameters, static_cast<int>(i), *value, seed);
        else
            m_objects[i].clear();
    }
    // The same for all, so that the load follows from the energy wherever the tool is. It stays as it is
    // while a pad is touched, because the force would jump.
    if (std::ranges::any_of(m_objects, [](const auto& object) { return object.present() && !object.free(); }))
        return;
    m_steepest = 1.0;
    for (const ComparedObject& object : m_objects)
        m_steepest = std::max(m_steepest, object.present() ? object.steepest() : 1.0);
}

bool ComparisonScene::known(const core::PresentationWord& word) const noexcept {
    return static_cast<std::size_t>(word.candidate) < m_parameters.values.size() &&
           static_cast<std::size_t>(word.arrangement) < m_parameters.arrangements.size();
}

std::optional<double> ComparisonScene::valueAt(const core::PresentationWord& word, int place) const noexcept {
    if (!known(word) || place < 0 || place >= m_parameters.places)
        return std::nullopt;
    auto arrangement = static_cast<std::size_t>(word.arrangement);
    if (m_parameters.control == ComparisonControl::swapped)
        arrangement = (arrangement + 1) % m_parameters.arrangements.size();
    int multiple = m_parameters.arrangements[arrangement][static_cast<std::size_t>(place)];
    if (multiple < 0 || multiple > 2)
        return std::nullopt;
    if (m_parameters.control == ComparisonControl::constant)
        multiple = 0;
    return m_parameters.values[static_cast<std::size_t>(word.candidate)][static_cast<std::size_t>(multiple)];
}

/// Whether the present objects are those on which the controls are tried.
bool ComparisonScene::freely() const noexcept {
    return m_parameters.freeFirst && m_course.trial() == 0;
}

bool ComparisonScene::exploring() const noexcept {
    return m_course.phase() == TrialPhase::ready ||
           (m_course.phase() == TrialPhase::running &&
            (m_exploreTicks == 0 || m_course.clock() <= m_exploreTicks || freely()));
}

/// Returns the place that the mark button answers; −1: none.
int ComparisonScene::buttonAnswer(const SceneInput& in) noexcept {
    const bool down = in.tools.count > 0 && (in.tools.tools[0].buttons & core::kButtonMark) != 0;
    const bool edge = (down && !m_buttonWasDown) || in.mark;
    m_buttonWasDown = down;
    const std::uint32_t every = (1u << static_cast<unsigned>(m_parameters.places)) - 1u;
    const bool taken = m_parameters.buttonAnswers && !freely() &&
                       (!m_parameters.buttonNeedsAll || (m_touched & every) == every);
    return edge && taken && m_place >= 0 ? m_place : -1;
}

void ComparisonScene::touch(const SceneInput& in, SceneOutput& out) noexcept {
    const int count = std::clamp(in.tools.count, 0, core::kMaxTools);
    out.tissue.count = count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        out.p_WProxy[i] = in.tools.tools[i].p_WT;
    const core::ToolState& tool = in.tools.tools[0];
    // A pose that is not a number touches nothing; the supervisor deals with the sample.
    const bool usable = count > 0 && tool.p_WT.allFinite() && tool.v_WT.allFinite();
    ComparedResponse felt;
    m_place = -1;
    if (usable && exploring())
        felt = respondAll(tool, in.dampingBudget_Ns_per_m[0], out);
    else
        for (ComparedObject& object : m_objects)
            object.release();
    if (m_parameters.control == ComparisonControl::gain) {
        out.tissue.tools[0].force *= kControlGain;
        out.load_N[0] *= kControlGain;
    }
    if (felt.touching != m_touching)
        out.events |= felt.touching ? bits::kContactBegan : bits::kContactEnded;
    m_touching = felt.touching;
    fillQuantities(felt, usable ? tool : core::ToolState{}, out);
}

/// A graze does not count, nor does an object that was only held: where the study asks for a force, the force
/// has to be reached while forces are rendered.
bool ComparisonScene::countsAsTouched(const ComparedResponse& response) const noexcept {
    if (!response.touching || m_course.phase() != TrialPhase::running)
        return false;
    if (m_parameters.touchedOnceLifted && response.displacement_m <= ComparedObject::kLifted_m)
        return false;
    return m_parameters.probeAtLeast_N <= 0.0 ||
           (!m_paused && response.force.norm() >= m_parameters.probeAtLeast_N);
}

/// Bound on the force of rough pads that have stored as much energy as a smooth one at `force_N`. It rises
/// above that force only where more is pressed than can be felt, from 1.25 to twice the cap (assumptions:
/// beyond the cap, and before pads act together), so that roughness is felt unchanged below; beyond, no force
/// is larger, and a cap on it makes no energy.
double ComparisonScene::boundOn(double force_N) const noexcept {
    constexpr double kFrom = 1.25, kTo = 2.0;
    const double t = std::clamp((force_N / m_parameters.maximumForce_N - kFrom) / (kTo - kFrom), 0.0, 1.0);
    return force_N * (1.0 + (m_steepest - 1.0) * t * t * (3.0 - 2.0 * t));
}

/// Lets all places respond and sums their forces. Returns the response of the place that is felt most.
ComparedResponse ComparisonScene::respondAll(const core::ToolState& tool, double mostDamping_Ns_per_m,
                                             SceneOutput& out) noexcept {
    DampingBudget budget(mostDamping_Ns_per_m);
    ComparedResponse felt;
    const std::span objects(m_objects.data(), static_cast<std::size_t>(m_parameters.places));
    const auto holds = [&] { return std::ranges::any_of(objects, &ComparedObject::held); };
    double most_N = -1.0, load_N2 = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_parameters.places); ++i) {
        const ComparedResponse response = m_objects[i].respond(tool.p_WT, tool.v_WT, budget.left_Ns_per_m(),
                                                               !m_parameters.liftsOne() || !holds());
        budget.spend(response.damping_Ns_per_m);
        out.tissue.tools[0].force += response.force;
        out.storedEnergy_J += response.energy_J;
        load_N2 += response.load_N2;
        out.contactStiffness_N_per_m =
            m_parameters.padSlope > 0.0 // several may be touched between them
                ? out.contactStiffness_N_per_m + response.stiffness_N_per_m
                : std::max(out.contactStiffness_N_per_m, response.stiffness_N_per_m);
        out.contact[0] |= response.contact;
        if (response.touching && response.depth_m > kCheckedContactDepth_m)
            out.contact[0] |= core::contact_bits::kBeyondChecked;
        const double force_N = response.force.norm();
        if (!(response.touching || response.held) || force_N <= most_N)
            continue;
        most_N = force_N;
        felt = response;
        m_place = static_cast<int>(i);
        out.p_WProxy[0] = response.surfacePoint;
        if (countsAsTouched(response))
            m_touched |= 1u << i;
    }
    out.damping_Ns_per_m[0] = budget.used_Ns_per_m();
    out.load_N[0] = m_steepest > 1.0 ? boundOn(std::sqrt(load_N2)) : 0.0;
    return felt;
}

void ComparisonScene::fillQuantities(const ComparedResponse& felt, const core::ToolState& tool,
                                     SceneOutput& out) const noexcept {
    namespace q = comparison_quantity;
    out.quantities[q::kPlace] = m_place + 1;
    if (m_begun) {
        out.quantities[q::kCandidate] = m_word.candidate + 1;
        out.quantities[q::kArrangement] = m_word.arrangement + 1;
    }
    out.quantities[q::kAnswer] = m_answered + 1;
    out.quantities[q::kTouched] = m_touched;
    out.quantities[q::kDisplacement] = felt.displacement_m;
    out.quantities[q::kDepth] = felt.depth_m;
    for (std::size_t axis = 0; axis < 3; ++axis)
        out.quantities[q::kVelocity + axis] = tool.v_WT[static_cast<Eigen::Index>(axis)];
}

void ComparisonScene::fillCues(SceneOutput& out) const noexcept {
    core::VisibleCues& cues = out.cues;
    core::LaparoscopyCues& own = cues.exercise.own<core::LaparoscopyCues>();
    own.present = true;
    if (!m_course.present())
        return;
    if (m_course.phase() == TrialPhase::running && m_exploreTicks > 0 && !freely())
        cues.timeLeft_s = static_cast<double>(m_exploreTicks - std::min(m_course.clock(), m_exploreTicks)) *
                          core::kTickSeconds;
    if (!m_showsObjects || !exploring())
        return;
    own.objectShown = true;
    own.bodies = m_parameters.places;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_parameters.places); ++i) {
        core::BodyCue& body = own.body[i]; // all alike, and drawn at their places whatever is done to them
        const GripZone grip = gripZone(m_parameters);
        body.p_W = {placeX_m(m_parameters, static_cast<int>(i)), 0.0, grip.height_m};
        body.radius_m = isHooked(m_parameters.attribute) ? grip.radius_m : m_parameters.padRadius_m;
        body.heldBy = m_place == static_cast<int>(i) ? 1 : 0;
    }
}

} // namespace chiron::simulation
