// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::scene3d {

/// What is said over the whole picture. `said`: a line at the top, the scene stays as it is. `paused`, `stopped`: a veil over
/// the scene with a sign of its own, so that nobody works on in a scene that stands still.
struct SceneNote {
    enum class Kind { none, said, paused, stopped };
    Kind kind = Kind::none;
    QString title;
    QString words; ///< below the title, where there is a veil

    bool operator==(const SceneNote&) const = default;
};

} // namespace chiron::scene3d
