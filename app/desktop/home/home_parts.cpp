// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/app_context.h"
#include "desktop/home/exercise_card.h"
#include "desktop/home/exercise_picture.h"
#include "desktop/home/home_screen.h"
#include "desktop/home/session_lines.h"
#include "desktop/sessions/session_words.h"
#include "desktop/storage/storage_words.h"
#include "desktop/training/training_plan.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/tile_button.h"

#include <QHBoxLayout>
#include <algorithm>

namespace chiron::desktop {

void HomeScreen::addTrainee(QVBoxLayout& column, const HomeData& home) {
    const Theme& theme = context().theme();
    column.addWidget(continueCard(home));
    column.addWidget(progressCard(home));
    auto* all = opener(tr("Choose another exercise"), QStringLiteral("exercises"), {}, "");
    all->setObjectName(QStringLiteral("home.exercises"));
    all->setIcon(theme.icon(QStringLiteral("view-list-icons")));
    column.addWidget(all, 0, Qt::AlignLeft);
}

void HomeScreen::addOwnTraining(QVBoxLayout& column, const HomeData& home) {
    QWidget* card = home.own.empty() ? tryCard(home) : continueCard(home);
    if (card)
        column.addWidget(card);
}

QVBoxLayout* HomeScreen::besidePicture(QVBoxLayout& card, const catalogue::ExerciseLevel& level) {
    const Theme& theme = context().theme();
    auto* row = new QHBoxLayout;
    row->setSpacing(theme.px(20));
    if (theme.scale() < kNoPictureScale)
        row->addWidget(new ExercisePicture(theme, level, {228, 152}), 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->setSpacing(theme.px(6));
    row->addLayout(words, 1);
    card.addLayout(row);
    return words;
}

QWidget* HomeScreen::tryCard(const HomeData& home) {
    const auto next = session::nextStep(home.standings);
    const catalogue::ExerciseLevel* level =
        next ? context().site().catalogue().find(next->exercise, next->level) : nullptr;
    if (!level)
        return nullptr;
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("home.try_card"));
    QVBoxLayout* words = besidePicture(*box.layout, *level);
    words->addWidget(kit::label(theme, tr("Try an exercise yourself"), TextStyle::title));
    const catalogue::Exercise* exercise = context().site().catalogue().find(next->exercise);
    words->addWidget(kit::label(
        theme, tr("%1: %2").arg(exercise ? textIn(exercise->title, context()) : QString(),
                                textIn(level->goal.empty() ? level->objective : level->goal, context()))));
    words->addWidget(kit::label(
        theme,
        tr("It takes about a minute with mouse and keyboard, does not count, and ends with a debrief."),
        TextStyle::small, "muted"));
    auto* buttons = new QWidget;
    auto* flow = new FlowLayout(theme.px(10), buttons);
    flow->addWidget(tryButton(*next, "primary"));
    auto* all = opener(tr("Choose another exercise"), QStringLiteral("exercises"), {}, "quiet");
    all->setObjectName(QStringLiteral("home.exercises"));
    flow->addWidget(all);
    words->addWidget(buttons);
    words->addStretch();
    return box.frame;
}

QPushButton* HomeScreen::tryButton(const session::LevelStanding& level, const char* kind) {
    auto* button = opener(tr("Try it now"), QStringLiteral("training"),
                          tryPlan(level.exercise, level.level).toMap(), kind);
    button->setObjectName(QStringLiteral("home.try"));
    button->setToolTip(tr("A few trials that do not count, with mouse and keyboard."));
    return button;
}

// The result of the last session of this exercise, from which "next" follows.
QString HomeScreen::lastResult(const HomeData& home, const session::LevelStanding& next) const {
    const auto row = std::find_if(home.own.begin(), home.own.end(), [&](const SessionRow& each) {
        return each.summary.exercise == next.exercise;
    });
    if (row == home.own.end())
        return {};
    const database::SessionSummary& summary = row->summary;
    const bool ended = summary.state == database::SessionState::completed;
    return tr("Last time: level %1 · %2 · %3")
        .arg(context().locale().toString(summary.level),
             ended ? SessionWords::outcome(SessionWords::outcomeOf(summary))
                   : SessionWords::state(summary.state),
             SessionWords::ago(SessionWords::timeOf(summary.startedUtc), QDateTime::currentDateTimeUtc(),
                               context().locale()));
}

QWidget* HomeScreen::continueCard(const HomeData& home) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    const auto next = session::nextStep(home.standings);
    const catalogue::ExerciseLevel* level =
        next ? context().site().catalogue().find(next->exercise, next->level) : nullptr;
    if (!level) {
        box.layout->addWidget(kit::label(theme, tr("Every level is passed"), TextStyle::title));
        box.layout->addWidget(kit::label(theme, tr("Well done. Choose any exercise to stay in practice.")));
        return box.frame;
    }
    QVBoxLayout* words = besidePicture(*box.layout, *level);
    words->addWidget(kit::label(theme,
                                next->attempts > 0 ? tr("Continue where you left off") : tr("Your next step"),
                                TextStyle::small, "muted"));
    const catalogue::Exercise* exercise = context().site().catalogue().find(next->exercise);
    words->addWidget(
        kit::label(theme,
                   tr("%1, level %2: %3")
                       .arg(exercise ? textIn(exercise->title, context()) : QString(),
                            context().locale().toString(level->number), textIn(level->title, context())),
                   TextStyle::title));
    words->addWidget(
        kit::label(theme, textIn(level->goal.empty() ? level->objective : level->goal, context())));
    words->addWidget(kit::label(theme, standingWords(*next), TextStyle::small, "muted"));
    if (const QString last = lastResult(home, *next); !last.isEmpty()) {
        auto* line = kit::label(theme, last);
        line->setObjectName(QStringLiteral("home.last"));
        words->addWidget(line);
    }
    auto* go = opener(tr("Continue"), QStringLiteral("exercise_setup"),
                      {{QStringLiteral("exercise"), QString::fromStdString(next->exercise)},
                       {QStringLiteral("level"), next->level}},
                      "primary");
    go->setObjectName(QStringLiteral("home.continue"));
    go->setIcon(theme.icon(QStringLiteral("media-playback-start"), Colour::accentText));
    go->setIconSize(QSize(theme.px(20), theme.px(20)));
    auto* buttons = new QWidget;
    auto* flow = new FlowLayout(theme.px(10), buttons);
    flow->addWidget(go);
    if (home.own.empty())
        flow->addWidget(tryButton(*next, ""));
    words->addWidget(buttons);
    words->addStretch();
    return box.frame;
}

