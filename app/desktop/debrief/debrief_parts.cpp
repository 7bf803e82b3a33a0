// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/debrief_screen.h"
#include "desktop/debrief/headline_card.h"
#include "desktop/debrief/practice_level.h"
#include "desktop/debrief/verdict.h"
#include "desktop/frame/app_context.h"
#include "desktop/home/comment_list.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/results/results_place.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"
#include "report/report_text.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <algorithm>

// Builds the parts of a debrief.
namespace chiron::desktop {

namespace {}

QWidget* DebriefScreen::headBox() {
    const Theme& theme = context().theme();
    const database::SessionSummary& summary = m_head->record.summary;
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(2));
    const QString exercise =
        exerciseTitle(context().site().catalogue(), summary.exercise, context().language());
    const QString level = QString::fromStdString(
        catalogue::textIn(m_head->setup.level.title, context().language().toStdString()));
    const QString number = context().locale().toString(summary.level);
    auto* heading = kit::label(
        theme,
        summary.attempt > 0 ? tr("%1, attempt %2 at level %3: %4")
                                  .arg(exercise, context().locale().toString(summary.attempt), number, level)
                            : tr("%1, level %2: %3").arg(exercise, number, level),
        TextStyle::heading);
    heading->setObjectName(QStringLiteral("debrief.title"));
    column->addWidget(heading);
    const QString device = deviceText(m_head->setup.devices.front());
    auto* facts = kit::label(
        theme,
        tr("%1 · %2 · %3 · %4")
            .arg(whoText(summary), whenText(summary, context().locale()), device, forceText(summary)),
        TextStyle::body, "muted");
    facts->setObjectName(QStringLiteral("debrief.facts"));
    column->addWidget(facts);
    if (!summary.felt)
        column->addWidget(kit::label(
            theme,
            tr("Force was shown, not felt: these scores form a separate series and are not compared with "
               "scores from felt force."),
            TextStyle::small, "muted"));
    return box;
}

QWidget* DebriefScreen::verdictBox() {
    const Theme& theme = context().theme();
    const Verdict verdict = verdictOf(*m_head, context().locale(), adviceNow());
    const kit::Box box = kit::box(theme, verdict.kind);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme.px(14));
    auto* sign = new QLabel;
    const Colour ink = qstrcmp(verdict.kind, "good") == 0      ? Colour::good
                       : qstrcmp(verdict.kind, "warning") == 0 ? Colour::warning
                       : qstrcmp(verdict.kind, "bad") == 0     ? Colour::bad
                                                               : Colour::accent;
    sign->setPixmap(theme.icon(verdict.icon, ink).pixmap(theme.px(40), theme.px(40)));
    row->addWidget(sign, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->setSpacing(theme.px(4));
    auto* heading = kit::label(theme, verdict.title, TextStyle::heading);
    heading->setObjectName(QStringLiteral("debrief.verdict"));
    words->addWidget(heading);
    auto* text = kit::label(theme, verdict.text);
    text->setObjectName(QStringLiteral("debrief.verdict_text"));
    words->addWidget(text);
    for (qsizetype i = 0; i < verdict.reasons.size(); ++i) {
        auto* line = kit::label(theme, QStringLiteral("•  %1").arg(verdict.reasons[i]), TextStyle::strong);
        line->setObjectName(QStringLiteral("debrief.reason"));
        words->addWidget(line);
        const auto index = static_cast<std::size_t>(i);
        addAdvice(verdict.advice[index], *words);
        // Pass marks in a row that are practised on the same level share a button.
        const catalogue::ExerciseLevel* level = practisedAt(verdict.advice[index]);
        const bool last = index + 1 == verdict.advice.size();
        if (level && (last || practisedAt(verdict.advice[index + 1]) != level))
            words->addWidget(practiceButton(*level), 0, Qt::AlignLeft);
    }
    if (const QString change = changeText(*m_head, context().locale(), isMine()); !change.isEmpty()) {
        auto* line = kit::label(theme, change, TextStyle::body, "muted");
        line->setObjectName(QStringLiteral("debrief.change"));
        words->addWidget(line);
    }
    // This placeholder keeps the buttons in place when the result arrives.
    m_worstText = kit::label(theme, tr("Looking for the worst moment …"), TextStyle::body, "muted");
    m_worstText->setObjectName(QStringLiteral("debrief.worst_text"));
    words->addWidget(m_worstText);
    row->addLayout(words, 1);
    box.layout->addLayout(row);
    box.layout->addWidget(actionRow());
    return box.frame;
}

