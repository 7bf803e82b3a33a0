// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "core/visible_cues.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/operators/evidence_map.h"
#include "modules/exercises/palpation/operators/finger_order.h"
#include "modules/exercises/palpation/operators/palpation_operator.h"
#include "modules/exercises/palpation/operators/palpation_operator_settings.h"
#include "modules/exercises/palpation/operators/press.h"
#include "modules/exercises/palpation/operators/search_path.h"
#include "simulation/palpation/tissue_surface.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::operators {

/// The strategy of one scripted palpator, shared by all its fingers. It rests above the tissue until a trial
/// runs and force is fully on. Then its hands press spot after spot of the search area, each hand its share.
/// It evaluates what was felt (EvidenceMap), returns to suspicious places, evaluates again, marks what
/// exceeds its criterion, rates it as asked, and reports that it is done. It knows only what it was told
/// (PalpationBriefing), what its fingers felt (FingerSenses) and what the screen shows.
/// Thread: haptic; allocates nothing.
class PalpationTrainee {
public:
    static constexpr std::size_t kMostTools = 4;

    PalpationTrainee(const PalpationOperatorSettings& settings, const PalpationBriefing& briefing,
                     std::uint64_t seed);

    void wake(std::size_t tool, const core::Vec3& place_W) noexcept;
    void felt(std::size_t tool, const Press& press) noexcept;
    /// Call in every tick for each finger, with the position that the finger wants of its hand. The last
    /// finger's call makes decisions, 100 times a second.
    void hear(std::size_t tool, double now_s, const core::VisibleCues& cues,
              const core::Vec3& wanted_W) noexcept;
    const FingerOrder& order(std::size_t tool) const noexcept { return m_orders[tool]; }

    enum class Doing { rest, search, suspect, revisit, decide, report, done };
    Doing doing() const noexcept { return m_doing; }
    std::size_t presses() const noexcept { return m_map.presses(); }

private:
    static constexpr std::size_t kMostFindings = 6;
    /// Values of m_word; then kMark + ReportField.
    static constexpr int kRise = -3, kOver = -2, kHover = -1, kMark = 0;
    struct Hand {
        enum class Step { idle, rise, over, hover, down, hold, up };
        Step step = Step::idle;
        core::Vec2 spot_m = core::Vec2::Zero(); ///< actual target of its first finger
        int pressure = 0;
        double deep = 1.0; ///< depth of this press over the usual depth
        double since_s = 0.0;
        double intended_m = 0.0; ///< depth of the press last attended to
        SearchPath path;
    };

    void think() noexcept;
    void beginTrial() noexcept;
    void begin(Doing doing) noexcept;
    void keepAway() noexcept;
    void search() noexcept;
    void weigh() noexcept;
    void suspect(const Suspicion& found) noexcept;
    void decide(const Suspicion& found) noexcept;
    bool normalThere(const core::Vec2& place_m) const noexcept;
    void leaveOut(const Suspicion& found) noexcept;
    void takeWhatIsSeen() noexcept;
    void planRevisits() noexcept;
    bool nextSpot(std::size_t hand, core::Vec2& spot_m) noexcept;

    bool moveHands(bool newSpots) noexcept; ///< returns false when all hands are idle
    void moveHand(std::size_t hand, bool newSpots) noexcept;
    void startSpot(std::size_t hand, const core::Vec2& spot_m) noexcept;
    void startDown(std::size_t hand) noexcept;
    void startHold(std::size_t hand) noexcept;
    void enter(Hand& hand, Hand::Step step) noexcept;
    void send(std::size_t hand, const core::Vec2& spot_m, double height_m, double speed_m_per_s) noexcept;
    void rise(std::size_t hand) noexcept;
    bool there(std::size_t hand, double within_m) const noexcept;
    bool inside(const core::Vec2& spot_m) const noexcept;
    double depth_m(const Hand& hand) const noexcept;

    void report() noexcept;
    void goToMark(std::size_t hand) noexcept;
    void aimAtFinding() noexcept;
    /// True once the button has been pressed and released.
    bool pressed(std::size_t tool, std::uint32_t buttons) noexcept;
    std::uint32_t wordAbout(const Suspicion& found, int word) const noexcept; ///< 0: not asked for

    std::size_t tools() const noexcept {
        return static_cast<std::size_t>(m_briefing.hands * m_briefing.fingers);
    }
    std::size_t fingers() const noexcept { return static_cast<std::size_t>(m_briefing.fingers); }
    std::size_t hands() const noexcept { return static_cast<std::size_t>(m_briefing.hands); }
    std::size_t firstFinger(std::size_t hand) const noexcept { return hand * fingers(); }
    std::size_t handFor(const core::Vec2& place_m) const noexcept;
    SearchShare shareOf(std::size_t hand) const noexcept;

    PalpationOperatorSettings m_settings;
    PalpationBriefing m_briefing;
    simulation::TissueSurface m_surface;
    core::Random m_random;
    EvidenceMap m_map;
    std::array<FingerOrder, kMostTools> m_orders{};
    std::array<core::Vec3, kMostTools> m_wanted_W{};
    std::array<Hand, 2> m_hands{};
    bool m_rightFirst = false; ///< hand 0 stands on the side of larger x

    core::VisibleCues m_cues;
    double m_now_s = 0.0;
    int m_ticks = 0;
    double m_began_s = 0.0; ///< when the present stage began
    double m_limit_s = 0.0; ///< time limit of this trial, as shown at its beginning
    bool m_weighing = false;
    Doing m_doing = Doing::rest;
    double m_trialBegan_s = 0.0;
    std::uint16_t m_trial = 0;

    double m_yield_m_per_N; ///< indentation per newton, learned
    int m_learned = 0;      ///< number of presses from which it was learned

    std::size_t m_suspected = 0;
    std::array<Suspicion, kMostFindings> m_suspicions{};
    std::size_t m_spots = 0; ///< number of spots of the revisit
    std::size_t m_nextSpot = 0;
    std::array<core::Vec2, kMostFindings * 5> m_revisit{};

    std::size_t m_found = 0;
    std::array<Suspicion, kMostFindings> m_findings{};
    std::array<double, kMostFindings> m_seenRadius_m{}; ///< as shown on the screen; 0 where it is not shown
    std::size_t m_reporting = 0;                        ///< index of the finding that is being reported
    int m_word = kRise; ///< stage of the report: on the way, the mark, the ratings
    core::Vec2 m_aim_m = core::Vec2::Zero();
    bool m_pressing = false; ///< holds a button down
    double m_since_s = 0.0;  ///< when it pressed the button or arrived
};

} // namespace chiron::operators
