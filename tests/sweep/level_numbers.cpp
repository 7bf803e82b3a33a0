// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/level_numbers.h"

#include "core/units.h"
#include "sweep/sweep_facts.h"

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

} // namespace

LevelNumbers numbersOf(const catalogue::ExerciseLevel& level) {
    const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(level.resolvedJson)).object();
    LevelNumbers numbers;
    numbers.yield_N = inContent(all, QStringLiteral("yield_force_N")).value_or(0.0);
    numbers.yield_Nm = inContent(all, QStringLiteral("yield_torque_mN_m")).value_or(0.0) / 1000.0;
    numbers.fall_ms = inContent(all, QStringLiteral("yield_fall_ms")).value_or(numbers.fall_ms);
    if (const SweepFacts* facts = SweepFacts::of(level.exercise))
        facts->complete(level, numbers);
    return numbers;
}

double roughCurvature_per_m(double rms_m, double wavelength_m) {
    const double wave_per_m = 2.0 * core::kPi / wavelength_m;
    return rms_m > 0.0 ? 2.0 * rms_m * wave_per_m * wave_per_m : 0.0;
}

void addSurface(LevelNumbers& numbers, const simulation::ObjectAttributes& surface) {
    numbers.friction = std::max(numbers.friction, surface.friction);
    numbers.bristle_N_per_m += surface.friction > 0.0 ? surface.bristleStiffness_N_per_m : 0.0;
    numbers.rough_per_m = std::max(numbers.rough_per_m,
                                   roughCurvature_per_m(surface.roughness_m, surface.roughnessWavelength_m));
}

} // namespace chiron::tests