void DebriefScreen::addAdvice(const MetricAdvice& advice, QVBoxLayout& words) {
    const Theme& theme = context().theme();
    auto* coach = kit::label(theme, advice.text);
    coach->setObjectName(QStringLiteral("debrief.advice"));
    coach->setContentsMargins(theme.px(14), 0, 0, theme.px(4));
    if (advice.text.isEmpty())
        coach->hide(); // until the recording has something to add
    words.addWidget(coach);
    m_advice.push_back({advice, coach});
}

const catalogue::ExerciseLevel* DebriefScreen::practisedAt(const MetricAdvice& advice) const {
    const database::SessionSummary& summary = m_head->record.summary;
    const catalogue::Exercise* exercise = context().site().catalogue().find(summary.exercise);
    return exercise && isMine() ? practiceLevel(*exercise, summary.level, advice.metric) : nullptr;
}

QWidget* DebriefScreen::practiceButton(const catalogue::ExerciseLevel& level) {
    const QString title =
        QString::fromStdString(catalogue::textIn(level.title, context().language().toStdString()));
    auto* button = kit::button(context().theme(),
                               tr("Practise it on level %1").arg(context().locale().toString(level.number)),
                               "quiet", QStringLiteral("go-next"));
    button->setObjectName(QStringLiteral("debrief.practise"));
    button->setToolTip(title); // a title as long as content likes would not fit every window
    connect(button, &QPushButton::clicked, this, [this, number = level.number] { openSetup(number); });
    return button;
}

// For a session that is void, or was void and counts again: who decided what, and why.
QWidget* DebriefScreen::decisionsBox() {
    const std::vector<database::SessionDecision>& decisions = m_head->record.decisions;
    if (decisions.empty())
        return nullptr;
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("debrief.decisions"));
    box.layout->addWidget(kit::label(theme, tr("What was decided about this session"), TextStyle::title));
    for (const database::SessionDecision& decision : decisions) {
        const auto name = m_head->deciders.find(decision.person);
        const QString who = name == m_head->deciders.end() ? tr("somebody whose account is closed")
                                                           : QString::fromStdString(name->second);
        const QDateTime when = QDateTime::fromString(QString::fromStdString(decision.utc), Qt::ISODateWithMs);
        const QString why =
            decision.reason.empty() ? tr("(erased)") : QString::fromStdString(decision.reason);
        const QString day = context().locale().toString(when.toLocalTime(), QLocale::ShortFormat);
        auto* line =
            kit::label(theme, decision.voiding ? tr("Voided on %1 by %2: %3").arg(day, who, why)
                                               : tr("Set to count again on %1 by %2: %3").arg(day, who, why));
        line->setObjectName(QStringLiteral("debrief.decision"));
        box.layout->addWidget(line);
    }
    return box.frame;
}

std::vector<MetricAdvice> DebriefScreen::adviceNow() const {
    std::vector<MetricAdvice> advice;
    const auto inLanguage = [language =
                                 context().language().toStdString()](const catalogue::Translated& text) {
        return QString::fromStdString(catalogue::textIn(text, language));
    };
    if (const catalogue::Exercise* exercise =
            context().site().catalogue().find(m_head->record.summary.exercise))
        for (const catalogue::Advice& one : exercise->advice)
            advice.push_back({one.metric, inLanguage(one.text), inLanguage(one.moment)});
    return advice;
}

