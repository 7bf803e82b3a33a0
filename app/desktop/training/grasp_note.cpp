// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/grasp_note.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(GraspNote)
};

core::Vec3 placeOf(const std::array<double, 3>& p_W) {
    return {p_W[0], p_W[1], p_W[2]};
}
} // namespace

GraspNote::GraspNote(Grasping grasping, const QLocale& locale, bool explains)
    : m_grasping(std::move(grasping)), m_locale(locale), m_explains(explains) {}

bool GraspNote::holds(std::size_t tool, const core::LaparoscopyCues& cues) const {
    const auto by = [tool](std::uint8_t tools) { return (tools >> tool & 1U) != 0; };
    const auto first = [](const auto& values, int count) {
        return values.begin() + std::clamp<std::ptrdiff_t>(count, 0, std::ssize(values));
    };
    return by(cues.foldHeldBy) ||
           std::any_of(cues.gripHeldBy.begin(), first(cues.gripHeldBy, cues.grips), by) ||
           std::any_of(cues.body.begin(), first(cues.body, cues.bodies),
                       [by](const core::BodyCue& body) { return by(body.heldBy); });
}

GraspNote::Nearest GraspNote::nearest(std::size_t tool, const haptics::DisplayState& state) const {
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    const core::Vec3 tip = placeOf(state.tool[tool].p_WT_m);
    Nearest found;
    const auto take = [&](Nearest::What what, double away_m, bool covered) {
        if (found.what == Nearest::What::nothing || away_m < found.away_m)
            found = {what, away_m, covered};
    };
    if (static_cast<int>(tool) == m_grasping.retractor) {
        if (cues.fold)
            take(Nearest::What::fold, (placeOf(cues.p_WFoldEdge) - tip).norm(), false);
        return found;
    }
    for (std::size_t i = 0;
         cues.tube && i < std::min(cues.p_WGrip.size(), static_cast<std::size_t>(std::max(0, cues.grips)));
         ++i)
        if (cues.gripHeldBy[i] == 0 && !cues.gripAnchored[i])
            take(Nearest::What::tube, (placeOf(cues.p_WGrip[i]) - tip).norm(), cues.fold && !cues.foldOpen);
    for (std::size_t i = 0;
         i < std::min(cues.body.size(), static_cast<std::size_t>(std::max(0, cues.bodies))); ++i)
        take(Nearest::What::object,
             std::max(0.0, (placeOf(cues.body[i].p_W) - tip).norm() - cues.body[i].radius_m), false);
    return found;
}

QString GraspNote::missedWords(const Nearest& nearest) const {
    if (!m_explains || nearest.what == Nearest::What::nothing)
        return Words::tr("Nothing was grasped");
    if (nearest.away_m <= m_grasping.reach_m)
        return nearest.covered
                   ? Words::tr("Nothing was grasped: the fold still lies over the tube. Retract it first.")
                   : Words::tr("Nothing was grasped. Open the jaws and try again.");
    const QString mm = m_locale.toString(1e3 * nearest.away_m, 'f', 0);
    switch (nearest.what) {
    case Nearest::What::fold:
        return Words::tr("Nothing was grasped: the edge of the fold was %1 mm away. Open the jaws and move "
                         "closer to it.")
            .arg(mm);
    case Nearest::What::object:
        return Words::tr(
                   "Nothing was grasped: the object was %1 mm away. Open the jaws and move closer to it.")
            .arg(mm);
    case Nearest::What::tube:
    case Nearest::What::nothing:
        break;
    }
    return Words::tr("Nothing was grasped: the place to grip the tube was %1 mm away. Open the jaws and move "
                     "closer to it.")
        .arg(mm);
}

void GraspNote::say(const QString& words, std::int64_t now_ns) {
    if (!m_said.isEmpty() && now_ns - m_since_ns < kSaid_ns + kQuiet_ns)
        return;
    m_said = words;
    m_since_ns = now_ns;
}

void GraspNote::look(std::size_t tool, const haptics::DisplayState& state) {
    Jaw& jaw = m_jaws[tool];
    const double angle_rad = state.tool[tool].jaw_rad;
    if (angle_rad > m_grasping.opensAbove_rad) {
        jaw = {true, -1};
        return;
    }
    if (holds(tool, state.exercise.of<core::LaparoscopyCues>())) {
        jaw = {};
        return;
    }
    if (angle_rad > m_grasping.holdsBelow_rad)
        return; // the jaw is still closing
    const Nearest found = nearest(tool, state);
    if (jaw.opened) {
        jaw = {};
        say(missedWords(found), state.now_ns);
        return;
    }
    if (found.what == Nearest::What::nothing || found.away_m > m_grasping.reach_m) {
        jaw.near_ns = -1;
        return;
    }
    if (jaw.near_ns < 0)
        jaw.near_ns = state.now_ns;
    else if (m_explains && state.now_ns - jaw.near_ns >= kPatience_ns)
        say(Words::tr("Nothing is grasped: the jaws are closed. Open them wide, then close them here."),
            state.now_ns);
}

void GraspNote::take(const haptics::DisplayState& state) {
    if (state.paused)
        return;
    // Each trial requires the jaws to open first, as the scene does.
    if (state.phase != core::TrialPhase::running || !state.exercise.of<core::LaparoscopyCues>().objectShown) {
        m_jaws = {};
        m_said.clear();
        return;
    }
    for (std::size_t i = 0; i < m_jaws.size() && static_cast<int>(i) < state.tools; ++i)
        look(i, state);
}

scene3d::SceneNote GraspNote::note(std::int64_t now_ns) const {
    if (m_said.isEmpty() || now_ns - m_since_ns > kSaid_ns)
        return {};
    return {scene3d::SceneNote::Kind::said, m_said, {}};
}

} // namespace chiron::desktop
