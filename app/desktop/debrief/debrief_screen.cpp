// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/debrief_screen.h"

#include "desktop/debrief/advice_words.h"
#include "desktop/debrief/metrics_table.h"
#include "desktop/debrief/report_words.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/results/results_place.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"
#include "report/report_text.h"
#include "report/report_writer.h"
#include "session/exercise_kind.h"
#include "session_report/metric_words.h"

#include <QFileDialog>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr double kLeadIn_s = 3.0; // to see what led to the worst moment
}

DebriefScreen::DebriefScreen(AppContext& context, const Place& place) : Screen(context, place) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    auto* page = new ScrollPage(context.theme());
    m_column = page->column();
    m_panel->setContent(page);
    column->addWidget(m_panel);
}

DebriefScreen::~DebriefScreen() {
    if (m_work)
        m_work->cancel();
}

QString DebriefScreen::title() const {
    return tr("Debrief");
}

QString DebriefScreen::help() const {
    return tr("The result of this session.\n\nAt the top: whether it passed, and if not, which pass mark was "
              "missed and by how much. "
              "Below, the most important numbers on their scale: the pointer is the value, the line the pass "
              "mark, the band what others "
              "reached.\n\n\"Watch the worst moment\" opens the playback where it went wrong most. "
              "\"Report\" writes a printable PDF. The table "
              "holds every metric with what it means.");
}

std::vector<ScreenCommand> DebriefScreen::commands() {
    std::vector<ScreenCommand> list{
        {tr("Open the playback"), QKeySequence(QStringLiteral("Ctrl+P")), [this] { openPlayback(); }},
        {tr("Write the report (PDF)"), QKeySequence(QStringLiteral("Ctrl+S")), [this] { askReport(); }}};
    if (const QString results = m_head ? resultsCommand(context(), m_head->record.summary) : QString();
        !results.isEmpty())
        list.push_back({results, {}, [this] { openResults(); }});
    return list;
}

database::SessionId DebriefScreen::sessionId() const {
    return place().parameters.value(QStringLiteral("session")).toLongLong();
}

void DebriefScreen::enter() {
    load();
}

void DebriefScreen::load() {
    m_panel->showLoading(tr("Reading the scores …"));
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(), id = sessionId(),
         language = context().language().toStdString()](WorkToken&) -> core::Result<DebriefHead> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return loadDebriefHead(**connection, actor, id, language);
        },
        [this](core::Result<DebriefHead> head) {
            if (head)
                showHead(std::move(*head));
            else
                m_panel->showError(tr("This session could not be opened"), head.error(), [this] { load(); });
        });
}

void DebriefScreen::showHead(DebriefHead head) {
    m_head = std::move(head);
    for (report::MetricRow& row : m_head->report.metrics)
        row.unit = session_report::unitText(row.unit);
    m_column->addWidget(headBox());
    m_column->addWidget(verdictBox());
    if (QWidget* decisions = decisionsBox())
        m_column->addWidget(decisions);
    m_comments = new QVBoxLayout;
    m_column->addLayout(m_comments);
    std::vector<CommentAtMoment> comments;
    for (const NamedComment& named : m_head->comments)
        comments.push_back({named, {}});
    showComments(comments, {});
    if (QWidget* cards = headlineRow())
        m_column->addWidget(cards);
    m_column->addWidget(answersBox());
    m_column->addWidget(forceBox());
    if (!m_head->report.metrics.empty()) {
        m_column->addWidget(kit::label(context().theme(), tr("All metrics"), TextStyle::title));
        const database::SessionState state = m_head->record.summary.state;
        if (state != database::SessionState::completed && state != database::SessionState::voided)
            m_column->addWidget(
                kit::label(context().theme(),
                           tr("The session was not completed: these values are not compared with pass "
                              "marks."),
                           TextStyle::small, "muted"));
        m_column->addWidget(new MetricsTable(context().theme(), m_head->report.metrics, context().locale()));
    } else if (m_head->record.summary.state != database::SessionState::completed) {
        auto* none = kit::label(context().theme(), tr("No trial was completed: there is no score."),
                                TextStyle::body, "muted");
        none->setObjectName(QStringLiteral("debrief.no_score"));
        m_column->addWidget(none);
    }
    m_column->addStretch();
    m_panel->showContent();
    focusNextStep();
    loadDetails();
}