QWidget* DebriefScreen::actionRow() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar); // wraps, because the buttons may be wider than the window
    const bool passed = m_head->report.passed.value_or(false) &&
                        m_head->record.summary.state == database::SessionState::completed;
    const int level = m_head->record.summary.level;
    if (isMine() && passed && hasNextLevel()) {
        auto* next = kit::button(theme, tr("Next level"), "primary", QStringLiteral("go-next"));
        next->setObjectName(QStringLiteral("debrief.next"));
        connect(next, &QPushButton::clicked, this, [this, level] { openSetup(level + 1); });
        row->addWidget(next);
    }
    if (mayTryNow()) {
        auto* now = kit::button(theme, tr("Now you"), "primary", QStringLiteral("go-next"));
        now->setObjectName(QStringLiteral("debrief.now_you"));
        connect(now, &QPushButton::clicked, this, [this, level] { openSetup(level); });
        row->addWidget(now);
    }
    if (isMine()) {
        const QString words =
            m_head->record.summary.familiarisation ? tr("Start a session that counts") : tr("Try again");
        auto* again = kit::button(theme, words, passed ? "" : "primary", QStringLiteral("view-refresh"));
        again->setObjectName(QStringLiteral("debrief.again"));
        connect(again, &QPushButton::clicked, this, [this, level] { openSetup(level); });
        row->addWidget(again);
    }
    if (const auto expert = demonstration(); expert && isMine() && !passed) {
        auto* watch = kit::button(theme, tr("Watch an expert"), "", QStringLiteral("view-visible"));
        watch->setObjectName(QStringLiteral("debrief.watch"));
        connect(watch, &QPushButton::clicked, this, [this, plan = *expert] {
            context().navigator().go(QStringLiteral("training"), plan.toMap());
        });
        row->addWidget(watch);
    }
    const bool erased = m_head->record.summary.recordingErased;
    m_worst = kit::button(theme, tr("Watch the worst moment"), "", QStringLiteral("go-jump"));
    m_worst->setObjectName(QStringLiteral("debrief.worst"));
    m_worst->setEnabled(false); // until the recording has been read
    connect(m_worst, &QPushButton::clicked, this, &DebriefScreen::openWorst);
    row->addWidget(m_worst);
    auto* playback = kit::button(theme, tr("Playback"), "", QStringLiteral("media-playback-start"));
    playback->setObjectName(QStringLiteral("debrief.playback"));
    playback->setEnabled(!erased);
    connect(playback, &QPushButton::clicked, this, [this] { openPlayback(); });
    row->addWidget(playback);
    if (const QString words = resultsCommand(context(), m_head->record.summary); !words.isEmpty()) {
        auto* results = kit::button(theme, words, "", QStringLiteral("office-chart-line"));
        results->setObjectName(QStringLiteral("debrief.results"));
        connect(results, &QPushButton::clicked, this, &DebriefScreen::openResults);
        row->addWidget(results);
    }
    m_report = kit::button(theme, tr("Report (PDF)"), "", QStringLiteral("document-save"));
    m_report->setObjectName(QStringLiteral("debrief.report"));
    m_report->setEnabled(!erased);
    connect(m_report, &QPushButton::clicked, this, &DebriefScreen::askReport);
    row->addWidget(m_report);
    return bar;
}