QWidget* HomeScreen::progressCard(const HomeData& home) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("My progress"), TextStyle::title));
    if (home.own.empty()) {
        box.layout->addWidget(
            kit::label(theme, tr("Nothing recorded yet. Your first session appears here once it has ended."),
                       TextStyle::body, "muted"));
        return box.frame;
    }
    box.layout->addWidget(new SessionLines(context(), home.own, false));
    auto* all = opener(tr("All my results"), QStringLiteral("results"), {}, "quiet");
    all->setObjectName(QStringLiteral("home.results"));
    box.layout->addWidget(all, 0, Qt::AlignLeft);
    return box.frame;
}

void HomeScreen::addTrainer(QVBoxLayout& column, const HomeData& home) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    auto* title = kit::label(theme,
                             home.toReview > 0 ? tr("%n session(s) to review", nullptr, home.toReview)
                                               : tr("Sessions to review"),
                             TextStyle::title);
    title->setObjectName(QStringLiteral("home.to_review_count"));
    box.layout->addWidget(title);
    if (home.toLook.empty())
        box.layout->addWidget(kit::label(
            theme,
            home.people.empty()
                ? tr("Nobody has trained yet. Trainees' sessions will appear here, interrupted ones first.")
                : tr("Everything is reviewed. A trainee's latest attempt at each level will appear here."),
            TextStyle::body, "muted"));
    else
        box.layout->addWidget(new SessionLines(context(), home.toLook, true));
    auto* buttons = new QWidget;
    auto* row = new FlowLayout(theme.px(8), buttons);
    if (home.toReview > 0) {
        auto* waiting = opener(tr("List of sessions to review"), QStringLiteral("sessions"),
                               {{QStringLiteral("review"), QStringLiteral("to_review")}}, "primary");
        waiting->setObjectName(QStringLiteral("home.to_review"));
        row->addWidget(waiting);
    }
    auto* all = opener(tr("All sessions"), QStringLiteral("sessions"), {{QStringLiteral("all"), true}});
    all->setObjectName(QStringLiteral("home.sessions"));
    row->addWidget(all);
    auto* progress = opener(tr("Progress of the group"), QStringLiteral("progress"));
    progress->setObjectName(QStringLiteral("home.progress"));
    row->addWidget(progress);
    box.layout->addWidget(buttons);
    column.addWidget(box.frame);
    if (!home.people.empty())
        column.addWidget(peopleCard(home));
}

