// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of what studies present side by side, which is a task and not an exercise.
#include "sweep/sweep_facts.h"

#include "core/units.h"
#include "simulation/attributes/contact_damping.h"
#include "simulation/comparison/compared_object.h"
#include "simulation/comparison/comparison_parameters.h"
#include "simulation/comparison/comparison_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::ComparedAttribute;
using simulation::ComparisonParameters;
using simulation::SceneInput;
using simulation::SceneOutput;

/// The largest value of the attribute that may be presented.
double largestOf(const ComparisonParameters& p) {
    double largest = 0.0;
    for (const auto& candidate : p.values)
        largest = std::max(largest, *std::max_element(candidate.begin(), candidate.end()));
    return largest;
}

double smallestOf(const ComparisonParameters& p) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto& candidate : p.values)
        smallest = std::min(smallest, *std::min_element(candidate.begin(), candidate.end()));
    return smallest;
}

/// What a tool does with one object on its bed, by where its tip goes: the object is taken hold of at its
/// ring, set down where it was lifted, pressed and released, and comes off where it was pressed too hard. A
/// force on its bed beyond its weight does not depend on its mass.
class TrueGrip {
public:
    void forget() { *this = {}; }
    bool mayAct() const { return m_held || m_unsure; }
    bool holds() const { return m_held; }
    /// `mayTake`: the tool holds no other object. Where it passes a ring and may not take it, it may have let
    /// go of the other one a moment before.
    void follow(const ComparisonParameters& p, const Vec3& ring, const core::ToolState& tool, bool mayTake) {
        const double away_m = (tool.p_WT - ring).norm();
        meet(away_m, p.hookReach_m);
        meet(away_m, p.hookLeave_m);
        if (!m_held) {
            m_awayFirst = m_awayFirst && away_m <= p.hookLeave_m;
            const bool taken = !m_awayFirst && away_m <= p.hookReach_m;
            m_unsure = m_unsure || (taken && !mayTake);
            if (taken && mayTake)
                take(tool.p_WT.z());
            return;
        }
        const double lift_m = tool.p_WT.z() - m_taken_m;
        const double bed_N = -std::max(1.0, p.object.stiffness_N_per_m) * lift_m;
        const double faded = std::clamp(-lift_m / simulation::ContactDamping::kFullDepth_m, 0.0, 1.0);
        const double pressed_N = bed_N - p.object.damping_Ns_per_m * faded * tool.v_WT.z();
        meet(lift_m, simulation::ComparedObject::kLifted_m);
        meet(bed_N, simulation::ComparedObject::kPress_N);
        meet(pressed_N, p.yield.force_N);
        m_lifted = m_lifted || lift_m > simulation::ComparedObject::kLifted_m;
        m_pressed = m_lifted && (m_pressed || bed_N > simulation::ComparedObject::kPress_N);
        if (m_pressed)
            meet(lift_m, 0.0);
        m_falls_ticks += m_falls_ticks > 0 || pressed_N > p.yield.force_N ? 1 : 0;
        m_left = m_falls_ticks > 0 && (m_left || away_m > p.hookLeave_m);
        constexpr double kRounding_ticks = 2.0;
        const bool fallen = m_falls_ticks > p.yield.fall_s / core::kTickSeconds + kRounding_ticks;
        if ((m_pressed && lift_m >= 0.0) || fallen)
            comeOff();
    }

private:
    /// Where the tip passes a bound by no more than rounding, nobody knows on which side it was.
    void meet(double value, double bound) {
        constexpr double kRounding = 1e-9;
        m_unsure = m_unsure || std::abs(value - bound) < kRounding;
    }
    void take(double height_m) {
        m_held = true;
        m_lifted = m_pressed = m_left = false;
        m_falls_ticks = 0;
        m_taken_m = height_m;
    }
    void comeOff() {
        m_held = false;
        m_awayFirst = !m_left;
    }
    double m_taken_m = 0.0; ///< height of the tip when it took hold
    int m_falls_ticks = 0;  ///< since it was pressed too hard
    bool m_held = false, m_lifted = false, m_pressed = false;
    bool m_awayFirst = false; ///< the tip has to leave before it takes hold again
    bool m_left = false;      ///< it did so while the force fell
    bool m_unsure = false;
};