// The keyboard focus starts at the next step instead of the navigation. After a session that has just ended,
// Tab leads there instead, so that a key meant for the last trial presses no button.
void DebriefScreen::focusNextStep() {
    if (place().parameters.value(QString::fromLatin1(kJustEnded)).toBool()) {
        setFocus(Qt::OtherFocusReason);
        return;
    }
    for (const char* name : {"debrief.next", "debrief.now_you", "debrief.again", "debrief.playback"}) {
        auto* button = findChild<QPushButton*>(QLatin1String(name));
        if (button && button->isEnabled()) {
            button->setFocus();
            return;
        }
    }
}

void DebriefScreen::loadDetails() {
    if (m_head->record.summary.recordingErased) {
        m_worstText->hide();
        m_answers->showEmpty(tr("The recording was erased"),
                             tr("It was erased at the person's request. The scores above are kept; there "
                                "is nothing to play back."));
        return;
    }
    database::Database& database = context().site().database();
    m_work = context().background().run(
        this,
        [&database, actor = context().actor(),
         id = sessionId()](WorkToken& token) -> core::Result<DebriefDetails> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return loadDebriefDetails(**connection, actor, id, token.flag());
        },
        [this](core::Result<DebriefDetails> details) {
            if (details)
                showDetails(*details);
            else
                showNoDetails(details.error());
        });
    m_answers->showLoading(tr("Reading the recording …"), m_work);
}

void DebriefScreen::showNoDetails(const core::Error& error) {
    m_worstText->hide();
    m_answers->showError(tr("The recording could not be read. The scores above are as they were stored."),
                         error);
}

void DebriefScreen::showDetails(const DebriefDetails& details) {
    m_worstMoment = details.worst;
    if (details.worst)
        showWorst(*details.worst);
    else
        m_worstText->setText(tr("No moment stands out."));
    completeAdvice(details.missed);
    showForce(details.force);
    showComments(details.comments,
                 {details.trials, m_head->record.setup.plannedTrials > 1, context().locale()});
    if (!details.part)
        return m_answers->showError(details.part.error().words, details.part.error().why);
    const DebriefPart* part = details.part->get();
    if (auto shown = part ? part->widget(context().theme(), context().locale()) : nullptr) {
        m_answers->setContent(shown.release()); // the panel owns it now
        m_answers->showContent();
    } else
        m_answers->showEmpty(tr("No trial was finished"), m_head->face->debriefEmpty());
}

void DebriefScreen::showForce(const report::ForceFacts& force) {
    m_force->setText(report::feltWords(force, m_head->record.summary.felt, context().locale()));
    m_force->show();
    const QString beyond = report::beyondCheckedWords(force, context().locale());
    m_beyond->setText(beyond);
    m_beyond->setVisible(!beyond.isEmpty());
}

void DebriefScreen::showWorst(const session::WorstMoment& worst) {
    const QLocale locale = context().locale();
    const QString metric = session_report::momentTitle(QString::fromStdString(worst.reason));
    // The trial's time is counted as on the training screen, because the playback's clock starts before the
    // trial.
    const QString into = clockText(worst.intoTrial_s, locale);
    // A count concerns the whole session, and only one of the events happened here.
    const bool counted = worst.unit == "count";
    const QString what =
        counted ? metric
                : tr("%1: %2").arg(
                      metric,
                      report::formatValue(
                          worst.value, session_report::unitText(QString::fromStdString(worst.unit)), locale));
    const QString where =
        m_head->record.setup.plannedTrials > 1
            ? tr("%1 in trial %2, %3 after it began").arg(what, locale.toString(worst.trial + 1), into)
            : tr("%1, %2 after the start").arg(what, into);
    const QString inRecording = tr("%1 (%2 in the recording)").arg(where, clockText(worst.t_s, locale));
    m_worst->setToolTip(inRecording);
    m_worst->setAccessibleDescription(inRecording);
    m_worstText->setText(tr("Worst moment: %1").arg(where));
    m_worst->setEnabled(true);
}

