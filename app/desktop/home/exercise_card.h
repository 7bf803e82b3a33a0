// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/app_context.h"
#include "session/level_standing.h"

#include <QFrame>
#include <span>

namespace chiron::desktop {

/// Shows one exercise: picture, purpose, and one button per level that states the person's standing. A button
/// opens the set-up screen at its level.
class ExerciseCard final : public QFrame {
    Q_OBJECT
public:
    /// If `standings` is empty, the levels show no standing.
    ExerciseCard(AppContext& context, const catalogue::Exercise& exercise,
                 std::span<const session::LevelStanding> standings, QWidget* parent = nullptr);

private:
    QWidget* levelButton(const catalogue::ExerciseLevel& level, const session::LevelStanding* standing,
                         bool next);

    AppContext& m_context;
};

/// A text from the content, in the language of the program.
QString textIn(const catalogue::Translated& text, const AppContext& context);
/// "Passed (felt)", "Tried twice, not passed yet", "New".
QString standingWords(const session::LevelStanding& standing);

} // namespace chiron::desktop
