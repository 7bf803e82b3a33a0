// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include <utility>

namespace chiron::tests {

namespace {
/// Filled before main() by the objects of the exercises' own files.
SweepFacts::ByExercise& known() {
    static SweepFacts::ByExercise facts;
    return facts;
}
} // namespace

SweepFacts::SweepFacts(std::string exercise) {
    known().emplace(std::move(exercise), this);
}

const SweepFacts::ByExercise& SweepFacts::all() {
    return known();
}

const SweepFacts* SweepFacts::of(std::string_view exercise) {
    const auto found = known().find(exercise);
    return found != known().end() ? found->second : nullptr;
}

} // namespace chiron::tests
