// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/level_chooser.h"

#include "desktop/exercise_setup/choice_tile.h"

#include <QButtonGroup>
#include <QVBoxLayout>

namespace chiron::desktop {

LevelChooser::LevelChooser(const Theme& theme, const catalogue::Exercise& exercise,
                           const std::string& language, QWidget* parent)
    : QWidget(parent), m_group(new QButtonGroup(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    for (const catalogue::ExerciseLevel& level : exercise.levels) {
        auto* tile =
            new ChoiceTile(theme,
                           tr("Level %1: %2")
                               .arg(level.number)
                               .arg(QString::fromStdString(catalogue::textIn(level.title, language))),
                           {});
        tile->setObjectName(QStringLiteral("setup.level.%1").arg(level.number));
        m_group->addButton(tile, level.number);
        m_tiles[level.number] = tile;
        column->addWidget(tile);
    }
    connect(m_group, &QButtonGroup::idClicked, this, &LevelChooser::chosen);
}

int LevelChooser::level() const {
    return m_group->checkedId();
}

void LevelChooser::setLevel(int level) {
    if (QAbstractButton* tile = m_group->button(level))
        tile->setChecked(true);
}

void LevelChooser::setStandings(std::span<const session::LevelStanding> standings, int next) {
    for (const session::LevelStanding& standing : standings) {
        const auto tile = m_tiles.find(standing.level);
        if (tile == m_tiles.end())
            continue;
        QString words = tr("Not tried yet");
        if (standing.standing() == session::Standing::passed)
            words = tr("Passed");
        else if (standing.standing() == session::Standing::tried)
            words = tr("Tried %n times, not passed yet", nullptr, standing.attempts);
        if (standing.level == next)
            words = tr("%1 · recommended next").arg(words);
        tile->second->setWords(words);
    }
}

} // namespace chiron::desktop
