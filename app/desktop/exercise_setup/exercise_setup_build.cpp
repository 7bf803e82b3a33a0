// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the set-up screen and its texts.
#include "desktop/exercise_setup/exercise_setup_screen.h"

#include "desktop/exercise_setup/device_chooser.h"
#include "desktop/exercise_setup/level_chooser.h"
#include "desktop/exercise_setup/workspace_box.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "session/exercise_kind.h"

#include <QCheckBox>

namespace chiron::desktop {

QWidget* ExerciseSetupScreen::buildPage() {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme, 1100);
    page->column()->addWidget(kit::label(theme, title(), TextStyle::heading));
    auto* columns = new QWidget;
    m_columns = new QBoxLayout(QBoxLayout::LeftToRight, columns);
    m_columns->setContentsMargins(0, 0, 0, 0);
    m_columns->setSpacing(theme.px(16));
    m_columns->addWidget(buildCard(), 3, Qt::AlignTop);
    m_columns->addWidget(buildChoices(), 3, Qt::AlignTop);
    page->column()->addWidget(columns);
    page->column()->addStretch();
    return page;
}

QWidget* ExerciseSetupScreen::buildCard() {
    const Theme& theme = context().theme();
    const kit::Box card = kit::box(theme);
    m_picture = new QVBoxLayout;
    card.layout->addLayout(m_picture);
    const auto part = [&](const QString& heading, const QString& name) {
        if (!heading.isEmpty())
            card.layout->addWidget(kit::label(theme, heading, TextStyle::strong));
        auto* text = kit::label(theme, {}, TextStyle::body);
        text->setObjectName(name);
        card.layout->addWidget(text);
        return text;
    };
    m_objective = part({}, QStringLiteral("setup.objective"));
    m_facts = part({}, QStringLiteral("setup.facts"));
    m_measured = part(tr("What is measured"), QStringLiteral("setup.measured"));
    m_gates = part(tr("Pass mark"), QStringLiteral("setup.gates"));
    m_note = kit::label(theme, {}, TextStyle::small, "muted");
    m_note->setObjectName(QStringLiteral("setup.note"));
    card.layout->addWidget(m_note);
    return card.frame;
}

QWidget* ExerciseSetupScreen::buildChoices() {
    const Theme& theme = context().theme();
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(16));
    const kit::Box levels = kit::box(theme);
    levels.layout->addWidget(kit::label(theme, tr("Level"), TextStyle::title));
    m_levels = new LevelChooser(theme, *m_exercise, context().language().toStdString());
    levels.layout->addWidget(m_levels);
    m_standing = kit::label(theme, {}, TextStyle::small, "warning");
    m_standing->hide();
    levels.layout->addWidget(m_standing);
    column->addWidget(levels.frame);

    const kit::Box devices = kit::box(theme);
    devices.layout->addWidget(kit::label(theme, tr("Device"), TextStyle::title));
    const auto kind = session::exerciseKind(m_exercise->id);
    m_devices = new DeviceChooser(context(), kind ? *kind : nullptr);
    devices.layout->addWidget(m_devices);
    column->addWidget(devices.frame);

    m_workspace = new WorkspaceBox(theme, context().locale());
    column->addWidget(m_workspace);
    m_familiarisation = new QCheckBox(tr("Familiarisation: recorded, but not counted"));
    m_familiarisation->setObjectName(QStringLiteral("setup.familiarisation"));
    column->addWidget(m_familiarisation);
    return side;
}

QWidget* ExerciseSetupScreen::buildStart() {
    const Theme& theme = context().theme();
    auto* bar = new QFrame;
    bar->setProperty("kind", QStringLiteral("raised"));
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(theme.px(20), theme.px(10), theme.px(20), theme.px(10));
    row->setSpacing(theme.px(16));
    m_summary = kit::label(theme, {}, TextStyle::body);
    m_summary->setObjectName(QStringLiteral("setup.summary"));
    row->addWidget(m_summary, 1);
    m_watch = kit::button(theme, tr("Watch first"), "", QStringLiteral("view-visible"));
    m_watch->setObjectName(QStringLiteral("setup.watch"));
    m_watch->setToolTip(tr("Watch a scripted expert at this level. Nothing is counted."));
    m_watch->setMinimumHeight(theme.px(52));
    m_watch->setAutoDefault(true);
    row->addWidget(m_watch);
    connect(m_watch, &QPushButton::clicked, this, &ExerciseSetupScreen::watchFirst);
    m_start = kit::button(theme, tr("Start"), "primary", QStringLiteral("media-playback-start"));
    m_start->setObjectName(QStringLiteral("setup.start"));
    m_start->setFont(theme.font(TextStyle::title));
    constexpr double kLargeScale = 1.5; // from this scale upwards "Watch first" needs the room
    m_start->setMinimumSize(theme.px(theme.scale() > kLargeScale ? 120 : 180), theme.px(52));
    m_start->setAutoDefault(true); // so that Enter presses it outside a dialog as well
    row->addWidget(m_start);
    connect(m_start, &QPushButton::clicked, this, &ExerciseSetupScreen::start);
    return bar;
}

QString ExerciseSetupScreen::title() const {
    return m_exercise ? textOf(m_exercise->title) : tr("Exercise");
}

QString ExerciseSetupScreen::help() const {
    return tr("Here you see what an exercise asks for, what is measured and when it is passed.\n\nEverything "
              "is already chosen: press \"Start\" (or Enter) to begin. Choose another level, or a device, if "
              "you want. \"Demonstrate\" lets you watch a scripted operator; "
              "its session does not count for anyone. A file with a recorded movement can be replayed "
              "through the same exercise.\n\n\"Hand and workspace\" sets which hand you work with, how far "
              "the tool moves when your hand moves, and "
              "where the middle of the field "
              "lies. A familiarisation is recorded, but never counted.");
}

std::vector<ScreenCommand> ExerciseSetupScreen::commands() {
    if (!m_exercise)
        return {};
    return {{m_start->text(), QKeySequence(Qt::Key_Return), [this] { start(); }, false}};
}

} // namespace chiron::desktop