// The advice stands there from the beginning; what the recording shows of the moment is put before it.
void DebriefScreen::completeAdvice(const std::vector<session::WorstMoment>& missed) {
    const database::SessionRecord& record = m_head->record;
    for (const AdviceLine& line : m_advice)
        for (const session::WorstMoment& moment : missed)
            if (moment.reason == line.advice.metric) {
                const QString sentence = momentSentence(line.advice.moment, moment, record.summary.exercise,
                                                        record.setup.plannedTrials > 1, context().locale());
                QStringList sentences{sentence, line.advice.text};
                sentences.removeAll(QString());
                line.label->setText(sentences.join(QLatin1Char(' ')));
                line.label->setVisible(!sentences.isEmpty());
            }
}

bool DebriefScreen::isMine() const {
    return m_head && m_head->record.summary.person == context().actor().personId() &&
           m_head->record.summary.operatorName.empty();
}

bool DebriefScreen::hasNextLevel() const {
    return context().site().catalogue().find(m_head->record.summary.exercise,
                                             m_head->record.summary.level + 1) != nullptr;
}

bool DebriefScreen::mayTryNow() const {
    const database::SessionSummary& summary = m_head->record.summary;
    return !summary.operatorName.empty() && summary.person == database::Actor::kSimulatedPerson &&
           context().site().catalogue().find(summary.exercise, summary.level) != nullptr;
}

std::optional<TrainingPlan> DebriefScreen::demonstration() const {
    const database::SessionSummary& summary = m_head->record.summary;
    return context().site().catalogue().find(summary.exercise, summary.level)
               ? expertPlan(summary.exercise, summary.level)
               : std::nullopt;
}

void DebriefScreen::openPlayback(QVariantMap at) {
    at.insert(QStringLiteral("session"), qlonglong(sessionId()));
    context().navigator().go(QStringLiteral("playback"), at);
}

void DebriefScreen::openWorst() {
    if (!m_worstMoment)
        return;
    const double t_s = m_worstMoment->t_s;
    openPlayback({{QStringLiteral("at_s"), std::max(0.0, t_s - kLeadIn_s)},
                  {QStringLiteral("caption"), m_worstText->text()},
                  {QStringLiteral("caption_s"), t_s}});
}

void DebriefScreen::openComment(double at_s, const QString& words) {
    openPlayback({{QStringLiteral("at_s"), std::max(0.0, at_s - kLeadIn_s)},
                  {QStringLiteral("caption"), words},
                  {QStringLiteral("caption_s"), at_s},
                  {QStringLiteral("tab"), QStringLiteral("comments")}});
}

void DebriefScreen::openSetup(int level) {
    context().navigator().go(
        QStringLiteral("exercise_setup"),
        {{QStringLiteral("exercise"), QString::fromStdString(m_head->record.summary.exercise)},
         {QStringLiteral("level"), level}});
}

void DebriefScreen::openResults() {
    context().navigator().go(resultsPlace(m_head->record.summary));
}

void DebriefScreen::askReport() {
    if (!m_head || m_head->record.summary.recordingErased)
        return;
    const QString name = tr("Chiron session %1.pdf").arg(sessionId());
    auto* dialog = new QFileDialog(this, tr("Write the report"), QString(), tr("PDF documents (*.pdf)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("reports"));
    dialog->selectFile(name);
    connect(dialog, &QFileDialog::fileSelected, this, &DebriefScreen::writeReport);
    dialog->open();
}

void DebriefScreen::writeReport(const QString& path) {
    m_report->setEnabled(false);
    context().messages().information(tr("Writing the report …"));
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(), id = sessionId(),
         language = context().language().toStdString()](WorkToken&) -> core::Result<report::ReportData> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return loadReport(**connection, actor, id, language);
        },
        [this, path](core::Result<report::ReportData> loaded) {
            m_report->setEnabled(true);
            if (loaded)
                translateReport(*loaded,
                                {whoText(m_head->record.summary),
                                 exerciseTitle(context().site().catalogue(), m_head->record.summary.exercise,
                                               context().language()),
                                 deviceText(m_head->setup.devices.front())});
            // Paper is always light, so the report uses its own theme instead of the screen's.
            const core::Result<void> written =
                loaded ? report::writeSessionPdf(path, *loaded, report::lightTheme(context().locale()))
                       : core::Result<void>(tl::unexpected(loaded.error()));
            if (written)
                context().messages().done(tr("The report was written to %1.").arg(path));
            else
                context().messages().error(tr("The report could not be written."), written.error());
        });
}

} // namespace chiron::desktop