QWidget* HomeScreen::peopleCard(const HomeData& home) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Recent training"), TextStyle::title));
    const QDateTime now = QDateTime::currentDateTimeUtc();
    for (const RecentPerson& person : home.people) {
        auto* button = new TileButton(theme);
        const QString when =
            SessionWords::ago(SessionWords::timeOf(person.latestUtc), now, context().locale());
        const QString count = tr("%n session(s) in the last 7 days", nullptr, person.sessions);
        button->setObjectName(QStringLiteral("home.person.%1").arg(person.person));
        button->setAccessibleName(tr("%1. %2. Opens the results.").arg(person.name, when));
        QHBoxLayout* row = button->row();
        row->addWidget(kit::label(theme, person.name, TextStyle::strong), 2);
        row->addWidget(kit::label(theme, count, TextStyle::body), 2);
        row->addWidget(kit::label(theme, when, TextStyle::small, "muted"), 1);
        button->seal();
        connect(button, &QPushButton::clicked, this, [this, id = person.person, name = person.name] {
            context().navigator().go(QStringLiteral("results"),
                                     {{QStringLiteral("person"), id}, {QStringLiteral("name"), name}});
        });
        box.layout->addWidget(button);
    }
    return box.frame;
}

void HomeScreen::addStudies(QVBoxLayout& column) {
    column.addWidget(stateCard({QStringLiteral("studies"),
                                tr("Studies"),
                                tr("Design a study or begin with a template, try it with simulated "
                                   "observers, freeze it, enrol participants."),
                                "info",
                                {},
                                tr("Open the studies")}));
}

void HomeScreen::addResearcher(QVBoxLayout& column) {
    addStudies(column);
    column.addWidget(stateCard({QStringLiteral("study_run"),
                                tr("Run"),
                                tr("Guide a participant through a study by code, in the order set for them. "
                                   "Interrupted runs continue where they stopped."),
                                "info",
                                {},
                                tr("Run a study")}));
    column.addWidget(stateCard({QStringLiteral("study_data"),
                                tr("Data"),
                                tr("Curves, thresholds and intervals of each person and the group, every "
                                   "trial with its fidelity, exports."),
                                "info",
                                {},
                                tr("Open the data")}));
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Training sessions"), TextStyle::title));
    box.layout->addWidget(kit::label(
        theme, tr("Every recorded session, by code instead of by name: filter the list, play sessions back, "
                  "save the list as a table.")));
    auto* open = opener(tr("Open the sessions"), QStringLiteral("sessions"), {}, "quiet");
    open->setObjectName(QStringLiteral("home.data"));
    box.layout->addWidget(open, 0, Qt::AlignLeft);
    column.addWidget(box.frame);
}

QWidget* HomeScreen::stateCard(const StateCard& card) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, card.title, TextStyle::title));
    box.layout->addWidget(kit::label(theme, card.text));
    if (!card.notice.isEmpty())
        box.layout->addWidget(kit::notice(theme, card.noticeKind, card.notice));
    box.layout->addStretch();
    auto* open = opener(card.action, card.screen);
    open->setObjectName(QStringLiteral("home.") + card.screen);
    box.layout->addWidget(open, 0, Qt::AlignLeft);
    return box.frame;
}

std::vector<HomeScreen::StateCard> HomeScreen::adminCards(const HomeData& home) const {
    const QLocale locale = context().locale();
    const QString toErase = home.toErase > 0 ? tr("%n participant(s) withdrew from a study and asked for "
                                                  "their recordings to be erased. Under People, choose "
                                                  "\"Erase a participant\".",
                                                  nullptr, home.toErase)
                                             : QString();
    const session::StorageRoom room = home.room.value_or(session::StorageRoom{});
    const StorageNotice disk = StorageWords::room(room, locale);
    const StorageNotice backup =
        StorageWords::backup(home.latestBackupUtc, QDateTime::currentDateTimeUtc(), locale);
    const StorageNotice automatic =
        StorageWords::automatic(home.backups, QDateTime::currentDateTimeUtc(), locale);
    const StorageNotice& worst = !disk.isGood() ? disk : !home.backups.problem.empty() ? automatic : backup;
    const QString loop =
        !home.lastLoopTimed ? QString()
        : home.lastLoopPriority
            ? tr("The last session ran with real-time priority.")
            : tr("The last session ran without real-time priority: forces may feel less smooth.");
    return {{QStringLiteral("people"), tr("People"), tr("%n account(s) can log in.", nullptr, home.accounts),
             "warning", toErase, tr("Open people"), home.toErase > 0},
            {QStringLiteral("storage"), tr("Storage"),
             tr("The database uses %1; %2 is free.")
                 .arg(SessionWords::bytes(room.database_bytes, locale),
                      SessionWords::bytes(room.diskFree_bytes, locale)),
             worst.kind, worst.text, tr("Open storage"), !worst.isGood()},
            {QStringLiteral("station"), tr("Station"),
             tr("Devices, timing of the force loop, free space for recordings."),
             home.lastLoopTimed && !home.lastLoopPriority ? "warning" : "good", loop,
             tr("Open the station check")}};
}

void HomeScreen::addAdmin(QVBoxLayout& column, const HomeData& home, bool thatAsk) {
    for (const StateCard& card : adminCards(home))
        if (card.asks == thatAsk)
            column.addWidget(stateCard(card));
}

} // namespace chiron::desktop