// A trainer's comments are what the reader came for, so they stand above the numbers, each with a link to its
// moment.
void DebriefScreen::showComments(const std::vector<CommentAtMoment>& comments, const MomentWords& moments) {
    const Theme& theme = context().theme();
    const auto person = context().actor().personId();
    // The comments in order of writing; the screen shows them in order of time.
    std::vector<const database::SessionComment*> written;
    for (const CommentAtMoment& comment : comments)
        written.push_back(&comment.named.comment);
    std::sort(written.begin(), written.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
    std::vector<database::PersonId> authors;
    for (const database::SessionComment* comment : written)
        authors.push_back(comment->author);
    if (context().settings().ofPerson(person, commentsSeenKey(sessionId()), 0).toInt() <
        newsUpTo(authors, person, m_head->record.summary.person == person))
        context().setUnread(std::max(0, context().unread() - 1));
    context().settings().setOfPerson(person, commentsSeenKey(sessionId()), static_cast<int>(comments.size()));
    delete m_commentBox; // shown without moments until the recording has been read
    m_commentBox = nullptr;
    if (comments.empty())
        return;
    const kit::Box box = kit::box(theme, "info");
    m_commentBox = box.frame;
    box.frame->setObjectName(QStringLiteral("debrief.comments"));
    box.layout->addWidget(kit::label(theme, tr("Comments"), TextStyle::title));
    for (const CommentAtMoment& comment : comments) {
        const database::SessionComment& stored = comment.named.comment;
        const QString author = stored.author == context().actor().personId() ? tr("You")
                               : comment.named.author.empty()                ? tr("Somebody else")
                                                              : QString::fromStdString(comment.named.author);
        const QString text = stored.text.empty() ? tr("(erased)") : QString::fromStdString(stored.text);
        auto* line = new QHBoxLayout;
        line->setSpacing(theme.px(12));
        auto* words =
            kit::label(theme, comment.t_s ? tr("%1 · %2: %3").arg(author, moments.at(*comment.t_s), text)
                                          : tr("%1: %2").arg(author, text));
        words->setObjectName(QStringLiteral("debrief.comment"));
        line->addWidget(words, 1);
        if (comment.t_s && !m_head->record.summary.recordingErased) {
            auto* watch = kit::button(theme, tr("Watch"), "", QStringLiteral("go-jump"));
            watch->setObjectName(QStringLiteral("debrief.comment_watch"));
            connect(watch, &QPushButton::clicked, this,
                    [this, at_s = *comment.t_s, caption = words->text()] { openComment(at_s, caption); });
            line->addWidget(watch, 0, Qt::AlignTop);
        }
        if (QWidget* reply = replyButton(stored))
            line->addWidget(reply, 0, Qt::AlignTop);
        box.layout->addLayout(line);
    }
    m_comments->addWidget(box.frame);
}

// Opens the playback for writing a reply, because it shows the comment's moment.
QWidget* DebriefScreen::replyButton(const database::SessionComment& comment) {
    const auto self = context().actor().personId();
    using enum database::Role;
    const bool may = m_head->record.summary.person == self || context().has(trainer) ||
                     context().has(researcher) || context().has(admin);
    if (!may || comment.author == self || m_head->record.summary.recordingErased)
        return nullptr;
    auto* reply = kit::button(context().theme(), tr("Reply"), "", QStringLiteral("edit-comment"));
    reply->setObjectName(QStringLiteral("debrief.comment_reply"));
    connect(reply, &QPushButton::clicked, this, [this, id = comment.id] {
        openPlayback({{QStringLiteral("tab"), QStringLiteral("comments")},
                      {QStringLiteral("reply"), static_cast<qint64>(id)}});
    });
    return reply;
}

QWidget* DebriefScreen::headlineRow() {
    const std::vector<report::MetricRow> rows = report::headlineRows(m_head->report.metrics);
    if (rows.empty())
        return nullptr;
    const Theme& theme = context().theme();
    auto* row = new ResponsiveRow(theme.px(660), theme.px(12));
    for (const report::MetricRow& metric : rows)
        row->add(new HeadlineCard(theme, metric, context().locale()));
    return row;
}

QWidget* DebriefScreen::forceBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Force of the tissue, and what was felt"), TextStyle::title));
    m_force = kit::label(theme, {});
    m_force->setObjectName(QStringLiteral("debrief.felt"));
    m_force->hide(); // until the recording has been read
    m_beyond = kit::label(theme, {}, TextStyle::strong, "warning");
    m_beyond->setObjectName(QStringLiteral("debrief.beyond"));
    m_beyond->hide();
    box.layout->addWidget(m_force);
    box.layout->addWidget(m_beyond);
    return box.frame;
}

QWidget* DebriefScreen::answersBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, m_head->face->debriefTitle(), TextStyle::title));
    m_answers = new StatePanel(theme);
    m_answers->setMinimumHeight(theme.px(290));
    box.layout->addWidget(m_answers);
    return box.frame;
}

} // namespace chiron::desktop
