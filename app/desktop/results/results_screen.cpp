// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/results/results_screen.h"

#include "desktop/exercise_face.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/results/attempts_table.h"
#include "desktop/results/learning_curve.h"
#include "desktop/results/results_part.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"
#include "session/level_limits.h"
#include "session_report/metric_words.h"
#include "session_report/session_report.h"

#include <QComboBox>
#include <QFileDialog>
#include <QProgressDialog>
#include <QTimer>

namespace chiron::desktop {

ResultsScreen::ResultsScreen(AppContext& context, const Place& place) : Screen(context, place) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel);
}

ResultsScreen::~ResultsScreen() {
    for (const auto& work : {m_work, m_export})
        if (work)
            work->cancel();
}

database::PersonId ResultsScreen::person() const {
    return place()
        .parameters.value(QStringLiteral("person"), qlonglong(context().actor().personId()))
        .toLongLong();
}

bool ResultsScreen::isOwn() const {
    return person() == context().actor().personId();
}

QString ResultsScreen::title() const {
    return isOwn() ? tr("My results")
                   : tr("Results of %1").arg(place().parameters.value(QStringLiteral("name")).toString());
}

QString ResultsScreen::help() const {
    if (!isOwn())
        return tr("The results of one person.\n\nChoose an exercise, a level and a metric. The curve has a "
                  "point for each completed attempt; attempts with "
                  "felt force and attempts with force shown only are never compared. Press Enter or "
                  "double-click to open an attempt.");
    return tr("All your sessions, and your progress.\n\nChoose an exercise, a level and a metric. The curve "
              "has a point for each completed "
              "attempt. Attempts with felt force and attempts with force shown only have separate lines and "
              "are never compared. The "
              "horizontal line is the pass mark; the band shows what others reached.\n\nPress Enter or "
              "double-click to open an attempt. "
              "\"Export my data\" writes everything that is stored about you to a folder of your choice.");
}

std::vector<ScreenCommand> ResultsScreen::commands() {
    if (!isOwn())
        return {};
    return {{tr("Export my data"), QKeySequence(), [this] { askExport(); }}};
}

void ResultsScreen::enter() {
    load();
}

void ResultsScreen::load() {
    database::Database& database = context().site().database();
    m_work = context().background().run(
        this,
        [&database, actor = context().actor(),
         whose = person()](WorkToken& token) -> core::Result<std::vector<Attempt>> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return loadAttempts(**connection, actor, whose, [&token](double part) {
                token.setProgress(static_cast<int>(100 * part), 100);
                return !token.cancelled();
            });
        },
        [this](core::Result<std::vector<Attempt>> attempts) {
            if (attempts)
                showAttempts(std::move(*attempts));
            else
                m_panel->showError(tr("The results could not be read"), attempts.error(), [this] { load(); });
        });
    m_panel->showLoading(tr("Reading the results …"), m_work);
}

void ResultsScreen::showAttempts(std::vector<Attempt> attempts) {
    m_attempts = std::move(attempts);
    if (m_attempts.empty() && !isOwn()) {
        m_panel->showEmpty(tr("No results yet"), tr("Nothing was recorded for this person."));
        return;
    }
    if (m_attempts.empty()) {
        m_panel->showEmpty(
            tr("No results yet"), tr("Your first session will be here, with its scores and its playback."),
            tr("Choose an exercise"), [this] { context().navigator().go(QStringLiteral("exercises")); });
        return;
    }
    build();
    m_panel->showContent();
}

