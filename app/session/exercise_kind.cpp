// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/exercise_kind.h"

#include "session/moment_rule.h"

namespace chiron::session {

std::span<const SceneEvent> ExerciseKind::sceneEvents() const noexcept {
    return {};
}

std::vector<MomentRule> ExerciseKind::momentRules() const {
    return {};
}

core::Result<const ExerciseKind*> exerciseKind(std::string_view id) {
    std::string known;
    for (const ExerciseKind* kind : exerciseKinds()) {
        if (kind->id() == id)
            return kind;
        known += (known.empty() ? "" : ", ") + std::string(kind->id());
    }
    return core::fail(core::ErrorCode::notFound,
                      "exercise \"" + std::string(id) + "\": expected one of " + known);
}

bool isOnlyInStudies(std::string_view exercise) noexcept {
    for (const ExerciseKind* kind : exerciseKinds())
        if (kind->id() == exercise)
            return kind->onlyInStudies();
    return false;
}

std::string_view yieldWords(std::string_view exercise) noexcept {
    for (const ExerciseKind* kind : exerciseKinds())
        if (kind->id() == exercise)
            return kind->yieldWords();
    return kTissueGaveWay;
}

std::string idsOfKinds(bool (*holds)(const ExerciseKind&)) {
    std::string ids;
    for (const ExerciseKind* kind : exerciseKinds())
        if (holds(*kind))
            ids += (ids.empty() ? "" : ", ") + std::string(kind->id());
    return ids;
}

} // namespace chiron::session
