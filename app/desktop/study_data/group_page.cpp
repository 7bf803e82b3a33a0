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
#include "session_report/study_comparison_words.h"
#include "session_report/study_warning_words.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
enum Column { codeColumn, weberColumn, intervalColumn, jndColumn, trialsColumn, priorColumn, stateColumn, warningColumn, columns };
constexpr int kMostRows = 14;
constexpr int kFewestRows = 3;
constexpr double kPercent = 100.0;
constexpr double kUnknownFactor = 50.0; // between the ends of an interval that says nothing
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
        column->addWidget(kit::notice(theme, "info", tr("Nobody has run this condition yet. Each participant's result appears here after "
                                                        "their first run.")));
        return;
    }
    column->addWidget(groupBox());
    column->addWidget(plotBox());
    column->addWidget(tableBox());
    if (facts.ranks(condition))
        column->addWidget(new RankingBox(app, facts.rankings[condition], RankingBox::Of::group));
    if (conditionLabels(facts.study).size() > 1 && (facts.study.blind() || !facts.comparisons.empty()))
        column->addWidget(comparisonBox());
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
        connect(button, &QPushButton::clicked, this, [this, i] { emit conditionChosen(static_cast<uint>(i)); });
        row->addWidget(button);
    }
    return bar;
}

QWidget* GroupPage::groupBox() {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("data.group"));
    const psychophysics::GroupEstimate& group = m_facts.groups[m_condition];
    box.layout->addWidget(kit::label(theme, tr("Group"), TextStyle::title));
    const QString interval = study_words::intervalPercent(group.weber95.low, group.weber95.high, locale);
    const QString next = study_words::intervalPercent(group.prediction95.low, group.prediction95.high, locale);
    box.layout->addWidget(kit::label(theme, study_words::percent(group.weber, locale), TextStyle::display, "accent"));
    QStringList words{tr("Weber fraction of %n participant(s) (random effects)", nullptr, group.participants)};
    if (!interval.isEmpty())
        words << tr("95 %: %1").arg(interval);
    if (group.prediction95.high > kUnknownFactor * group.prediction95.low) // of three people it may reach from nothing to 5,000 %
        words << tr("too few participants for a prediction");
    else if (!next.isEmpty())
        words << tr("prediction for a new participant: %1").arg(next);
    const auto& designed = m_facts.designed[m_condition];
    if (!m_facts.study.blind() && designed && std::isfinite(group.jnd))
        words << tr("JND %1").arg(study_words::value(group.jnd, designed->stimulus.attribute, locale));
    box.layout->addWidget(kit::label(theme, words.join(QStringLiteral(" · "))));
    addAgreement(*box.layout);
    for (const psychophysics::Warning& warning : group.warnings)
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
        layout.addWidget(kit::label(m_app.theme(), (m_facts.rankings[m_condition].tied > 0 ? tr("Rankings entirely correct: %1 of %2 (%3; chance level 16.7 "
                                                                                                "% or less)")
                                                                                          : tr("Rankings entirely correct: %1 of %2 (%3; chance level 16.7 "
                                                                                               "%)"))
                                                       .arg(locale.toString(right), locale.toString(of), study_words::percent(static_cast<double>(right) / of, locale)),
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
    std::vector<report::PlotPoint> points;
    std::vector<report::PlotView::Interval> intervals; // longer upwards: they are of a logarithm
    for (const RunFacts* run : runs()) {
        const psychophysics::RunEstimate& estimate = run->estimate;
        const double at = static_cast<double>(names.size());
        names.push_back(QString::fromStdString(m_facts.study.participants[run->participant].participant.code));
        if (!std::isfinite(estimate.weber))
            continue;
        points.push_back({at, kPercent * estimate.weber});
        intervals.push_back({kPercent * estimate.weber95.low, kPercent * estimate.weber95.high});
    }
    plot->addEstimates(tr("estimate with its 95 % interval"), points, intervals);
    plot->setXCategories(names);
    if (points.empty())
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
    table->setHorizontalHeaderLabels({tr("Code"), tr("Weber fraction"), tr("95 % interval"), tr("JND"), tr("Trials"), tr("Prior influence"), tr("Run"), tr("Warnings")});
    table->horizontalHeaderItem(priorColumn)->setToolTip(session_report::influenceMeaning());
    const std::vector<const RunFacts*> shown = runs();
    const bool sealed = m_facts.study.blind() || !m_facts.designed[m_condition];
    const psychophysics::Attribute attribute = sealed ? psychophysics::Attribute::stiffness : m_facts.designed[m_condition]->stimulus.attribute;
    table->setRowCount(static_cast<int>(shown.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const RunFacts& run = *shown[static_cast<std::size_t>(row)];
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            item->setData(Qt::UserRole, qlonglong(run.run.id));
            table->setItem(row, column, item);
        };
        put(codeColumn, QString::fromStdString(m_facts.study.participants[run.participant].participant.code));
        put(weberColumn, study_words::percent(run.estimate.weber, locale));
        put(intervalColumn, study_words::intervalPercent(run.estimate.weber95.low, run.estimate.weber95.high, locale));
        put(jndColumn, sealed ? tr("sealed") : study_words::value(run.estimate.jnd, attribute, locale));
        put(trialsColumn, run.spoiled > 0 ? tr("%1 (%2 repeated)").arg(locale.toString(run.scored), locale.toString(run.spoiled)) : locale.toString(run.scored));
        put(priorColumn, std::isfinite(run.estimate.priorInfluence) ? study_words::percent(run.estimate.priorInfluence, locale) : QString());
        put(stateColumn, study_words::runState(run.run.state));
        QStringList warnings;
        for (const psychophysics::Warning& warning : run.estimate.warnings)
            warnings << session_report::warningWords(warning);
        put(warningColumn, warnings.join(QStringLiteral("; ")));
    }
    table->setRowsSeen(std::clamp(table->rowCount(), kFewestRows, kMostRows));
    connect(table, &QTableWidget::activated, this, [this](const QModelIndex& index) { emit runOpened(index.data(Qt::UserRole).toLongLong()); });
    return table;
}

QWidget* GroupPage::comparisonBox() {
    const Theme& theme = m_app.theme();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("data.comparisons"));
    box.layout->addWidget(kit::label(theme, tr("Conditions compared"), TextStyle::title));
    if (m_facts.study.blind()) {
        box.layout->addWidget(kit::label(theme, session_report::comparisonSealed(), TextStyle::body, "muted"));
        return box.frame;
    }
    const std::vector<QString> headings = session_report::comparisonHeadings();
    const std::vector<std::string> labels = conditionLabels(m_facts.study);
    const auto name = [&](std::size_t at) { return conditionName(m_facts.study, labels[at], m_app.language()); };
    auto* table = new FittedTable(theme, static_cast<int>(headings.size()));
    table->setObjectName(QStringLiteral("data.comparison_table"));
    table->setAccessibleName(tr("Conditions compared"));
    table->setHorizontalHeaderLabels(QStringList(headings.begin(), headings.end()));
    table->setRowCount(static_cast<int>(m_facts.comparisons.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const session::ComparedConditions& each = m_facts.comparisons[static_cast<std::size_t>(row)];
        const std::vector<QString> cells = session_report::comparisonRow(each, name(each.first), name(each.second), m_app.locale());
        for (int column = 0; column < static_cast<int>(cells.size()); ++column)
            table->setItem(row, column, new QTableWidgetItem(cells[static_cast<std::size_t>(column)]));
    }
    table->setRowsSeen(std::clamp(table->rowCount(), 1, kMostRows));
    box.layout->addWidget(table);
    box.layout->addWidget(kit::label(theme, session_report::comparisonNote(), TextStyle::small, "muted"));
    return box.frame;
}

} // namespace chiron::desktop