/// Tubes that are slack within their length about their foot, objects that are taken hold of at their ring,
/// pads.
class TrueObjects final : public TrueContact {
public:
    explicit TrueObjects(const ComparisonParameters& p)
        : m_p(p), m_rise_m(roughRise_m(p.attribute == ComparedAttribute::roughness ? largestOf(p)
                                                                                   : p.object.roughness_m)) {}
    void follow(const SceneInput& in, const SceneOutput& out) override {
        const core::ToolState& tool = in.tools.tools[0];
        for (int i = 0; i < m_p.places; ++i)
            if (isTube())
                followTube(i, tool.p_WT);
            else if (objectsPresent(out))
                m_grips[static_cast<std::size_t>(i)].follow(m_p, ringOf(i), tool, !holdsAny());
            else
                m_grips[static_cast<std::size_t>(i)].forget();
    }
    double clearance_m(std::size_t tool, const SceneInput& in, const SceneOutput& out) override {
        double clear_m = kNothing_m;
        if (tool != 0 || !objectsPresent(out))
            return clear_m;
        const Vec3& p = in.tools.tools[0].p_WT;
        for (int i = 0; i < m_p.places; ++i)
            clear_m = std::min(clear_m, clearanceOf_m(i, p));
        return clear_m;
    }

private:
    void followTube(int place, const Vec3& p) {
        bool& may = m_mayHold[static_cast<std::size_t>(place)];
        const double away_m = (p - ringOf(place)).norm();
        if (away_m <= m_p.hookReach_m)
            may = true;
        else if (slackOf_m(place, p) >= 0.0 && away_m > m_p.hookLeave_m)
            may = false;
    }
    double clearanceOf_m(int place, const Vec3& p) const {
        const auto i = static_cast<std::size_t>(place);
        if (!simulation::isHooked(m_p.attribute))
            return abovePad_m(place, p);
        if (isTube())
            return m_mayHold[i] ? slackOf_m(place, p) : kNothing_m;
        return m_grips[i].mayAct() ? -1.0 : kNothing_m;
    }
    bool holdsAny() const { return std::ranges::any_of(m_grips, &TrueGrip::holds); }
    bool isTube() const { return m_p.attribute == ComparedAttribute::stiffness; }
    Vec3 footOf(int place) const { return {simulation::placeX_m(m_p, place), 0.0, 0.0}; }
    Vec3 ringOf(int place) const { return footOf(place) + Vec3(0.0, 0.0, m_p.hookHeight_m); }
    double slackOf_m(int place, const Vec3& p) const { return m_p.hookHeight_m - (p - footOf(place)).norm(); }
    double abovePad_m(int place, const Vec3& p) const {
        const Vec3 from = p - footOf(place);
        const double out_m = std::max(0.0, std::hypot(from.x(), from.y()) - m_p.padRadius_m);
        const double round_m = std::min(out_m, m_p.padEdge_m * m_p.padSlope);
        const double fall_m = 0.5 * round_m * round_m / m_p.padEdge_m + m_p.padSlope * (out_m - round_m);
        return from.z() + fall_m - m_rise_m;
    }
    ComparisonParameters m_p;
    double m_rise_m;
    std::array<bool, ComparisonParameters::kMaxPlaces> m_mayHold{};   ///< tubes
    std::array<TrueGrip, ComparisonParameters::kMaxPlaces> m_grips{}; ///< lifted objects
};

/// A pad, as its attribute may be drawn. Tubes and lifted objects neither rub nor are they rough.
void addPad(LevelNumbers& numbers, const ComparisonParameters& p) {
    if (simulation::isHooked(p.attribute))
        return;
    simulation::ObjectAttributes pad = p.object;
    if (p.attribute == ComparedAttribute::friction)
        pad.friction = largestOf(p);
    if (p.attribute == ComparedAttribute::roughness)
        pad.roughness_m = largestOf(p);
    addSurface(numbers, pad);
    numbers.turn_per_m = 1.0 / p.padEdge_m;
    if (p.attribute == ComparedAttribute::deformation) {
        numbers.relaxes_s = smallestOf(p);
        numbers.relaxing_N_per_m = pad.recoveryShare * pad.stiffness_N_per_m *
                                   (1.0 + p.padSlope * p.padSlope) * static_cast<double>(p.places);
    }
}

class ComparisonFacts final : public SweepFacts {
public:
    ComparisonFacts() : SweepFacts("comparison") {}

    void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) const override {
        constexpr double kIntoPad_m = 0.002;
        const auto& p = level.parameters.as<ComparisonParameters>();
        addPad(numbers, p);
        // Tubes and pads pull and push as hard as the hand does, for that is what a study compares.
        numbers.givesWay = p.attribute == ComparedAttribute::mass;
        if (numbers.givesWay && numbers.yield_N > 0.0) // in the air an object weighs what it weighs
            numbers.yield_N = std::max(numbers.yield_N, largestOf(p) * core::kStandardGravity);
        numbers.candidates = p.values.size();
        numbers.arrangements = p.arrangements.size();
        for (int place = 0; place < p.places; ++place) // the grip or the top of each
            numbers.places_W.emplace_back(simulation::placeX_m(p, place), 0.0,
                                          simulation::isHooked(p.attribute) ? p.hookHeight_m : -kIntoPad_m);
    }
    std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                             simulation::IScene&) const override {
        return std::make_unique<TrueObjects>(setup.level.parameters.as<ComparisonParameters>());
    }
};

const ComparisonFacts kFacts;

} // namespace

} // namespace chiron::tests
