// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/group_page.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_data/quality_box.h"
#include "desktop/study_data/ranking_box.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"
#include "session_report/group_words.h"
#include "session_report/marked_estimates.h"
#include "session_report/study_comparison_words.h"
#include "session_report/study_warning_words.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
enum Column {
    codeColumn,
    weberColumn,
    intervalColumn,
    jndColumn,
    groupColumn,
    warningColumn,
    trialsColumn,
    priorColumn,
    stateColumn,
    columns
};
constexpr int kMostRows = 14;
constexpr int kFewestRows = 3;
} // namespace

GroupPage::GroupPage(AppContext& app, const StudyFacts& facts, std::size_t condition, QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts), m_condition(condition) {
    const Theme& theme = app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(14));
    column->addWidget(chooser());
    if (facts.sealed) {
        column->addWidget(new QualityBox(app, facts));
        return;
    }
    if (runs().empty()) {
        column->addWidget(
            kit::notice(theme, "info",
                        tr("Nobody has run this condition yet. Each participant's result appears here after "
                           "their first run.")));
        if (!facts.rolls[condition].people.empty())
            addGroupWords(*column);
        return;
    }
    column->addWidget(groupBox());
    column->addWidget(plotBox());
    column->addWidget(tableBox());
    if (facts.ranks(condition))
        column->addWidget(new RankingBox(app, facts.rankings[condition], RankingBox::Of::group));
}

std::vector<const RunFacts*> GroupPage::runs() const {
    std::vector<const RunFacts*> runs;
    for (const RunFacts& run : m_facts.runs)
        if (run.condition == m_condition && run.scored > 0)
            runs.push_back(&run);
    return runs;
}

QWidget* GroupPage::chooser() {
    auto* bar = new QWidget;
    auto* row = new FlowLayout(m_app.theme().px(8), bar);
    const std::vector<std::string> labels = conditionLabels(m_facts.study);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        auto* button = kit::button(m_app.theme(), conditionName(m_facts.study, labels[i], m_app.language()));
        button->setObjectName(QStringLiteral("data.condition.%1").arg(i));
        button->setCheckable(true);
        button->setChecked(i == m_condition);
        connect(button, &QPushButton::clicked, this,
                [this, i] { emit conditionChosen(static_cast<uint>(i)); });
        row->addWidget(button);
    }
    if (labels.size() > 1) {
        auto* compare = kit::button(m_app.theme(), tr("Compare the conditions"), "quiet",
                                    QStringLiteral("office-chart-line"));
        compare->setObjectName(QStringLiteral("data.compare"));
        connect(compare, &QPushButton::clicked, this, &GroupPage::comparisonAsked);
        row->addWidget(compare);
    }
    return bar;
}

QStringList GroupPage::weberWords(const psychophysics::GroupEstimate& group) const {
    const QLocale locale = m_app.locale();
    const QString interval = study_words::intervalPercent(group.weber95.low, group.weber95.high, locale);
    const QString next =
        study_words::intervalPercent(group.prediction95.low, group.prediction95.high, locale);
    QStringList words{tr("Weber fraction (random effects)")};
    if (!interval.isEmpty())
        words << tr("95 %: %1").arg(session_report::intervalOrUnbounded(group.weber95, interval));
    if (!next.isEmpty())
        words << tr("prediction for a new participant: %1")
                     .arg(session_report::predictionOrUnbounded(group.prediction95, next));
    return words;
}

QWidget* GroupPage::groupBox() {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("data.group"));
    const psychophysics::GroupEstimate& group = m_facts.groups[m_condition];
    box.layout->addWidget(kit::label(theme, tr("Group"), TextStyle::title));
    const auto& designed = m_facts.designed[m_condition];
    QStringList words;
    if (std::isfinite(group.exponent)) { // magnitude estimates have no Weber fraction
        box.layout->addWidget(
            kit::label(theme, study_words::number(group.exponent, locale), TextStyle::display, "accent"));
        words << tr("Exponent of the power law");
        if (const QString interval =
                study_words::interval(group.exponent95.low, group.exponent95.high, locale);
            !interval.isEmpty())
            words << tr("95 %: %1").arg(interval);
    } else if (std::isfinite(group.weber)) {
        box.layout->addWidget(
            kit::label(theme, study_words::percent(group.weber, locale), TextStyle::display, "accent"));
        words << weberWords(group);
        if (!m_facts.study.blind() && designed && std::isfinite(group.jnd))
            words << tr("JND %1").arg(study_words::value(group.jnd, designed->stimulus.attribute, locale));
    }
    if (!words.isEmpty())
        box.layout->addWidget(kit::label(theme, words.join(QStringLiteral(" · "))));
    addGroupWords(*box.layout);
    addAgreement(*box.layout);
    for (const psychophysics::Warning& warning : session_report::furtherWarnings(group.warnings))
        box.layout->addWidget(kit::notice(theme, "warning", session_report::warningWords(warning)));
    return box.frame;
}

void GroupPage::addAgreement(QVBoxLayout& layout) const {
    if (!m_facts.ranks(m_condition))
        return;
    int right = 0;
    int of = 0;
    for (const RunFacts* run : runs())
        for (const database::StudyTrial& trial : run->trials)
            if (!trial.practice && trial.spoiled.empty() && trial.outcome >= 0) {
                ++of;
                right += trial.outcome == 0 ? 1 : 0;
            }
    const QLocale locale = m_app.locale();
    if (of > 0)
        layout.addWidget(kit::label(m_app.theme(),
                                    (m_facts.rankings[m_condition].tied > 0
                                         ? tr("Rankings entirely correct: %1 of %2 (%3; chance level 16.7 "
                                              "% or less)")
                                         : tr("Rankings entirely correct: %1 of %2 (%3; chance level 16.7 "
                                              "%)"))
                                        .arg(locale.toString(right), locale.toString(of),
                                             study_words::percent(static_cast<double>(right) / of, locale)),
                                    TextStyle::body, "muted"));
}

