// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_strategy.h"
#include "modules/exercises/sphere_apex/operators/apex_technique.h"
#include "modules/exercises/sphere_apex/operators/reach.h"
#include "modules/exercises/sphere_apex/operators/scan_path.h"
#include "modules/exercises/sphere_apex/operators/sphere_apex_operator_settings.h"
#include "operators/hand/senses.h"

#include <cstdint>
#include <memory>

namespace chiron::operators {

/// The strategy of one scripted trainee in the sphere-apex exercise. While no trial runs, or force is not
/// fully on, it lifts its tool and waits. In a trial it lowers the tool to the table, scans lines above the
/// table until it feels something, climbs that by keeping a pressure and following the felt slope, searches
/// for the apex with its technique, moves to where it believes the apex to be, keeps still and presses the
/// button. Where the screen shows the object it goes there by sight. It uses only Percepts and knows neither
/// centre nor radius.
/// Thread: haptic; allocates nothing after construction.
class ScriptedTrainee final : public mechanisms::HandStrategy {
public:
    ScriptedTrainee(const SphereApexOperatorSettings& settings, std::uint64_t seed,
                    std::unique_ptr<ApexTechnique> technique);
    ~ScriptedTrainee() override;
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override;

    enum class Stage { rest, lower, probe, scan, climb, search, approach, settle, press, done };
    Stage stage() const noexcept { return m_stage; }

private:
    void think(const Percept& felt) noexcept;
    void act(const Percept& felt) noexcept;
    void enter(Stage stage, const Percept& felt) noexcept;
    void beginTrial(const Percept& felt) noexcept;
    void rest(const Percept& felt) noexcept;
    void lower(const Percept& felt) noexcept;
    void probe(const Percept& felt) noexcept;
    void touchedTable(double height_m) noexcept;
    void scan(const Percept& felt) noexcept;
    void climb(const Percept& felt) noexcept;
    void search(const Percept& felt) noexcept;
    void startTechnique(const Percept& felt) noexcept;
    void approach(const Percept& felt) noexcept;
    void settle(const Percept& felt) noexcept;
    void press(const Percept& felt) noexcept;

    bool outOfTime(const Percept& felt) const noexcept;
    double since(const Percept& felt) const noexcept { return felt.time_s - m_entered_s; }
    core::Vec2 believedApex(const Percept& felt) const noexcept;
    void moveFreely(const core::Vec2& goal, double height_m, double speed_m_per_s,
                    const Percept& felt) noexcept;
    void moveOnSurface(const core::Vec2& velocity_m_per_s, const Percept& felt) noexcept;

    SphereApexOperatorSettings m_settings;
    Senses m_senses;
    core::Random m_random;
    std::unique_ptr<ApexTechnique> m_technique;
    Reach m_reach;
    ScanPath m_path;
    Stage m_stage = Stage::rest;
    bool m_awake = false;                        ///< has felt its own position
    core::Vec3 m_home = core::Vec3::Zero();      ///< felt, start position
    core::Vec2 m_touchdown = core::Vec2::Zero(); ///< felt, where it lowers the tool
    core::Vec3 m_force = core::Vec3::Zero();     ///< felt, smoothed over 0.1 s: magnitude
    core::Vec2 m_place = core::Vec2::Zero();     ///< felt, smoothed over 0.1 s
    double m_thereFor_s = 0.0;                   ///< time spent at the place that it wants to mark
    core::Vec3 m_lastTouch = core::Vec3::Zero(); ///< felt, where it last touched something
    bool m_steady = false;                       ///< on top and pressing as intended
    bool m_searched = false;                     ///< has searched before in this trial
    core::Vec3 m_lean = core::Vec3::Zero();      ///< felt force, smoothed over 0.25 s: direction
    /// Felt height of the table; first derived from the start height, then as touched.
    double m_table_m = 0.0;
    bool m_tableTouched = false; ///< in this trial
    double m_cameDown_m = 0.0;   ///< felt height at which it came down in this trial
    double m_climbFrom_m = 0.0;  ///< felt height at which it began to climb
    double m_scanHeight_m = 0.0;
    double m_pressGoal_m = 0.0; ///< desired height while a depth is held
    double m_lostFor_s = 0.0;   ///< time without touch
    double m_flatFor_s = 0.0;   ///< time on a gentle slope while climbing
    double m_topHeight_m = 0.0; ///< felt height at which the search began
    double m_trialBegan_s = 0.0;
    double m_entered_s = 0.0;
    std::uint32_t m_buttons = 0;
};

} // namespace chiron::operators