void ResultsScreen::build() {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme);
    page->column()->addWidget(kit::label(theme, title(), TextStyle::heading));
    page->column()->addWidget(filterRow());
    const kit::Box box = kit::box(theme);
    m_curveHolder = box.layout;
    page->column()->addWidget(box.frame);
    m_partHolder = new QWidget; // created here, so that the tab order reaches its parts before the attempts
    auto* parts = new QVBoxLayout(m_partHolder);
    parts->setContentsMargins(0, 0, 0, 0);
    m_partHolder->hide();
    page->column()->addWidget(m_partHolder);
    m_parts.clear(); // they were destroyed with the previous page
    page->column()->addWidget(kit::label(theme, tr("Attempts"), TextStyle::title));
    m_table = new AttemptsTable(theme, context().locale());
    connect(m_table, &AttemptsTable::openAsked, this, &ResultsScreen::openSession);
    page->column()->addWidget(m_table);
    auto* open = kit::button(theme, tr("Open the attempt"), "primary", QStringLiteral("view-statistics"));
    open->setObjectName(QStringLiteral("results.open"));
    connect(open, &QPushButton::clicked, this, [this] {
        if (const QTableWidgetItem* item = m_table->item(m_table->currentRow(), 0))
            openSession(item->data(Qt::UserRole).toLongLong());
    });
    auto* buttons = new QWidget;
    auto* row = new FlowLayout(theme.px(8), buttons);
    row->addWidget(open);
    if (!isOwn()) {
        auto* all =
            kit::button(theme, tr("All sessions of this person"), "", QStringLiteral("view-list-details"));
        all->setObjectName(QStringLiteral("results.sessions"));
        connect(all, &QPushButton::clicked, this, [this] {
            context().navigator().go(QStringLiteral("sessions"),
                                     {{QStringLiteral("person"), qlonglong(person())}});
        });
        row->addWidget(all);
    }
    page->column()->addWidget(buttons);
    if (isOwn())
        page->column()->addWidget(ownData());
    page->column()->addStretch();
    m_panel->setContent(page);
    fillLevels();
}

QWidget* ResultsScreen::ownData() {
    const Theme& theme = context().theme();
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(kit::label(theme, tr("Your data"), TextStyle::title));
    column->addWidget(kit::label(theme,
                                 tr("A copy of everything that is held about you: your account, sessions, "
                                    "scores, comments and samples. "
                                    "It is yours to keep; nothing is removed here."),
                                 TextStyle::body, "muted"));
    auto* exportButton = kit::button(theme, tr("Export my data …"), "", QStringLiteral("document-save"));
    exportButton->setObjectName(QStringLiteral("results.export"));
    connect(exportButton, &QPushButton::clicked, this, &ResultsScreen::askExport);
    column->addWidget(exportButton, 0, Qt::AlignLeft);
    return part;
}

QComboBox* ResultsScreen::choice(const char* name, const QString& label, ResponsiveRow& row) {
    const Theme& theme = context().theme();
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(2));
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    auto* words = kit::label(theme, label, TextStyle::label);
    words->setBuddy(box);
    column->addWidget(words);
    column->addWidget(box);
    row.add(part);
    return box;
}

QWidget* ResultsScreen::filterRow() {
    auto* row = new ResponsiveRow(context().theme().px(640), context().theme().px(12));
    m_exercise = choice("results.exercise", tr("Exercise"), *row);
    m_level = choice("results.level", tr("Level"), *row);
    m_metric = choice("results.metric", tr("Metric"), *row);
    for (auto attempt = m_attempts.rbegin(); attempt != m_attempts.rend(); ++attempt) {
        const QString id = QString::fromStdString(attempt->summary.exercise);
        if (m_exercise->findData(id) < 0)
            m_exercise->addItem(
                exerciseTitle(context().site().catalogue(), attempt->summary.exercise, context().language()),
                id);
    }
    const int asked = m_exercise->findData(place().parameters.value(QStringLiteral("exercise")));
    const Attempt* last = lastScored({});
    m_exercise->setCurrentIndex(std::max(
        0,
        asked >= 0 || !last ? asked : m_exercise->findData(QString::fromStdString(last->summary.exercise))));
    connect(m_exercise, &QComboBox::activated, this, &ResultsScreen::fillLevels);
    connect(m_level, &QComboBox::activated, this, &ResultsScreen::fillMetrics);
    connect(m_metric, &QComboBox::activated, this, &ResultsScreen::showSelection);
    return row;
}