QWidget* GroupPage::plotBox() {
    const Theme& theme = m_app.theme();
    const kit::Box box = kit::box(theme);
    auto* plot = new report::PlotView(plotThemeOf(theme, m_app.locale()));
    plot->setObjectName(QStringLiteral("data.group_plot"));
    plot->setMinimumHeight(theme.px(280));
    plot->setTitle(tr("Weber fraction of each participant"));
    plot->setYAxis({tr("Weber fraction (%)"), 0.0, {}});
    plot->setXAxis({tr("Participant"), {}, {}});
    std::vector<QString> names;
    session_report::MarkedEstimates estimates;
    for (const RunFacts* run : runs()) {
        const double at = static_cast<double>(names.size());
        names.push_back(session_report::markedValue(
            QString::fromStdString(m_facts.study.participants[run->participant].participant.code),
            run->estimate));
        estimates.add(at, run->estimate, run->presence);
    }
    estimates.draw(*plot);
    plot->setXCategories(names);
    if (estimates.empty())
        plot->setNote(tr("No estimate yet"));
    box.layout->addWidget(plot);
    return box.frame;
}

QWidget* GroupPage::tableBox() {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    auto* table = new FittedTable(theme, columns);
    table->setObjectName(QStringLiteral("data.runs"));
    table->setAccessibleName(tr("Runs"));
    table->setHorizontalHeaderLabels({tr("Code"), tr("Weber fraction"), tr("95 % interval"), tr("JND"),
                                      tr("In the group"), tr("Warnings"), tr("Trials"), tr("Prior influence"),
                                      tr("Run")});
    table->horizontalHeaderItem(priorColumn)->setToolTip(session_report::influenceMeaning());
    const std::vector<const RunFacts*> shown = runs();
    const bool sealed = m_facts.study.blind() || !m_facts.designed[m_condition];
    const psychophysics::Attribute attribute =
        sealed ? psychophysics::Attribute::stiffness : m_facts.designed[m_condition]->stimulus.attribute;
    table->setRowCount(static_cast<int>(shown.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const RunFacts& run = *shown[static_cast<std::size_t>(row)];
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            item->setData(Qt::UserRole, qlonglong(run.run.id));
            table->setItem(row, column, item);
        };
        const bool open = run.run.state == database::StudyRunState::open;
        put(codeColumn, QString::fromStdString(m_facts.study.participants[run.participant].participant.code));
        put(weberColumn, session_report::supportedValue(study_words::percent(run.estimate.weber, locale),
                                                        run.estimate, open));
        put(intervalColumn,
            session_report::supportedInterval(
                study_words::intervalPercent(run.estimate.weber95.low, run.estimate.weber95.high, locale),
                run.estimate));
        put(jndColumn,
            sealed ? tr("sealed")
                   : session_report::supportedValue(study_words::value(run.estimate.jnd, attribute, locale),
                                                    run.estimate, open));
        put(groupColumn, session_report::presenceWords(run.presence));
        put(trialsColumn,
            run.spoiled > 0
                ? tr("%1 (%2 repeated)").arg(locale.toString(run.scored), locale.toString(run.spoiled))
                : locale.toString(run.scored));
        put(priorColumn, std::isfinite(run.estimate.priorInfluence)
                             ? study_words::percent(run.estimate.priorInfluence, locale)
                             : QString());
        put(stateColumn, study_words::runState(run.run.state));
        QStringList warnings;
        for (const psychophysics::Warning& warning : run.estimate.warnings)
            warnings << session_report::warningWords(warning);
        put(warningColumn, warnings.join(QStringLiteral("; ")));
    }
    table->setRowsSeen(std::clamp(table->rowCount(), kFewestRows, kMostRows));
    connect(table, &QTableWidget::activated, this,
            [this](const QModelIndex& index) { emit runOpened(index.data(Qt::UserRole).toLongLong()); });
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table);
    const bool marked = std::any_of(shown.begin(), shown.end(),
                                    [](const RunFacts* run) { return !run->estimate.warnings.empty(); });
    if (marked)
        column->addWidget(kit::label(theme, session_report::markMeaning(), TextStyle::small, "muted"));
    return part;
}

/// Writes one statement, whether or not there is a value.
void GroupPage::addGroupWords(QVBoxLayout& layout) const {
    const Theme& theme = m_app.theme();
    const QStringList said = session_report::groupSentences(m_facts.rolls[m_condition], m_app.locale());
    for (qsizetype i = 0; i < said.size(); ++i) {
        auto* words = i == 0 ? kit::label(theme, said[i]) : kit::notice(theme, "info", said[i]);
        words->setObjectName(i == 0 ? QStringLiteral("data.group_statement")
                                    : QStringLiteral("data.group_missing"));
        layout.addWidget(words);
    }
    auto* rule = kit::label(theme, session_report::groupRule(), TextStyle::small, "muted");
    rule->setObjectName(QStringLiteral("data.rule"));
    layout.addWidget(rule);
}

} // namespace chiron::desktop
