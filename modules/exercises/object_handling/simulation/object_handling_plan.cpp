// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/object_handling_plan.h"

#include "core/random.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

using Parameters = ObjectHandlingParameters;
using Trial = ObjectHandlingTrial;

constexpr int kDraws = 1000;
/// Room for a jaw on either side of an object; assumption: a grasper's jaw is 5 mm thick.
constexpr double kJawRoom_m = 0.006;

core::Vec2 uniformInDisc(core::Random& random, double radius_m) {
    const double r = radius_m * std::sqrt(random.uniform());
    const double angle = 2.0 * core::kPi * random.uniform();
    return {r * std::cos(angle), r * std::sin(angle)};
}

bool isApart(const Parameters& p, const Trial& trial) {
    const auto count = static_cast<std::size_t>(trial.objects);
    for (std::size_t i = 0; i < count; ++i) {
        if ((trial.place_m[i] - trial.target_m).norm() < targetSpacing_m(p))
            return false;
        for (std::size_t k = 0; k < i; ++k)
            if ((trial.place_m[i] - trial.place_m[k]).norm() < objectSpacing_m(p))
                return false;
    }
    return true;
}

void onRing(const Parameters& p, core::Random& places, Trial& trial) {
    const double start = 2.0 * core::kPi * places.uniform();
    const auto at = [&](int i) {
        const double angle = start + 2.0 * core::kPi * i / (trial.objects + 1);
        return core::Vec2(p.placesRadius_m * std::cos(angle), p.placesRadius_m * std::sin(angle));
    };
    trial.target_m = at(0);
    for (int i = 0; i < trial.objects; ++i)
        trial.place_m[static_cast<std::size_t>(i)] = at(i + 1);
}

void drawPlaces(const Parameters& p, core::Random& places, Trial& trial) {
    for (int draw = 0; draw < kDraws; ++draw) {
        trial.target_m = uniformInDisc(places, p.placesRadius_m);
        for (int i = 0; i < trial.objects; ++i)
            trial.place_m[static_cast<std::size_t>(i)] = uniformInDisc(places, p.placesRadius_m);
        if (isApart(p, trial))
            return;
    }
    onRing(p, places, trial);
}

void drawMasses(const Parameters& p, core::Random& masses, core::Random& which, Trial& trial) {
    const bool own = p.massLow_kg <= 0.0 && p.massHigh_kg <= 0.0;
    const double low = own ? p.object.mass_kg : p.massLow_kg;
    const double high = own ? p.object.mass_kg : p.massHigh_kg;
    const auto count = static_cast<std::size_t>(trial.objects);
    if (p.task == HandlingTask::place) {
        for (std::size_t i = 0; i < count; ++i)
            trial.mass_kg[i] = masses.uniform(low, high);
        trial.heaviest =
            static_cast<int>(std::max_element(trial.mass_kg.begin(), trial.mass_kg.begin() + trial.objects) -
                             trial.mass_kg.begin());
        return;
    }
    trial.heaviest = static_cast<int>(which.below(static_cast<std::uint64_t>(trial.objects)));
    const double lighter = std::max(low, high / p.massRatio); // greatest mass of any other object
    double next = low;
    for (std::size_t i = 0; i < count; ++i) {
        if (static_cast<int>(i) == trial.heaviest)
            continue;
        trial.mass_kg[i] = masses.uniform(low, lighter);
        next = std::max(next, trial.mass_kg[i]);
    }
    trial.mass_kg[static_cast<std::size_t>(trial.heaviest)] =
        masses.uniform(std::min(high, p.massRatio * next), high);
}

} // namespace

double objectSpacing_m(const ObjectHandlingParameters& parameters) noexcept {
    return 2.0 * (parameters.radius_m + kJawRoom_m);
}

double targetSpacing_m(const ObjectHandlingParameters& parameters) noexcept {
    return parameters.targetRadius_m + parameters.radius_m;
}

std::vector<ObjectHandlingTrial> planObjectHandlingTrials(const ObjectHandlingParameters& parameters,
                                                          std::uint64_t seed) {
    core::Random places = core::Random::stream(seed, "object_handling.place");
    core::Random masses = core::Random::stream(seed, "object_handling.mass");
    core::Random which = core::Random::stream(seed, "object_handling.heaviest");
    std::vector<Trial> trials(static_cast<std::size_t>(std::max(1, parameters.trials)));
    for (Trial& trial : trials) {
        trial.objects = std::clamp(parameters.objects, 1, static_cast<int>(Trial::kMaxObjects));
        drawPlaces(parameters, places, trial);
        drawMasses(parameters, masses, which, trial);
    }
    return trials;
}

} // namespace chiron::simulation
