// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/debrief_screen.h"

#include "desktop/debrief/metrics_table.h"
#include "desktop/debrief/palpation_box.h"
#include "desktop/debrief/report_words.h"
#include "desktop/frame/app_context.h"
#include "desktop/plots/metric_words.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/plots/session_words.h"
#include "desktop/training/endoscopy.h"
#include "desktop/training/palpating.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"
#include "report/report_text.h"
#include "report/report_writer.h"
#include "report/session_plots.h"

#include <QFileDialog>

namespace chiron::desktop {

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
    return tr("What this session came to.\n\nAt the top: whether it passed, and if not, which pass mark was missed and by how much. "
              "Below, the most important numbers on their scale: the pointer is the value, the line the pass mark, the band what "
              "others reached.\n\n\"Worst moment\" opens the playback where it went wrong most. \"Report\" writes a printable PDF. "
              "The table holds every metric; choose a row to read what it means.");
}

std::vector<ScreenCommand> DebriefScreen::commands() {
    return {{tr("Open the playback"), QKeySequence(QStringLiteral("Ctrl+P")), [this] { openPlayback({}); }},
            {tr("Write the report (PDF)"), QKeySequence(QStringLiteral("Ctrl+S")), [this] { askReport(); }}};
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
        [&database, actor = context().actor(), id = sessionId(), language = context().language().toStdString()](WorkToken&) {
            auto connection = database.openReader();
            return connection ? loadDebriefHead(**connection, actor, id, language) : core::Result<DebriefHead>(tl::unexpected(connection.error()));
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
        row.unit = unitText(row.unit);
    m_column->addWidget(headBox());
    m_column->addWidget(verdictBox());
    if (!m_head->report.metrics.empty())
        m_column->addWidget(headlineRow());
    m_column->addWidget(answersBox());
    if (!m_head->report.metrics.empty()) {
        m_column->addWidget(kit::label(context().theme(), tr("All metrics"), TextStyle::title));
        m_column->addWidget(new MetricsTable(context().theme(), m_head->report.metrics, context().locale()));
    }
    m_column->addStretch();
    m_panel->showContent();
    focusNextStep();
    loadDetails();
}

// The keyboard begins at what there is to do now, instead of at the navigation.
void DebriefScreen::focusNextStep() {
    for (const char* name : {"debrief.next", "debrief.again", "debrief.playback"}) {
        auto* button = findChild<QPushButton*>(QLatin1String(name));
        if (button && button->isEnabled()) {
            button->setFocus();
            return;
        }
    }
}

void DebriefScreen::loadDetails() {
    if (m_head->record.summary.recordingErased) {
        m_answers->showEmpty(tr("The recording was erased"), tr("It was withdrawn at the person's wish. The scores above are kept; there is nothing to play back."));
        return;
    }
    database::Database& database = context().site().database();
    m_work = context().background().run(
        this,
        [&database, actor = context().actor(), id = sessionId()](WorkToken& token) {
            auto connection = database.openReader();
            return connection ? loadDebriefDetails(**connection, actor, id, token.flag())
                              : core::Result<DebriefDetails>(tl::unexpected(connection.error()));
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
    m_answers->showError(tr("The recording could not be read. The scores above are as they were stored."), error);
}

void DebriefScreen::showDetails(const DebriefDetails& details) {
    m_worstMoment = details.worst;
    if (details.worst)
        showWorst(*details.worst);
    if (details.insertion)
        showInsertion(*details.insertion);
    else if (!details.palpation.empty())
        showPalpation(details.palpation);
    else if (details.palpationLost)
        m_answers->showError(tr("Findings and maps could not be read from the recording. The scores above are as they were stored."), *details.palpationLost);
    else if (!details.answers.empty())
        showAnswers(details.answers);
    else
        m_answers->showEmpty(tr("No trial was begun"), endoscopyOf(m_head->setup.level)
                                                           ? tr("There is nothing to show of the procedure. The session is kept and listed.")
                                                           : tr("There is no answer to show. The session is kept and listed."));
}

void DebriefScreen::showWorst(const session::WorstMoment& worst) {
    const QLocale locale = context().locale();
    const QString metric = metricTitle(QString::fromStdString(worst.reason));
    const QString value = report::formatValue(worst.value, unitText(QString::fromStdString(worst.unit)), locale);
    const QString at = clockText(worst.t_s, locale);
    m_worst->setText(tr("Worst moment"));
    m_worst->setToolTip(m_head->record.setup.plannedTrials > 1
                            ? tr("%1: %2 in trial %3, at %4").arg(metric, value, locale.toString(worst.trial + 1), at)
                            : tr("%1: %2, at %3").arg(metric, value, at));
    m_worst->setAccessibleDescription(m_worst->toolTip());
    m_worst->setEnabled(true);
}

void DebriefScreen::showAnswers(const std::vector<report::ApexError>& answers) {
    const Theme& theme = context().theme();
    const report::PlotTheme look = plotThemeOf(theme, context().locale());
    auto* row = new ResponsiveRow(theme.px(640), theme.px(12));
    auto scatter = report::apexScatterPlot(answers, look);
    auto trials = report::apexTrialPlot(answers, look);
    scatter->setObjectName(QStringLiteral("debrief.scatter"));
    for (report::PlotView* view : {scatter.get(), trials.get()})
        view->setMinimumHeight(theme.px(280));
    row->add(scatter.release(), 2); // the row owns them from here on
    row->add(trials.release(), 3);
    m_answers->setContent(row);
    m_answers->showContent();
}

void DebriefScreen::showPalpation(const std::vector<session::PalpationTrialRecord>& records) {
    const auto* level = palpationOf(m_head->setup.level);
    m_answers->setContent(new PalpationBox(context().theme(), context().locale(), *level, records));
    m_answers->showContent();
}

void DebriefScreen::showInsertion(const report::InsertionProfile& profile) {
    const Theme& theme = context().theme();
    const QLocale locale = context().locale();
    const report::PlotTheme look = plotThemeOf(theme, locale);
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    if (profile.landmarks > 0) {
        auto* seen = kit::label(theme, tr("%1 of %2 landmarks of the bladder were seen.").arg(locale.toString(profile.landmarksSeen), locale.toString(profile.landmarks)));
        seen->setObjectName(QStringLiteral("debrief.landmarks"));
        column->addWidget(seen);
    }
    auto* row = new ResponsiveRow(theme.px(640), theme.px(12));
    auto offset = report::offsetDepthPlot(profile, look);
    auto alignment = report::alignmentDepthPlot(profile, look);
    offset->setObjectName(QStringLiteral("debrief.offset"));
    alignment->setObjectName(QStringLiteral("debrief.alignment"));
    for (report::PlotView* view : {offset.get(), alignment.get()})
        view->setMinimumHeight(theme.px(250));
    row->add(offset.release()); // the row owns them from here on
    row->add(alignment.release());
    column->addWidget(row);
    m_answers->setContent(holder);
    m_answers->showContent();
}

bool DebriefScreen::isMine() const {
    return m_head && m_head->record.summary.person == context().actor().personId() && m_head->record.summary.operatorName.empty();
}

bool DebriefScreen::hasNextLevel() const {
    return context().site().catalogue().find(m_head->record.summary.exercise, m_head->record.summary.level + 1) != nullptr;
}

void DebriefScreen::openPlayback(std::optional<double> at_s) {
    QVariantMap parameters{{QStringLiteral("session"), qlonglong(sessionId())}};
    if (at_s)
        parameters.insert(QStringLiteral("at_s"), *at_s);
    context().navigator().go(QStringLiteral("playback"), parameters);
}

void DebriefScreen::openSetup(int level) {
    context().navigator().go(QStringLiteral("exercise_setup"),
                             {{QStringLiteral("exercise"), QString::fromStdString(m_head->record.summary.exercise)},
                              {QStringLiteral("level"), level}});
}

void DebriefScreen::askReport() {
    if (!m_head || m_head->record.summary.recordingErased)
        return;
    const QString name = tr("Chiron session %1.pdf").arg(sessionId());
    auto* dialog = new QFileDialog(this, tr("Write the report"), name, tr("PDF documents (*.pdf)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, &DebriefScreen::writeReport);
    dialog->open();
}

void DebriefScreen::writeReport(const QString& path) {
    m_report->setEnabled(false);
    context().messages().information(tr("Writing the report …"));
    database::Database& database = context().site().database();
    context().background().run(
        this,
        [&database, actor = context().actor(), id = sessionId(), language = context().language().toStdString()](WorkToken&) {
            auto connection = database.openReader();
            return connection ? loadReport(**connection, actor, id, language) : core::Result<report::ReportData>(tl::unexpected(connection.error()));
        },
        [this, path](core::Result<report::ReportData> loaded) {
            m_report->setEnabled(true);
            if (loaded)
                translateReport(*loaded, {whoText(m_head->record.summary),
                                          exerciseTitle(context().site().catalogue(), m_head->record.summary.exercise, context().language()),
                                          deviceText(m_head->setup.devices.front())});
            // Paper is always light: the report's own theme, not the screen's.
            const core::Result<void> written = loaded ? report::writeSessionPdf(path, *loaded, report::lightTheme(context().locale()))
                                                    : core::Result<void>(tl::unexpected(loaded.error()));
            if (written)
                context().messages().done(tr("The report was written to %1.").arg(path));
            else
                context().messages().error(tr("The report could not be written."), written.error());
        });
}

} // namespace chiron::desktop
