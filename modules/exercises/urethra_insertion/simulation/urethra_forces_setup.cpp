// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_sections.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_springs.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_tables.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kLeastSpeed_m_per_s = 0.001; // models.md §0
constexpr double kVelocityWindow_s = 0.015;   // models.md §0: the estimator's longest window
constexpr double kShortest_m = 1e-6;          // keeps invalid data finite; content refuses such data
constexpr int kMostSections = 4096;
constexpr double kSectionsOnAnEdge = 3.2;

struct Place {
    double s_m;
    double step_m;
};

/// The requested step, or a smaller one if the edge of a local change needs it: 3.2 sections on an edge, as
/// for the default edge on the default grid, keep the forces within 1 % of those of twice as many
/// (test_urethra_forces_grid).
double fineStep_m(const UrethraAnatomy& anatomy, double wanted_m) {
    double step_m = wanted_m;
    for (std::size_t i = 0; i < anatomy.changeCount; ++i)
        step_m = std::min(step_m, anatomy.changes[i].edge_m / kSectionsOnAnEdge);
    return step_m;
}

/// Midpoints of equal steps of at most `step_m`.
std::vector<Place> finePlaces(double length_m, double step_m) {
    const double wanted = std::ceil(length_m / std::max(step_m, kShortest_m));
    const int count = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(kMostSections)));
    std::vector<Place> places;
    for (int i = 0; i < count; ++i)
        places.push_back({length_m * (i + 0.5) / count, length_m / count});
    return places;
}

/// P1's drawn sections, equidistant along z; each represents the canal halfway to its neighbours.
std::vector<Place> basicPlaces(const UrethraCentreline& centreline, double zEnd_m, int wanted) {
    const int count = std::clamp(wanted, 2, kMostSections);
    const auto s = [&](double i) { return centreline.arcLengthAt(zEnd_m * i / (count - 1)); };
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        const double before = i == 0 ? s(0) : 0.5 * (s(i - 1) + s(i));
        const double after = i == count - 1 ? s(i) : 0.5 * (s(i) + s(i + 1));
        places.push_back({s(i), after - before});
    }
    return places;
}

UrethraForceSection sectionAt(const Place& place, const UrethraWall& wall, double ahead_m, double behind_m) {
    const double beta = wall.anatomy().wallStiffening_per_m;
    UrethraForceSection section;
    const double radius_m = wall.radius_m(place.s_m);
    section.s_m = place.s_m;
    section.step_m = place.step_m;
    section.stiffness_N_per_m = wall.stiffness_N_per_m3(place.s_m) * 2.0 * core::kPi * radius_m /
                                RadialSprings::kCount * place.step_m;
    section.squeeze_m = wall.endoscope().radius_m - radius_m;
    section.friction = wall.friction(place.s_m);
    section.constrained = wall.constrained(place.s_m);
    section.dragged_m = place.step_m * touchingWeight(section.squeeze_m);
    const double all =
        RadialSprings::kCount * section.stiffness_N_per_m * section.constrained * section.constrained;
    section.follow_N_per_m = all * (0.5 + beta * section.squeeze_m);
    section.press_N_per_m2 = all * beta;
    section.cosAhead = std::cos(core::kPi * place.s_m / ahead_m);
    section.sinAhead = std::sin(core::kPi * place.s_m / ahead_m);
    section.cosBehind = std::cos(core::kPi * place.s_m / behind_m);
    section.sinBehind = std::sin(core::kPi * place.s_m / behind_m);
    return section;
}

UrethraForcePassed withSection(const UrethraForcePassed& before, const UrethraForceSection& section,
                               double beta) {
    const double d = std::max(0.0, section.squeeze_m);
    const double normal = RadialSprings::kCount * section.stiffness_N_per_m * d * (1.0 + beta * d);
    UrethraForcePassed sum = before;
    sum.energy_J += RadialSprings::kCount * section.stiffness_N_per_m * d * d * (0.5 + beta * d / 3.0);
    sum.normal_N += normal;
    sum.friction_N += section.friction * normal;
    sum.length_m += section.dragged_m;
    return sum;
}

UrethraAngularStiffness angularStiffness(const UrethraAnatomy& anatomy, double length_m) {
    UrethraAngularStiffness angular;
    angular.corner_m = std::max(anatomy.angularCorner_m, kShortest_m);
    angular.from_m = anatomy.freeLength_m;
    angular.to_m = std::max(length_m - angular.corner_m, angular.from_m + 2.0 * angular.corner_m);
    angular.slope_Nm_per_rad_m = anatomy.angularStiffness_Nm_per_rad / (angular.to_m - angular.from_m);
    return angular;
}

} // namespace

UrethraForces::Tables::Tables(const UrethraCentreline& centreline, const UrethraWall& wall,
                              const UrethraForceSettings& settings)
    : bladder(wall.anatomy(), wall.endoscope(), centreline.at(centreline.length_m())) {
    const UrethraAnatomy& anatomy = wall.anatomy();
    const double length_m = centreline.length_m();
    ahead_m = std::max(wall.endoscope().beak_m, kShortest_m);
    behind_m = std::max(wall.endoscope().behind_m, kShortest_m);
    scopeRadius_m = wall.endoscope().radius_m;
    stiffening_per_m = anatomy.wallStiffening_per_m;
    viscosity_Ns_per_m2 = anatomy.viscosity_Ns_per_m2;
    wallRetardation_s = anatomy.wallRetardation_s;
    freeHold_N_per_m = anatomy.freeHold_N_per_m;
    freeFrom_m = anatomy.freeLength_m;
    freeBlend_m = std::max(anatomy.freeBlend_m, kShortest_m);
    freeRise_m = ahead_m + std::max(0.0, freeFrom_m - freeBlend_m);
    leastSpeed_m_per_s = std::max(kLeastSpeed_m_per_s, settings.count_m / kVelocityWindow_s);
    maximumDamping_Ns_per_m = settings.maximumDamping_Ns_per_m;
    angular = angularStiffness(anatomy, length_m);
    pivot = {anatomy.freeLength_m, anatomy.pivotSpan_m};
    const std::vector<Place> places = settings.sections == ForceSections::fine
                                          ? finePlaces(length_m, fineStep_m(anatomy, settings.maximumStep_m))
                                          : basicPlaces(centreline, anatomy.zEnd_m, settings.basicSections);
    passed.emplace_back();
    for (const Place& place : places) {
        sections.push_back(sectionAt(place, wall, ahead_m, behind_m));
        passed.push_back(withSection(passed.back(), sections.back(), stiffening_per_m));
    }
    const auto constrained = std::find_if(sections.begin(), sections.end(),
                                          [](const UrethraForceSection& at) { return at.constrained > 0.0; });
    firstConstrained = static_cast<int>(constrained - sections.begin());
    const std::size_t buckets = 2 * sections.size();
    bucketsPerMetre = static_cast<double>(buckets) / length_m;
    for (std::size_t i = 0; i < buckets; ++i) {
        const double from = static_cast<double>(i) / bucketsPerMetre;
        const auto first = std::find_if(sections.begin(), sections.end(),
                                        [from](const UrethraForceSection& at) { return at.s_m >= from; });
        bucket.push_back(static_cast<int>(first - sections.begin()));
    }
}

UrethraForces::UrethraForces(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                             const UrethraForceSettings& settings)
    : m_centreline(anatomy), m_wall(anatomy, endoscope), m_settings(settings),
      m_tables(std::make_unique<const Tables>(m_centreline, m_wall, settings)) {}

UrethraForces::~UrethraForces() = default;

} // namespace chiron::simulation
