// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/palpation_trainee.h"

#include "core/units.h"
#include "modules/exercises/palpation/cues/report_word.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec2;
using simulation::ReportField;

namespace {
// Habits that all operators share: assumptions.
constexpr double kPressed_s = 0.06; ///< how long it presses a button
constexpr double kLetGo_s = 0.08;   ///< pause before the next press of a button
/// Time over a place before it marks it, because the hand follows a reaction delay later.
constexpr double kSettle_s = 0.35;
constexpr double kMarkHeight_m = 0.003;
constexpr double kNear_m = 0.0008;
constexpr double kPad_m = 0.005;       ///< it knows the radius of its finger pad
constexpr double kUsualHardness = 1.7; ///< (m − 1)/(1 + 0.4(m − 1)) of the lumps met so far: assumption
/// Felt stiffness over χ (models.md §3), because pressing brings the finger nearer to the lump.
constexpr double kUnderDepth = 1.2;
/// Amounts of evidence above the criterion; each one exceeded raises the confidence by one.
constexpr double kSurer[] = {0.7, 1.5, 2.5, 4.0};

/// Estimates the radius by the law of models.md §3, in the middle: χ = (8/π) a R³/H⁴ · f(m). A small hard
/// lump feels like a bigger soft one.
double feltRadius(const Suspicion& found) {
    const double chi = std::max(found.amplitude, 0.0) / kUnderDepth;
    const double width2 = found.width_m * found.width_m;
    return std::cbrt(chi * core::kPi * width2 * width2 / (8.0 * kPad_m * kUsualHardness));
}
} // namespace

std::uint32_t PalpationTrainee::wordAbout(const Suspicion& found, int word) const noexcept {
    const auto say = [](ReportField field, long value) {
        return core::reportButtons(simulation::reportWord(field, static_cast<unsigned>(value)));
    };
    if (word == kMark)
        return core::kButtonMark;
    const auto field = static_cast<ReportField>(word);
    if (field == ReportField::size && m_briefing.asksSize) {
        const double seen = m_seenRadius_m[m_reporting];
        return say(field, std::clamp(std::lround(1e4 * (seen > 0.0 ? seen : feltRadius(found))), 10L, 300L));
    }
    if (field == ReportField::hardness && m_briefing.asksHardness)
        return say(field, std::clamp(std::lround(1.0 + 8.0 * found.amplitude), 1L, 5L));
    if (field == ReportField::confidence && m_briefing.asksConfidence) {
        long sure = 1;
        for (const double more : kSurer)
            sure += found.evidence - m_settings.criterion > more ? 1 : 0;
        return say(field, sure);
    }
    return 0;
}

bool PalpationTrainee::pressed(std::size_t tool, std::uint32_t buttons) noexcept {
    if (!m_pressing && m_now_s >= m_since_s + kLetGo_s) {
        m_pressing = true;
        m_since_s = m_now_s;
        m_orders[tool].buttons = buttons;
    } else if (m_pressing && m_now_s >= m_since_s + kPressed_s) {
        m_pressing = false;
        m_since_s = m_now_s;
        m_orders[tool].buttons = 0;
        return true;
    }
    return false;
}

/// Aims at a finding; it sees its finger and the drawn surface with the error of its sight.
void PalpationTrainee::aimAtFinding() noexcept {
    m_word = kRise;
    if (m_reporting >= m_found)
        return;
    const double sd = std::hypot(m_settings.perception.hand.visionNoiseSd_m, m_settings.aimSd_m);
    m_aim_m = m_findings[m_reporting].place_m + Vec2(sd * m_random.normal(), sd * m_random.normal());
    m_aim_m = m_aim_m.cwiseMax(-m_briefing.areaHalf_m).cwiseMin(m_briefing.areaHalf_m);
}

void PalpationTrainee::goToMark(std::size_t hand) noexcept {
    if (m_word == kRise) {
        rise(hand);
    } else {
        send(hand, m_aim_m, kMarkHeight_m, m_settings.reachSpeed_m_per_s);
        if (m_word == kOver)
            for (std::size_t tool = firstFinger(hand); tool < firstFinger(hand) + fingers(); ++tool)
                m_orders[tool].goal_W.z() = m_surface.highest_m() + m_settings.hover_m;
    }
    if (!there(hand, kNear_m)) {
        m_since_s = m_now_s;
    } else if (m_word != kHover || m_now_s >= m_since_s + kSettle_s) {
        ++m_word;
        m_since_s = m_now_s;
    }
}

/// Goes to each finding, marks it and states what is asked; at the end it reports that there are no more.
void PalpationTrainee::report() noexcept {
    if (m_reporting >= m_found) {
        if (pressed(0, core::reportButtons(simulation::reportWord(ReportField::done, 0))))
            begin(Doing::done);
        return;
    }
    const Suspicion& found = m_findings[m_reporting];
    const std::size_t hand = handFor(m_aim_m);
    if (m_word < kMark)
        return goToMark(hand);
    while (m_word <= static_cast<int>(ReportField::confidence) && wordAbout(found, m_word) == 0)
        ++m_word;
    if (m_word > static_cast<int>(ReportField::confidence)) {
        ++m_reporting;
        return aimAtFinding();
    }
    if (pressed(firstFinger(hand), wordAbout(found, m_word)))
        ++m_word;
}

} // namespace chiron::operators
