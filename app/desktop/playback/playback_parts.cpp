// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/app_context.h"
#include "desktop/playback/comment_panel.h"
#include "desktop/playback/mark_list.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/playback/playback_screen.h"
#include "desktop/playback/scrubber.h"
#include "desktop/playback/transport_bar.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/results/results_place.h"
#include "desktop/scene3d/scene_view.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

// Builds the parts of a playback.
namespace chiron::desktop {

void PlaybackScreen::build() {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme, 0);
    page->column()->setSpacing(theme.px(10));
    page->column()->addWidget(headBox());
    const database::SessionRecord& record = m_data->record;
    if (record.summary.state == database::SessionState::voided)
        page->column()->addWidget(kit::notice(
            theme, "warning", tr("Declared void: %1").arg(QString::fromStdString(record.voidReason))));
    else if (!record.decisions.empty())
        page->column()->addWidget(kit::notice(
            theme, "info",
            tr("This session was void and counts again. The debrief says who decided it and why.")));
    auto* row = new ResponsiveRow(theme.px(820), theme.px(14));
    row->add(stageColumn(), 3);
    row->add(sideColumn(), 2);
    page->column()->addWidget(row, 1);
    page->installEventFilter(this);
    m_panel->setContent(page);
    fitScene();
}

QWidget* PlaybackScreen::headBox() {
    const Theme& theme = context().theme();
    const database::SessionSummary& summary = m_data->record.summary;
    auto* row = new ResponsiveRow(theme.px(700), theme.px(8));
    auto* words = new QWidget;
    auto* column = new QVBoxLayout(words);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    const QString language = context().language();
    const QString level =
        QString::fromStdString(catalogue::textIn(m_data->setup.level.title, language.toStdString()));
    const QString exercise = exerciseTitle(context().site().catalogue(), summary.exercise, language);
    const QString number = context().locale().toString(summary.level);
    column->addWidget(kit::label(
        theme,
        summary.attempt > 0 ? tr("%1, attempt %2 at level %3: %4")
                                  .arg(exercise, context().locale().toString(summary.attempt), number, level)
                            : tr("%1, level %2: %3").arg(exercise, number, level),
        TextStyle::title));
    column->addWidget(kit::label(theme,
                                 tr("%1 · %2 · %3 · %4")
                                     .arg(whoText(summary), whenText(summary, context().locale()),
                                          outcomeText(summary), forceText(summary)),
                                 TextStyle::small, "muted"));
    row->add(words, 1);
    auto* debrief = kit::button(theme, tr("Debrief"), "", QStringLiteral("view-statistics"));
    debrief->setObjectName(QStringLiteral("playback.debrief"));
    connect(debrief, &QPushButton::clicked, this, [this] {
        context().navigator().go(QStringLiteral("debrief"),
                                 {{QStringLiteral("session"), qlonglong(sessionId())}});
    });
    row->add(debrief, 0);
    if (const QString command = resultsCommand(context(), summary); !command.isEmpty()) {
        auto* results = kit::button(theme, command, "", QStringLiteral("office-chart-line"));
        results->setObjectName(QStringLiteral("playback.results"));
        connect(results, &QPushButton::clicked, this, &PlaybackScreen::openResults);
        row->add(results, 0);
    }
    const bool offers = context().has(database::Role::trainer) || context().has(database::Role::admin);
    if (offers && summary.state != database::SessionState::running) {
        const bool voided = summary.state == database::SessionState::voided;
        auto* button = voided ? kit::button(theme, tr("Count it again …"), "", QStringLiteral("edit-undo"))
                              : kit::button(theme, tr("Declare void …"), "", QStringLiteral("dialog-cancel"));
        button->setObjectName(voided ? QStringLiteral("playback.reinstate")
                                     : QStringLiteral("playback.void"));
        connect(button, &QPushButton::clicked, this, &PlaybackScreen::askDecision);
        row->add(button, 0);
    }
    return row;
}

void PlaybackScreen::fitScene() {
    if (!m_sceneFrame)
        return;
    // Uses the height that leaves head, time bar and both plots visible; if the window is too low for that,
    // the scene stays high enough to see.
    constexpr int kRest_px = 500;
    const Theme& theme = context().theme();
    m_sceneFrame->setFixedHeight(std::clamp(height() - theme.px(kRest_px), theme.px(240), theme.px(700)));
}

QWidget* PlaybackScreen::stageColumn() {
    const Theme& theme = context().theme();
    const QLocale locale = context().locale();
    auto* stage = new QWidget;
    auto* column = new QVBoxLayout(stage);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(4));
    auto* holder = new QFrame;
    holder->setProperty("kind", QStringLiteral("raised"));
    m_sceneFrame = holder;
    m_sceneHolder = new QVBoxLayout(holder);
    m_sceneHolder->setContentsMargins(theme.px(1), theme.px(1), theme.px(1), theme.px(1));
    column->addWidget(holder, 1);
    column->addWidget(readoutRow());
    if (QWidget* switches = switchRow())
        column->addWidget(switches);
    if (const QString words = m_data->layer->lost(); !words.isEmpty()) {
        auto* lost = kit::label(theme, words, TextStyle::small);
        lost->setObjectName(QStringLiteral("playback.layer_lost"));
        column->addWidget(lost);
    }
    m_scrubber = new Scrubber(theme);
    m_scrubber->setObjectName(QStringLiteral("playback.scrubber"));
    m_scrubber->setLocale(locale);
    m_scrubber->setTrack(m_data->track, m_data->setup.level.exercise, momentWords());
    connect(m_scrubber, &Scrubber::seekAsked, &m_clock, &PlaybackClock::seek);
    column->addWidget(m_scrubber);
    std::vector<std::pair<double, double>> pauses_s;
    for (const session::PlaybackSpan& span : m_data->track.paused)
        pauses_s.emplace_back(span.begin_s, span.end_s);
    column->addWidget(new TransportBar(theme, locale, m_clock, momentWords(), std::move(pauses_s)));
    const bool expert = context().has(database::Role::trainer) || context().has(database::Role::researcher) ||
                        context().has(database::Role::admin);
    m_plots =
        new PlaybackPlots(theme, locale, m_data->track, m_data->setup.level, m_data->layer.get(), expert);
    connect(m_plots, &PlaybackPlots::seekAsked, &m_clock, &PlaybackClock::seek);
    column->addWidget(m_plots);
    return stage;
}

