// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "modules/exercises/object_handling/operators/object_handling_operator.h"
#include "modules/exercises/object_handling/operators/weight_memory.h"
#include "operators/laparoscopy/laparoscopy_mind.h"

#include <cstdint>

namespace chiron::operators {

/// The strategy of one scripted laparoscopist at object handling. It rests until a trial runs and force is
/// fully on. Then it moves over an object, lowers the open jaws around it, closes them until the squeeze
/// looks right, lifts, carries and sets down. Of several objects it lifts each, feels how heavy it is, and
/// brings the one that felt heaviest. It picks up again, more firmly, what has slipped out. It knows only
/// what it was told (ObjectHandlingBriefing), what its hand feels and what the screen shows, through
/// GraspSenses.
/// Thread: haptic; allocates nothing.
class HandlingTrainee final : public LaparoscopyMind {
public:
    HandlingTrainee(const ObjectHandlingOperatorSettings& settings, const ObjectHandlingBriefing& briefing,
                    std::uint64_t seed);
    ~HandlingTrainee() override;
    void think(const GraspLook& felt, GraspWishes& wishes) noexcept override;

    enum class Doing { rest, over, lower, close, lift, weigh, carry, setDown, letGo, leave };
    Doing doing() const noexcept { return m_doing; }

private:
    void notice(const GraspPercept& felt) noexcept;
    void beginTrial(const GraspPercept& felt) noexcept;
    void begin(Doing doing, double now_s) noexcept;
    void choose() noexcept; ///< decides which object is next, and for what purpose
    void act(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept;
    void rest(GraspWish& wish) noexcept;
    void over(const GraspPercept& felt, GraspWish& wish) noexcept;
    void lower(const GraspPercept& felt, GraspWish& wish) noexcept;
    void close(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept;
    void lift(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept;
    void weigh(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept;
    void carry(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept;
    void setDown(const GraspPercept& felt, double jaw_rad, GraspWish& wish) noexcept;
    void letGo(const GraspPercept& felt, GraspWish& wish) noexcept;
    void leave(const GraspPercept& felt, GraspWish& wish) noexcept;

    bool holds(const GraspPercept& felt) const noexcept;
    bool lostIt(const GraspPercept& felt) noexcept;
    void squeeze(const GraspPercept& felt, double jaw_rad, GraspWish& wish) const noexcept;
    double wrongSqueeze_N(const GraspPercept& felt) const noexcept;
    double wantedSqueeze_N(const core::LaparoscopyCues& screen) const noexcept;
    double openJaw(double radius_m) const noexcept;
    core::Vec3 object(const GraspPercept& felt) const noexcept;
    double since(const GraspPercept& felt) const noexcept { return felt.time_s - m_began_s; }

    ObjectHandlingOperatorSettings m_settings;
    ObjectHandlingBriefing m_briefing;
    Doing m_doing = Doing::rest;
    double m_began_s = 0.0;
    double m_decided_s = -1.0;
    bool m_awake = false;
    core::Vec3 m_home = core::Vec3::Zero();
    core::Vec3 m_place = core::Vec3::Zero(); ///< smoothed
    double m_up_N = 0.0;                     ///< felt upward force, smoothed over 0.1 s
    double m_slowUp_N = 0.0;                 ///< … and over a second
    double m_free_N = 0.0;                   ///< felt upward force before it took hold of anything
    WeightMemory m_weights;
    std::size_t m_object = 0; ///< the object that it wants
    bool m_deciding = false;  ///< it is still weighing
    int m_rounds = 1;
    core::Vec3 m_grip = core::Vec3::Zero(); ///< where it took hold
    core::Vec3 m_from = core::Vec3::Zero(); ///< where the object lay
    /// Offset of the object's centre from the tip, as it looked when carrying began.
    core::Vec3 m_hold = core::Vec3::Zero();
    core::Vec3 m_to = core::Vec3::Zero(); ///< where the tip has to be to set the object down
    double m_firmness = 1.0;
    double m_thereSince_s = -1.0;
};

} // namespace chiron::operators
