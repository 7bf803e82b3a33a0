// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::scene3d {

/// A message over the whole picture. `said` is a line at the top, which leaves the scene as it is. `paused`
/// and `stopped` put a veil with a sign over the scene, so that nobody continues to work in a scene that
/// stands still.
struct SceneNote {
    enum class Kind { none, said, paused, stopped };
    Kind kind = Kind::none;
    QString title;
    QString words; ///< below the title, if there is a veil

    bool operator==(const SceneNote&) const = default;
};

} // namespace chiron::scene3d