QWidget* PlaybackScreen::readoutRow() {
    const Theme& theme = context().theme();
    auto* row = new ResponsiveRow(theme.px(560), theme.px(8));
    m_readout = kit::label(theme, {}, TextStyle::mono);
    m_readout->setObjectName(QStringLiteral("playback.readout"));
    row->add(m_readout, 1);
    for (const PlaybackSwitch& each : m_data->layer->switches())
        if (each.ofPicture)
            row->add(switchBox(each), 0);
    return row;
}

QWidget* PlaybackScreen::switchRow() {
    const Theme& theme = context().theme();
    ResponsiveRow* row = nullptr;
    for (const PlaybackSwitch& each : m_data->layer->switches()) {
        if (each.ofPicture)
            continue;
        if (!row)
            row = new ResponsiveRow(theme.px(560), theme.px(8));
        row->add(switchBox(each));
    }
    return row;
}

QCheckBox* PlaybackScreen::switchBox(const PlaybackSwitch& of) {
    const QString key = QLatin1String(of.key);
    auto* box = new QCheckBox(of.text);
    box->setObjectName(QStringLiteral("playback.%1").arg(key));
    box->setToolTip(of.tip);
    box->setChecked(place().parameters.value(key, of.on).toBool());
    m_data->layer->turn(of.key, box->isChecked());
    connect(box, &QCheckBox::toggled, this, [this, key, ofPicture = of.ofPicture](bool on) {
        m_data->layer->turn(key.toStdString(), on);
        if (ofPicture && m_scene)
            m_scene->change(sceneSetup());
        QVariantMap parameters = context().navigator().current().parameters;
        parameters.insert(key, on);
        context().navigator().note(parameters);
        if (!ofPicture)
            showMoment(m_clock.position_s());
    });
    return box;
}

QWidget* PlaybackScreen::sideColumn() {
    const Theme& theme = context().theme();
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    column->addWidget(ghostBox());
    m_tabs = new QTabWidget;
    m_tabs->setObjectName(QStringLiteral("playback.tabs"));
    m_tabs->setMinimumHeight(theme.px(300));
    auto* marks = new MarkList(theme, context().locale(), m_data->track.marks, m_data->setup.level.exercise,
                               momentWords());
    connect(marks, &MarkList::seekAsked, &m_clock, &PlaybackClock::seek);
    m_tabs->addTab(marks, tr("Events"));
    m_comments = new CommentPanel(theme, context().locale(), momentWords());
    connect(m_comments, &CommentPanel::seekAsked, &m_clock, &PlaybackClock::seek);
    connect(m_comments, &CommentPanel::addAsked, this,
            [this](const QString& text) { addComment(text, m_data->track.tickAt(m_clock.position_s())); });
    connect(m_comments, &CommentPanel::replyAsked, this,
            [this](const QString& text, const NamedComment& to) { addComment(text, to.comment.tick); });
    const bool mine = m_data->record.summary.person == context().actor().personId();
    m_comments->setMayAdd(mine || context().has(database::Role::trainer) ||
                          context().has(database::Role::researcher) || context().has(database::Role::admin));
    m_comments->setMayReview(!mine && context().has(database::Role::trainer) &&
                             !m_data->record.summary.reviewed);
    m_tabs->addTab(m_comments, tr("Comments (C)"));
    if (place().parameters.value(QStringLiteral("tab")).toString() == QLatin1String("comments"))
        m_tabs->setCurrentWidget(m_comments);
    column->addWidget(m_tabs, 1);
    return side;
}

MomentWords PlaybackScreen::momentWords() const {
    return {m_data->track.trials, m_data->record.setup.plannedTrials > 1, context().locale()};
}

QWidget* PlaybackScreen::ghostBox() {
    const Theme& theme = context().theme();
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(2));
    auto* label = kit::label(theme, tr("Second session alongside"), TextStyle::label);
    m_ghostChoice = new QComboBox;
    m_ghostChoice->setObjectName(QStringLiteral("playback.ghost"));
    m_ghostChoice->setAccessibleName(tr("Second session alongside"));
    m_ghostChoice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_ghostChoice->addItem(tr("None"), qlonglong(0));
    label->setBuddy(m_ghostChoice);
    column->addWidget(label);
    column->addWidget(m_ghostChoice);
    connect(m_ghostChoice, &QComboBox::activated, this, &PlaybackScreen::chooseGhost);
    return box;
}

} // namespace chiron::desktop
