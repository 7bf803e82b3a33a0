// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/level_numbers.h"

#include "core/units.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <optional>

namespace chiron::tests {

namespace {

/// The largest number of that name anywhere in the level's content; nothing if it has none.
std::optional<double> inContent(const QJsonValue& value, const QString& key) {
    std::optional<double> found;
    const auto take = [&found](std::optional<double> other) {
        if (other && (!found || *other > *found))
            found = other;
    };
    if (value.isArray())
        for (const QJsonValue& item : value.toArray())
            take(inContent(item, key));
    const QJsonObject object = value.toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        if (it.key() == key && it.value().isDouble())
            take(it.value().toDouble());
        take(inContent(it.value(), key));
    }
    return found;
}

double curvatureOf(double rms_m, double wavelength_m) {
    const double wave_per_m = 2.0 * core::kPi / wavelength_m;
    return rms_m > 0.0 ? 2.0 * rms_m * wave_per_m * wave_per_m : 0.0;
}

/// One more surface that may be touched at the same time.
void addSurface(LevelNumbers& numbers, const simulation::ObjectAttributes& surface) {
    numbers.friction = std::max(numbers.friction, surface.friction);
    numbers.bristle_N_per_m += surface.friction > 0.0 ? surface.bristleStiffness_N_per_m : 0.0;
    numbers.rough_per_m =
        std::max(numbers.rough_per_m, curvatureOf(surface.roughness_m, surface.roughnessWavelength_m));
}

void addApex(LevelNumbers& numbers, const simulation::SphereApexParameters& p) {
    numbers.friction = p.frictionHigh;
    numbers.bristle_N_per_m = p.frictionHigh > 0.0 ? p.bristleStiffness_N_per_m : 0.0;
    if (p.surface != simulation::ApexSurface::exact)
        numbers.rough_per_m = curvatureOf(p.roughness_m, p.roughnessWavelength_m);
}

/// A pad, as its attribute may be drawn. Tubes and lifted objects neither rub nor are they rough.
void addCompared(LevelNumbers& numbers, const simulation::ComparisonParameters& p) {
    using simulation::ComparedAttribute;
    if (simulation::isHooked(p.attribute))
        return;
    double largest = 0.0;
    for (const auto& candidate : p.values)
        largest = std::max(largest, *std::max_element(candidate.begin(), candidate.end()));
    simulation::ObjectAttributes pad = p.object;
    if (p.attribute == ComparedAttribute::friction)
        pad.friction = largest;
    if (p.attribute == ComparedAttribute::roughness)
        pad.roughness_m = largest;
    addSurface(numbers, pad);
}

void addUrethra(LevelNumbers& numbers, const simulation::UrethraInsertionParameters& p) {
    constexpr double kMostTwist_rad = 1.5;
    const simulation::UrethraAnatomy& anatomy = p.anatomy;
    double factor = 1.0;
    for (std::size_t i = 0; i < anatomy.changeCount; ++i)
        factor = std::max(factor, anatomy.changes[i].frictionFactor);
    numbers.friction = anatomy.friction * factor;
    const double span_m = anatomy.pivotSpan_m,
                 turning_m = simulation::UrethraCentreline(anatomy).length_m() - anatomy.straight_m;
    numbers.turn_Nm_per_rad = anatomy.angularStiffness_Nm_per_rad;
    numbers.turn_Nm_per_m =
        numbers.turn_Nm_per_rad *
        (2.0 * anatomy.curvature_per_m + (span_m > 0.0 ? 0.5 / span_m : 0.0) + kMostTwist_rad / turning_m);
    numbers.shaft_m = p.endoscope.radius_m;
}

} // namespace

LevelNumbers numbersOf(const catalogue::ExerciseLevel& level) {
    const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(level.resolvedJson)).object();
    LevelNumbers numbers;
    numbers.yield_N = inContent(all, QStringLiteral("yield_force_N")).value_or(0.0);
    numbers.yield_Nm = inContent(all, QStringLiteral("yield_torque_mN_m")).value_or(0.0) / 1000.0;
    numbers.fall_ms = inContent(all, QStringLiteral("yield_fall_ms")).value_or(numbers.fall_ms);
    if (const auto* apex = level.parameters.find<simulation::SphereApexParameters>())
        addApex(numbers, *apex);
    if (const auto* handling = level.parameters.find<simulation::ObjectHandlingParameters>()) {
        addSurface(numbers, handling->object);
        addSurface(numbers, handling->bed);
    }
    if (const auto* palpation = level.parameters.find<simulation::PalpationParameters>())
        numbers.friction = palpation->tissue.friction;
    if (const auto* urethra = level.parameters.find<simulation::UrethraInsertionParameters>())
        addUrethra(numbers, *urethra);
    if (const auto* compared = level.parameters.find<simulation::ComparisonParameters>())
        addCompared(numbers, *compared);
    return numbers;
}

} // namespace chiron::tests
