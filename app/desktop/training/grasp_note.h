// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_note.h"
#include "desktop/training/grasping.h"
#include "haptics/display_state.h"

#include <QLocale>
#include <QString>
#include <array>
#include <cstdint>

namespace chiron::desktop {

/// The message over the scene when jaws close on nothing. It says that nothing was grasped, which is visible
/// anyway. On a level with feedback, or in practice, it also says why: too far away, covered, or jaws that
/// were already closed and have to open first. It applies the same rules as the scene (GraspLatch), and says
/// nothing if the level hides the objects.
/// Thread: GUI.
class GraspNote {
public:
    static constexpr std::int64_t kSaid_ns = 3'000'000'000;
    /// After a message, further ones are suppressed for this time.
    static constexpr std::int64_t kQuiet_ns = 1'500'000'000;
    /// Closed jaws near an object are tolerated for this time, because they may be moving elsewhere.
    static constexpr std::int64_t kPatience_ns = 700'000'000;

    /// `explains`: the message says why.
    GraspNote(Grasping grasping, const QLocale& locale, bool explains);

    void take(const haptics::DisplayState& state); ///< call once per frame
    scene3d::SceneNote note(std::int64_t now_ns) const;

private:
    struct Jaw {
        bool opened = false;       ///< has opened wide enough to grasp since it last closed
        std::int64_t near_ns = -1; ///< since when it has been closed and empty within reach; -1: it is not
    };
    /// The nearest thing that an instrument could grasp.
    struct Nearest {
        enum class What { nothing, tube, fold, object };
        What what = What::nothing;
        double away_m = 0.0;
        bool covered = false; ///< something lies over it
    };

    void look(std::size_t tool, const haptics::DisplayState& state);
    bool holds(std::size_t tool, const core::LaparoscopyCues& cues) const;
    Nearest nearest(std::size_t tool, const haptics::DisplayState& state) const;
    QString missedWords(const Nearest& nearest) const;
    void say(const QString& words, std::int64_t now_ns);

    Grasping m_grasping;
    QLocale m_locale;
    bool m_explains;
    std::array<Jaw, core::kMaxTools> m_jaws{};
    QString m_said;
    std::int64_t m_since_ns = 0;
};

} // namespace chiron::desktop
