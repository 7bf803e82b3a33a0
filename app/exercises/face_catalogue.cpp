// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that the screens show: one for each line of exercise_catalogue.h.
#include "app/exercises/elastic_tube/desktop/elastic_tube_face.h"
#include "app/exercises/exercise_catalogue.h"
#include "app/exercises/object_handling/desktop/object_handling_face.h"
#include "app/exercises/palpation/desktop/palpation_face.h"
#include "app/exercises/sphere_apex/desktop/sphere_apex_face.h"
#include "app/exercises/urethra_insertion/desktop/urethra_insertion_face.h"
#include "desktop/exercise_face.h"
#include "desktop/study_run/comparison_face.h"

#include <array>
#include <string>
#include <tuple>

namespace chiron::desktop {

namespace {

template <class... Exercises> std::span<const ExerciseFace* const> facesOf(exercises::List<Exercises...>) {
    static const std::tuple<typename Exercises::Face...> faces;
    static const auto all =
        std::apply([](const auto&... face) { return std::to_array<const ExerciseFace*>({&face...}); }, faces);
    return all;
}

} // namespace

core::Result<const ExerciseFace*> exerciseFace(std::string_view id) {
    std::string known;
    for (const ExerciseFace* face : facesOf(exercises::All{})) {
        if (face->id() == id)
            return face;
        known += (known.empty() ? "" : ", ") + std::string(face->id());
    }
    return core::fail(core::ErrorCode::notFound,
                      "exercise \"" + std::string(id) + "\": expected one of " + known);
}

} // namespace chiron::desktop