const Attempt* ResultsScreen::lastScored(const std::string& exercise) const {
    const auto found =
        std::find_if(m_attempts.rbegin(), m_attempts.rend(), [&exercise](const Attempt& attempt) {
            return attempt.summary.attempt > 0 && !attempt.metrics.empty() &&
                   (exercise.empty() || attempt.summary.exercise == exercise);
        });
    return found == m_attempts.rend() ? nullptr : &*found;
}

bool ResultsScreen::asksFor(const QString& exercise) const {
    return place().parameters.value(QStringLiteral("exercise")).toString() == exercise;
}

void ResultsScreen::fillLevels() {
    const std::string exercise = m_exercise->currentData().toString().toStdString();
    m_level->clear();
    int newest = 0;
    std::vector<int> levels;
    for (const Attempt& attempt : m_attempts) {
        if (attempt.summary.exercise != exercise)
            continue;
        newest = attempt.summary.level;
        if (std::find(levels.begin(), levels.end(), newest) == levels.end())
            levels.push_back(newest);
    }
    std::sort(levels.begin(), levels.end());
    for (const int level : levels)
        m_level->addItem(levelTitle(context().site().catalogue(), exercise, level, context().language()),
                         level);
    const int asked = asksFor(m_exercise->currentData().toString())
                          ? m_level->findData(place().parameters.value(QStringLiteral("level")).toInt())
                          : -1;
    const Attempt* last = lastScored(exercise);
    m_level->setCurrentIndex(asked >= 0 ? asked : m_level->findData(last ? last->summary.level : newest));
    fillMetrics();
}

std::vector<Attempt> ResultsScreen::selected() const {
    std::vector<Attempt> attempts;
    for (const Attempt& attempt : m_attempts)
        if (attempt.summary.exercise == m_exercise->currentData().toString().toStdString() &&
            attempt.summary.level == m_level->currentData().toInt())
            attempts.push_back(attempt);
    return attempts;
}

void ResultsScreen::fillMetrics() {
    const std::vector<Attempt> attempts = selected();
    const catalogue::ExerciseLevel* level = context().site().catalogue().find(
        m_exercise->currentData().toString().toStdString(), m_level->currentData().toInt());
    m_metric->clear();
    for (auto attempt = attempts.rbegin(); attempt != attempts.rend(); ++attempt)
        for (const scoring::MetricValue& value : attempt->metrics)
            if (const QString id = QString::fromStdString(value.id); m_metric->findData(id) < 0)
                m_metric->addItem(session_report::metricTitle(id), id);
    const QString main =
        level && !level->gates.empty() ? QString::fromStdString(level->gates.front().metric) : QString();
    const int wanted = m_metric->findData(place().parameters.value(QStringLiteral("metric"), main));
    m_metric->setCurrentIndex(std::max(0, wanted));
    showSelection();
}

report::MetricRow ResultsScreen::metricRow(const std::vector<Attempt>& attempts) const {
    report::MetricRow row;
    row.id = m_metric->currentData().toString();
    for (const Attempt& attempt : attempts)
        if (const scoring::MetricValue* value = attempt.metric(row.id.toStdString()))
            row.unit = session_report::unitText(QString::fromStdString(value->unit));
    const catalogue::ExerciseLevel* level = context().site().catalogue().find(
        m_exercise->currentData().toString().toStdString(), m_level->currentData().toInt());
    for (const scoring::Gate& gate : level ? level->gates : std::vector<scoring::Gate>{}) {
        if (row.id != QLatin1String(gate.metric.c_str()))
            continue;
        row.gateMinimum = gate.minimum;
        row.gateMaximum = gate.maximum;
        row.limit = session::limitBehind(*level, gate);
    }
    for (const catalogue::MetricChoice& metric :
         level ? level->metrics : std::vector<catalogue::MetricChoice>{})
        if (row.id == QLatin1String(metric.id.c_str()))
            session_report::addPublishedBand(row, metric.version);
    return row;
}

