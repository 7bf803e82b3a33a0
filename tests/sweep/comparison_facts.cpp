// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of what studies present side by side, which is a task and not an exercise.
#include "sweep/sweep_facts.h"

#include "simulation/comparison/comparison_parameters.h"
#include "simulation/comparison/comparison_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// Tubes that are slack within their length about their foot, objects that are taken hold of at their ring,
/// pads.
class TrueObjects final : public TrueContact {
public:
    explicit TrueObjects(const ComparisonParameters& p)
        : m_p(p), m_rise_m(roughRise_m(p.attribute == ComparedAttribute::roughness ? largestOf(p)
                                                                                   : p.object.roughness_m)) {}
    void follow(const SceneInput& in, const SceneOutput& out) override {
        const Vec3& p = in.tools.tools[0].p_WT;
        for (int i = 0; i < m_p.places; ++i) {
            bool& may = m_mayHold[static_cast<std::size_t>(i)];
            const double away_m = (p - ringOf(i)).norm();
            if (!isTube() && !objectsPresent(out))
                may = false;
            if (away_m <= m_p.hookReach_m)
                may = true;
            else if (isTube() && slackOf_m(i, p) >= 0.0 && away_m > m_p.hookLeave_m)
                may = false;
        }
    }
    double clearance_m(std::size_t tool, const SceneInput& in, const SceneOutput& out) override {
        double clear_m = kNothing_m;
        if (tool != 0 || !objectsPresent(out))
            return clear_m;
        const Vec3& p = in.tools.tools[0].p_WT;
        for (int i = 0; i < m_p.places; ++i) {
            const bool may = m_mayHold[static_cast<std::size_t>(i)];
            // Where a lifted mass is let go is not known, so no air is claimed once its ring was reached.
            clear_m = std::min(clear_m, !simulation::isHooked(m_p.attribute) ? abovePad_m(i, p)
                                        : !may                               ? kNothing_m
                                        : isTube()                           ? slackOf_m(i, p)
                                                                             : -1.0);
        }
        return clear_m;
    }

private:
    bool isTube() const { return m_p.attribute == ComparedAttribute::stiffness; }
    Vec3 footOf(int place) const { return {simulation::placeX_m(m_p, place), 0.0, 0.0}; }
    Vec3 ringOf(int place) const { return footOf(place) + Vec3(0.0, 0.0, m_p.hookHeight_m); }
    double slackOf_m(int place, const Vec3& p) const { return m_p.hookHeight_m - (p - footOf(place)).norm(); }
    double abovePad_m(int place, const Vec3& p) const {
        const Vec3 from = p - footOf(place);
        const double out_m = std::max(0.0, std::hypot(from.x(), from.y()) - m_p.padRadius_m);
        return from.z() + 0.5 * out_m * out_m / m_p.padEdge_m - m_rise_m;
    }
    ComparisonParameters m_p;
    double m_rise_m;
    std::array<bool, ComparisonParameters::kMaxPlaces> m_mayHold{};
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
}

class ComparisonFacts final : public SweepFacts {
public:
    ComparisonFacts() : SweepFacts("comparison") {}

    void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) const override {
        constexpr double kIntoPad_m = 0.002;
        const auto& p = level.parameters.as<ComparisonParameters>();
        addPad(numbers, p);
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
