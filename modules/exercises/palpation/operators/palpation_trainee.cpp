// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/palpation_trainee.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec2;
using core::Vec3;

namespace {
// Habits that all operators share: assumptions.
constexpr int kTicksPerThought = 10;
/// Places of the map per tick of the evaluation: about a quarter of a second in all.
constexpr int kPlacesATick = 4;
constexpr double kLastPress_s = 0.30; ///< time after which the last press has been felt
constexpr double kDeeper_s = 0.13;    ///< time from one pressure to the next
constexpr double kReport_s = 12.0;    ///< time reserved for the report
constexpr double kNoLimit_s = 60.0;   ///< time that it assumes where the screen shows no limit
constexpr int kSoonLearned = 5;       ///< presses until it knows how hard it has to press this tissue
/// Relative error of seen lengths (Ono 1967, Percept Psychophys 2:201).
constexpr double kSeenSd = 0.025;
constexpr double kCertain = 99.0;
} // namespace

void PalpationTrainee::wake(std::size_t tool, const Vec3& place_W) noexcept {
    m_wanted_W[tool] = place_W;
    m_orders[tool] = {};
    m_orders[tool].goal_W = place_W;
}

void PalpationTrainee::hear(std::size_t tool, double now_s, const core::VisibleCues& cues,
                            const Vec3& wanted_W) noexcept {
    m_wanted_W[tool] = wanted_W;
    if (tool + 1 != tools())
        return;
    if (m_weighing && m_map.advance(kPlacesATick))
        m_weighing = false;
    if (++m_ticks % kTicksPerThought != 0)
        return;
    m_now_s = now_s;
    m_cues = cues;
    think();
}

/// Stores the press, and learns how far to press for the wanted force: quickly at first, then slowly.
void PalpationTrainee::felt(std::size_t tool, const Press& press) noexcept {
    if (m_doing == Doing::rest || m_doing == Doing::done)
        return;
    const bool first = tool % fingers() == 0;
    if (!first && !press.touched) // the other finger carried the hand, so this press says nothing
        return;
    m_map.add(press);
    if (!first)
        return;
    const double intended = m_hands[tool / fingers()].intended_m;
    const double yield = intended / std::max(press.force_N, 0.05);
    const bool learning = m_learned < kSoonLearned;
    const double most = learning ? 0.7 : 0.2;
    m_yield_m_per_N *=
        std::exp((learning ? 0.6 : 0.05) * std::clamp(std::log(yield / m_yield_m_per_N), -most, most));
    m_yield_m_per_N = std::clamp(m_yield_m_per_N, 1.0 / 5000.0, 1.0 / 150.0);
    ++m_learned;
}

void PalpationTrainee::think() noexcept {
    const bool running = m_cues.phase == core::TrialPhase::running;
    if (!running || (m_doing == Doing::done && m_cues.trial == m_trial)) {
        if (!running)
            begin(Doing::rest);
        return keepAway();
    }
    if (m_cues.force != core::ForceState::on)
        return keepAway();
    if (m_doing == Doing::rest || m_cues.trial != m_trial)
        beginTrial();
    switch (m_doing) {
    case Doing::rest:
    case Doing::done:
        return keepAway();
    case Doing::search:
    case Doing::revisit:
        return search();
    case Doing::suspect:
    case Doing::decide:
        moveHands(false);
        return weigh();
    case Doing::report:
        return report();
    }
}

void PalpationTrainee::begin(Doing doing) noexcept {
    if (doing == m_doing)
        return;
    m_doing = doing;
    m_began_s = m_now_s;
    if (doing == Doing::suspect || doing == Doing::decide) {
        m_map.forgetExplained();
        m_suspected = m_found = 0;
        m_weighing = false;
    }
    if (doing == Doing::report) {
        m_reporting = 0;
        aimAtFinding();
    }
}

void PalpationTrainee::beginTrial() noexcept {
    m_trial = m_cues.trial;
    m_limit_s = m_cues.timeLeft_s > 0.0 ? m_cues.timeLeft_s : kNoLimit_s;
    m_trialBegan_s = m_now_s;
    m_map.clear();
    m_seenRadius_m.fill(0.0);
    m_pressing = false;
    m_spots = m_nextSpot = 0;
    const double spot_s =
        m_settings.pressTime_s + (m_settings.pressures - 1) * (m_settings.hold_s + kDeeper_s);
    const int most = static_cast<int>(m_settings.searchShare * m_limit_s / spot_s);
    for (std::size_t hand = 0; hand < hands(); ++hand) {
        m_hands[hand].path.plan(m_settings, shareOf(hand), most, m_random);
        m_hands[hand].step = Hand::Step::idle;
    }
    begin(Doing::search);
}

