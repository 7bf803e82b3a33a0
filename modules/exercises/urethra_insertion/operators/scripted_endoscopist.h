// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_strategy.h"
#include "modules/exercises/urethra_insertion/operators/endoscope_reach.h"
#include "modules/exercises/urethra_insertion/operators/endoscope_senses.h"
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator_settings.h"
#include "modules/exercises/urethra_insertion/operators/way_memory.h"

#include <cstdint>

namespace chiron::operators {

/// The strategy of one scripted endoscopist. It holds still until a trial runs and force is fully on. Then it
/// advances and steers by where it sees the lumen, and yields to the forces that it feels as far as that is
/// its habit. In the bladder it holds the tip, turns to each landmark that the picture shows (or searches for
/// it) and keeps still. Then it withdraws by its memory of the way in. It knows only what the screen shows
/// and what the hand feels, through EndoscopeSenses; it knows neither canal nor bladder.
/// Thread: haptic; allocates nothing after construction.
class ScriptedEndoscopist final : public mechanisms::HandStrategy {
public:
    ScriptedEndoscopist(const UrethraInsertionOperatorSettings& settings, std::uint64_t seed);
    ~ScriptedEndoscopist() override;
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override;

    enum class Doing { rest, insert, back, inspect, align, withdraw };
    Doing doing() const noexcept { return m_doing; }

private:
    void think(const EndoscopePercept& felt) noexcept;
    void smooth(const EndoscopePercept& felt) noexcept;
    Doing next(const EndoscopePercept& felt) const noexcept;
    bool isStuck(const EndoscopePercept& felt) const noexcept;
    bool drawsBack(const EndoscopePercept& felt) const noexcept;
    void begin(Doing doing, const EndoscopePercept& felt) noexcept;
    EndoscopeWish act(const EndoscopePercept& felt) noexcept;
    EndoscopeWish insert(const EndoscopePercept& felt) noexcept;
    EndoscopeWish steer(const EndoscopePercept& felt) noexcept;
    EndoscopeWish followCurve(const SeenThing& lumen) const noexcept;
    EndoscopeWish centreLate(const SeenThing& lumen) noexcept;
    EndoscopeWish inspect(const EndoscopePercept& felt) noexcept;
    EndoscopeWish turnTo(const SeenThing& landmark) const noexcept;
    EndoscopeWish search(const EndoscopePercept& felt) const noexcept;
    EndoscopeWish align(const EndoscopePercept& felt, double depth_m) const noexcept;
    EndoscopeWish withdraw(const EndoscopePercept& felt) const noexcept;
    void giveWay(EndoscopeWish& wish) const noexcept;
    double ease() const noexcept; ///< 0..1: share of its speed that it keeps under the felt force
    /// Rate of turning towards something that is off by this angle.
    double turning(double rad) const noexcept;
    double since(const EndoscopePercept& felt) const noexcept { return felt.time_s - m_began_s; }

    UrethraInsertionOperatorSettings m_settings;
    EndoscopeSenses m_senses;
    EndoscopeReach m_reach;
    WayMemory m_way;
    Doing m_doing = Doing::rest;
    double m_began_s = 0.0;
    double m_along_N = 0.0, m_across_N = 0.0; ///< felt, smoothed
    double m_pitchTorque_Nm = 0.0, m_yawTorque_Nm = 0.0;
    double m_up_rad = 0.0, m_left_rad = 0.0; ///< direction of the lumen, smoothed
    bool m_turns = false;                    ///< has stopped to turn, or turns late
    /// centresLate: angle upwards to which it wants to bring the lumen.
    double m_turnsTo_rad = 0.0;
    double m_deepest_m = -1.0;
    double m_progress_s = 0.0; ///< time of the last gain in depth
    double m_neutralYaw_rad = 0.0;
    double m_neutralPitch_rad = 0.0; ///< desired pitch when the inspection began
    double m_lastSeen_s = 0.0;       ///< time at which a landmark was last in the picture
    std::uint32_t m_landmarksSeen = 0;
    double m_landmarkBegan_s = 0.0;
    double m_lookWithin_rad = 0.0;
};

} // namespace chiron::operators