void ResultsScreen::showSelection() {
    const std::vector<Attempt> attempts = selected();
    const report::MetricRow row = metricRow(attempts);
    delete m_curve;
    // The layout's widget owns the plot.
    m_curve = learningCurve(attempts, row, plotThemeOf(context().theme(), context().locale())).release();
    m_curve->setObjectName(QStringLiteral("results.curve"));
    m_curve->setMinimumHeight(context().theme().px(300));
    m_curveHolder->addWidget(m_curve);
    m_table->show(attempts, row.id);
    showPart(attempts);
    if (context().navigator().current().screen != place().screen)
        return;                             // another screen has already been requested
    QVariantMap shown = place().parameters; // keeps whose results they are
    shown.insert(QStringLiteral("exercise"), m_exercise->currentData());
    shown.insert(QStringLiteral("level"), m_level->currentData());
    shown.insert(QStringLiteral("metric"), row.id);
    context().navigator().note(shown);
}

void ResultsScreen::showPart(const std::vector<Attempt>& attempts) {
    const std::string exercise = m_exercise->currentData().toString().toStdString();
    const int level = m_level->currentData().toInt();
    const auto face = exerciseFace(exercise);
    const bool known = face && context().site().catalogue().find(exercise, level);
    for (const auto& [other, part] : m_parts)
        if (part && (other != exercise || !known))
            part->hide();
    m_partHolder->hide();
    if (!known)
        return;
    const auto [found, added] = m_parts.try_emplace(exercise, nullptr);
    if (added)
        if (ResultsPart* part = (*face)->resultsPart(context().theme(), context().locale())) {
            m_partHolder->layout()->addWidget(part);
            found->second = part;
        }
    if (!found->second)
        return;
    found->second->show();
    m_partHolder->show();
    ResultsQuestion question{person(), level, true};
    for (const Attempt& attempt : attempts)
        if (attempt.onCurve())
            question.felt = attempt.summary.felt; // of the newest attempt: felt and shown are never pooled
    found->second->ask(context().background(), context().site().database(), context().actor(), question);
}

void ResultsScreen::openSession(database::SessionId session) {
    context().navigator().go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(session)}});
}

void ResultsScreen::askExport() {
    auto* dialog = new QFileDialog(this, tr("Choose a folder for your data"));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("own_data"));
    connect(dialog, &QFileDialog::fileSelected, this, &ResultsScreen::exportTo);
    dialog->open();
}

void ResultsScreen::exportTo(const QString& parent) {
    auto* progress = new QProgressDialog(tr("Writing your data …"), tr("Cancel"), 0, 100, this);
    progress->setWindowModality(Qt::WindowModal);
    progress->setMinimumDuration(500); // shorter work needs no window
    database::Database& database = context().site().database();
    m_export = context().background().run(
        this,
        [&database, actor = context().actor(),
         folder = parent.toStdString()](WorkToken& token) -> core::Result<std::string> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            return exportOwnData(**connection, actor, folder, [&token](double part) {
                token.setProgress(static_cast<int>(100 * part), 100);
                return !token.cancelled();
            });
        },
        [this, progress](core::Result<std::string> folder) {
            progress->deleteLater();
            if (folder)
                context().messages().done(
                    tr("Your data was written to %1.").arg(QString::fromStdString(*folder)));
            else
                context().messages().error(tr("Your data could not be written completely."), folder.error());
        });
    connect(progress, &QProgressDialog::canceled, this, [token = m_export] { token->cancel(); });
    auto* poll = new QTimer(progress);
    connect(poll, &QTimer::timeout, progress,
            [progress, token = m_export] { progress->setValue(std::min(99, token->done())); });
    poll->start(100);
}

} // namespace chiron::desktop
