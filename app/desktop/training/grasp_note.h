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

/// What is said over the scene when jaws close on nothing: that nothing was grasped, as the eyes see it anyway; and on a level with
/// feedback, or in a practice, why: too far away, covered, or jaws that were closed already and have to open first. It judges by the
/// rules that the scene grasps by (GraspLatch), and says nothing where the level hides what there is to grasp. GUI thread.
class GraspNote {
public:
    static constexpr std::int64_t kSaid_ns = 3'000'000'000;
    static constexpr std::int64_t kQuiet_ns = 1'500'000'000; ///< after it, nothing more is said of grasps for so long
    static constexpr std::int64_t kPatience_ns = 700'000'000; ///< closed jaws at the object: for so long it may be on the way elsewhere

    /// `explains`: it says why.
    GraspNote(Grasping grasping, const QLocale& locale, bool explains);

    void take(const haptics::DisplayState& state); ///< each frame
    scene3d::SceneNote note(std::int64_t now_ns) const;

private:
    struct Jaw {
        bool opened = false;       ///< wide enough to take hold, since it last was closed
        std::int64_t near_ns = -1; ///< closed and empty within reach since; -1: it is not
    };
    /// What an instrument could take hold of next.
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
