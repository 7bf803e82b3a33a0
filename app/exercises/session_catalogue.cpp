// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that can be run: one for each line of exercise_catalogue.h.
#include "app/exercises/elastic_tube/session/elastic_tube_kind.h"
#include "app/exercises/exercise_catalogue.h"
#include "app/exercises/object_handling/session/object_handling_kind.h"
#include "app/exercises/palpation/session/palpation_kind.h"
#include "app/exercises/sphere_apex/session/sphere_apex_kind.h"
#include "app/exercises/urethra_insertion/session/urethra_insertion_kind.h"
#include "session/exercise_kind.h"
#include "session/study/comparison_kind.h"

#include <array>
#include <tuple>

namespace chiron::session {

namespace {

template <class... Exercises> std::span<const ExerciseKind* const> kindsOf(exercises::List<Exercises...>) {
    static const std::tuple<typename Exercises::Kind...> kinds;
    static const auto all =
        std::apply([](const auto&... kind) { return std::to_array<const ExerciseKind*>({&kind...}); }, kinds);
    return all;
}

} // namespace

std::span<const ExerciseKind* const> exerciseKinds() {
    return kindsOf(exercises::All{});
}

} // namespace chiron::session
