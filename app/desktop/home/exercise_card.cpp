// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/exercise_card.h"

#include "desktop/home/exercise_picture.h"
#include "desktop/sessions/session_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/tile_button.h"

#include <QHBoxLayout>
#include <algorithm>

namespace chiron::desktop {

QString textIn(const catalogue::Translated& text, const AppContext& context) {
    return QString::fromStdString(catalogue::textIn(text, context.language().toStdString()));
}

namespace {

WordSign signOf(session::Standing standing) {
    switch (standing) {
    case session::Standing::passed:
        return {"dialog-ok-apply", Colour::good};
    case session::Standing::tried:
        return {"view-refresh", Colour::warning};
    case session::Standing::fresh:
        return {"list-add", Colour::accent};
    }
    return {"list-add", Colour::accent};
}

} // namespace

QString standingWords(const session::LevelStanding& standing) {
    if (standing.passedFelt && standing.passedShown)
        return ExerciseCard::tr("Passed with felt and with shown force");
    if (standing.passedFelt)
        return ExerciseCard::tr("Passed with felt force");
    if (standing.passedShown)
        return ExerciseCard::tr("Passed with shown force");
    if (standing.attempts > 0)
        return ExerciseCard::tr("%n attempt(s), not passed yet", nullptr, standing.attempts);
    return ExerciseCard::tr("New");
}

ExerciseCard::ExerciseCard(AppContext& context, const catalogue::Exercise& exercise,
                           std::span<const session::LevelStanding> standings, QWidget* parent)
    : QFrame(parent), m_context(context) {
    const Theme& theme = context.theme();
    setProperty("kind", QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(16), theme.px(16), theme.px(16), theme.px(16));
    column->setSpacing(theme.px(12));
    auto* head = new QHBoxLayout;
    head->setSpacing(theme.px(16));
    if (!exercise.levels.empty() && theme.scale() < kNoPictureScale)
        head->addWidget(new ExercisePicture(theme, exercise.levels.front(), {168, 112}), 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->addWidget(kit::label(theme, textIn(exercise.title, context), TextStyle::title));
    words->addWidget(kit::label(theme, textIn(exercise.objective, context), TextStyle::body, "muted"));
    words->addStretch();
    head->addLayout(words, 1);
    column->addLayout(head);
    std::vector<session::LevelStanding> own;
    std::copy_if(standings.begin(), standings.end(), std::back_inserter(own),
                 [&](const session::LevelStanding& s) { return s.exercise == exercise.id; });
    const auto next = session::nextStep(own);
    for (const catalogue::ExerciseLevel& level : exercise.levels) {
        const auto found =
            std::find_if(standings.begin(), standings.end(), [&](const session::LevelStanding& s) {
                return s.exercise == exercise.id && s.level == level.number;
            });
        column->addWidget(levelButton(level, found == standings.end() ? nullptr : &*found,
                                      next && next->level == level.number));
    }
}

QWidget* ExerciseCard::levelButton(const catalogue::ExerciseLevel& level,
                                   const session::LevelStanding* standing, bool next) {
    const Theme& theme = m_context.theme();
    const QString title =
        tr("Level %1: %2").arg(m_context.locale().toString(level.number), textIn(level.title, m_context));
    auto* button = new TileButton(theme);
    button->setObjectName(
        QStringLiteral("exercise.%1.%2").arg(QString::fromStdString(level.exercise)).arg(level.number));
    const QString words = !standing ? QString()
                          : next    ? tr("%1 · next step").arg(standingWords(*standing))
                                    : standingWords(*standing);
    button->setAccessibleName(standing ? tr("%1. %2").arg(title, words) : title);
    QHBoxLayout* row = button->row();
    row->addWidget(kit::label(theme, title, TextStyle::strong), 1);
    if (standing) {
        const WordSign sign = signOf(standing->standing());
        auto* picture = new QLabel;
        picture->setPixmap(theme.icon(QLatin1String(sign.icon), sign.ink).pixmap(theme.px(20), theme.px(20)));
        row->addWidget(picture);
        row->addWidget(kit::label(theme, words, TextStyle::body, "muted"), 1);
    }
    button->seal();
    connect(button, &QPushButton::clicked, this, [this, exercise = level.exercise, number = level.number] {
        m_context.navigator().go(QStringLiteral("exercise_setup"),
                                 {{QStringLiteral("exercise"), QString::fromStdString(exercise)},
                                  {QStringLiteral("level"), number}});
    });
    return button;
}

} // namespace chiron::desktop