/// Searches until spots or time are used up.
void PalpationTrainee::search() noexcept {
    const bool revisit = m_doing == Doing::revisit;
    const double left = m_cues.timeLeft_s > 0.0 ? m_cues.timeLeft_s : m_trialBegan_s + m_limit_s - m_now_s;
    const bool late = revisit ? left < kReport_s : left < (1.0 - m_settings.searchShare) * m_limit_s;
    if (!moveHands(!late))
        begin(revisit || m_settings.revisits == 0 ? Doing::decide : Doing::suspect);
}

/// Once the last press has been felt, finds the most suspicious place, and then the next ones beside it.
void PalpationTrainee::weigh() noexcept {
    if (m_weighing || m_now_s < m_began_s + kLastPress_s)
        return;
    if (m_began_s >= 0.0) { // the first evaluation of this stage
        m_began_s = -1.0;
        if (m_doing == Doing::decide && m_cues.exercise.of<simulation::PalpationCues>().lumps > 0)
            return takeWhatIsSeen();
        m_map.begin();
        m_weighing = true;
        return;
    }
    const Suspicion found = m_map.strongest();
    if (m_doing == Doing::suspect)
        suspect(found);
    else
        decide(found);
}

/// Returns true if the instruction says that firmness at this place is normal.
bool PalpationTrainee::normalThere(const Vec2& place_m) const noexcept {
    for (const simulation::StiffRegion& region : m_briefing.normal) {
        const Vec2 away = Eigen::Rotation2Dd(-region.turn_rad) * (place_m - region.centre_m);
        if (away.cwiseQuotient(region.radii_m).squaredNorm() < 1.0)
            return true;
    }
    return false;
}

void PalpationTrainee::leaveOut(const Suspicion& found) noexcept {
    m_map.explain(found);
    m_map.begin();
    m_weighing = true;
}

void PalpationTrainee::suspect(const Suspicion& found) noexcept {
    const auto most = std::min(kMostFindings, static_cast<std::size_t>(m_settings.revisits));
    if (found.evidence >= m_settings.revisitAbove && m_suspected < most && !m_map.explainedAll()) {
        if (!normalThere(found.place_m))
            m_suspicions[m_suspected++] = found;
        return leaveOut(found);
    }
    planRevisits();
    begin(Doing::revisit);
}

void PalpationTrainee::decide(const Suspicion& found) noexcept {
    if (found.evidence >= m_settings.criterion && m_found < kMostFindings && !m_map.explainedAll()) {
        if (!normalThere(found.place_m))
            m_findings[m_found++] = found;
        return leaveOut(found);
    }
    begin(Doing::report);
}

/// Where the level shows its lumps, it marks what it sees; it takes their hardness from what it felt.
void PalpationTrainee::takeWhatIsSeen() noexcept {
    m_map.begin();
    const auto& shown = m_cues.exercise.of<simulation::PalpationCues>();
    const auto seen = std::min(kMostFindings, static_cast<std::size_t>(shown.lumps));
    for (m_found = 0; m_found < seen; ++m_found) {
        const simulation::LumpCue& lump = shown.lump[m_found];
        const Vec3 centre(lump.p_W[0], lump.p_W[1], lump.p_W[2]);
        m_findings[m_found] = m_map.at(m_surface.nearest(centre, centre.head<2>()).p_W.head<2>());
        m_findings[m_found].evidence = kCertain;
        m_seenRadius_m[m_found] = lump.radius_m * (1.0 + kSeenSd * m_random.normal());
    }
    begin(Doing::report);
}

/// Plans the revisits, the strongest suspicion first: its middle and four sides.
void PalpationTrainee::planRevisits() noexcept {
    const double r = m_settings.revisitRadius_m;
    const std::array<Vec2, 5> cross{Vec2(0.0, 0.0), Vec2(r, 0.0), Vec2(-r, 0.0), Vec2(0.0, r), Vec2(0.0, -r)};
    m_spots = m_nextSpot = 0;
    for (std::size_t i = 0; i < m_suspected; ++i)
        for (const Vec2& away : cross)
            m_revisit[m_spots++] = (m_suspicions[i].place_m + away)
                                       .cwiseMax(-m_briefing.areaHalf_m)
                                       .cwiseMin(m_briefing.areaHalf_m);
}

} // namespace chiron::operators
