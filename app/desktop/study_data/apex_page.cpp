// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/apex_page.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_data/run_choice.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "session_report/apex_study_plots.h"
#include "session_report/study_warning_words.h"

#include <QComboBox>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using psychophysics::ApexSummary;

namespace {
enum ApexColumn {
    codeColumn,
    biasXColumn,
    biasYColumn,
    sdXColumn,
    sdYColumn,
    errorColumn,
    trialsColumn,
    stateColumn,
    apexColumns
};
constexpr int kMostApexRows = 14;
constexpr int kFewestApexRows = 3;
constexpr double kOne = 100.0; ///< converts a share into per cent

QVBoxLayout* columnOf(QWidget* page, const Theme& theme) {
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(14));
    return column;
}
} // namespace

ApexPage::ApexPage(AppContext& app, const StudyFacts& facts, std::size_t condition, QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts), m_condition(condition) {
    auto* column = columnOf(this, app.theme());
    column->addWidget(chooser());
    const ApexFacts& apex = *facts.apexes[condition];
    if (apex.names.empty()) {
        column->addWidget(
            kit::notice(app.theme(), "info",
                        tr("Nobody has done this condition yet. Each participant's marks will appear "
                           "here after the first run.")));
        return;
    }
    column->addWidget(summaryBox(apex.summary, tr("Group"), 0));
    column->addWidget(plots(apex.summary, apex.names));
    addWarnings(*column, apex.summary);
    column->addWidget(tableBox());
}

ApexPage::ApexPage(AppContext& app, const StudyFacts& facts, const RunFacts& run, QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts), m_condition(run.condition) {
    auto* column = columnOf(this, app.theme());
    QComboBox* choice = runChoice(app, facts, &run);
    connect(choice, &QComboBox::activated, this,
            [this, choice] { emit runChosen(choice->currentData().toLongLong()); });
    column->addWidget(choice, 0, Qt::AlignLeft);
    const QString code = QString::fromStdString(facts.study.participants[run.participant].participant.code);
    column->addWidget(summaryBox(*run.apex, code, run.spoiled));
    column->addWidget(plots(*run.apex, {code}));
    addWarnings(*column, *run.apex);
}

QWidget* ApexPage::chooser() {
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
    return bar;
}

/// A length and its share of the radius. While blind only the share, because both together would reveal the
/// radius.
QString ApexPage::error(double mm, double percent) const {
    const QLocale locale = m_app.locale();
    const QString share = study_words::percent(percent / kOne, locale);
    return m_facts.study.blind() || !std::isfinite(mm)
               ? share
               : tr("%1 mm (%2)").arg(study_words::number(mm, locale), share);
}

/// For a narrow column: in mm only; while blind as a share of the radius.
QString ApexPage::spread(const psychophysics::ApexAxis& axis) const {
    if (m_facts.study.blind() || !std::isfinite(axis.sd_mm))
        return error(axis.sd_mm, axis.sdPercent);
    return tr("%1 mm").arg(study_words::number(axis.sd_mm, m_app.locale()));
}

QWidget* ApexPage::summaryBox(const ApexSummary& summary, const QString& title, int repeated) {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("data.apex"));
    box.layout->addWidget(kit::label(theme, title, TextStyle::title));
    auto* grid = new FieldGrid(theme, locale, true);
    const auto fact = [&](const QString& name, const QString& value, const QString& more) {
        auto* part = new QWidget;
        auto* column = new QVBoxLayout(part);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(kit::label(theme, name, TextStyle::small, "muted"));
        column->addWidget(kit::label(theme, value, TextStyle::title));
        column->addWidget(kit::label(theme, more, TextStyle::small, "muted"));
        grid->cell(part);
    };
    const QStringList axes{tr("x"), tr("y")};
    for (std::size_t i = 0; i < summary.axes.size(); ++i) {
        const psychophysics::ApexAxis& axis = summary.axes[i];
        const QString sd = tr("SD %1").arg(error(axis.sd_mm, axis.sdPercent));
        fact(tr("Bias in %1").arg(axes[static_cast<qsizetype>(i)]), error(axis.bias_mm, axis.biasPercent),
             sd);
    }
    fact(tr("Mean absolute error"), error(summary.meanAbsolute_mm, summary.meanAbsolutePercent),
         tr("SD %1; published: %2")
             .arg(study_words::percent(summary.sdAbsolutePercent / kOne, locale),
                  study_words::percent(psychophysics::kP2MeanPercent / kOne, locale)));
    box.layout->addWidget(grid);
    box.layout->addWidget(
        kit::label(theme,
                   tr("Per cent of the sphere's radius. %n mark(s)", nullptr, summary.trials) +
                       (repeated > 0 ? tr(", %n trial(s) repeated", nullptr, repeated) : QString()),
                   TextStyle::small, "muted"));
    return box.frame;
}

void ApexPage::addWarnings(QVBoxLayout& column, const ApexSummary& summary) const {
    for (const psychophysics::Warning& warning : summary.warnings)
        column.addWidget(kit::notice(m_app.theme(), "warning", session_report::warningWords(warning)));
}

QWidget* ApexPage::plots(const ApexSummary& summary, const std::vector<QString>& names) {
    const Theme& theme = m_app.theme();
    const kit::Box box = kit::box(theme);
    auto* row = new QHBoxLayout;
    auto marks = session_report::apexMarksPlot(summary, names, plotThemeOf(theme, m_app.locale()));
    marks->setObjectName(QStringLiteral("data.apex_marks"));
    marks->setMinimumHeight(theme.px(440));
    row->addWidget(marks.release(), 3);
    auto errors = session_report::apexErrorPlot(summary, names, plotThemeOf(theme, m_app.locale()));
    errors->setObjectName(QStringLiteral("data.apex_errors"));
    errors->setMinimumHeight(theme.px(440));
    row->addWidget(errors.release(), 2);
    box.layout->addLayout(row);
    return box.frame;
}

QWidget* ApexPage::tableBox() {
    const QLocale locale = m_app.locale();
    auto* table = new FittedTable(m_app.theme(), apexColumns);
    table->setObjectName(QStringLiteral("data.runs"));
    table->setAccessibleName(tr("Runs"));
    table->setHorizontalHeaderLabels({tr("Code"), tr("Bias in x"), tr("Bias in y"), tr("SD in x"),
                                      tr("SD in y"), tr("Mean error"), tr("Trials"), tr("Run")});
    std::vector<const RunFacts*> shown;
    for (const RunFacts& run : m_facts.runs)
        if (run.condition == m_condition && run.apex)
            shown.push_back(&run);
    table->setRowCount(static_cast<int>(shown.size()));
    for (int row = 0; row < table->rowCount(); ++row) {
        const RunFacts& run = *shown[static_cast<std::size_t>(row)];
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            item->setData(Qt::UserRole, qlonglong(run.run.id));
            table->setItem(row, column, item);
        };
        const auto& [x, y] = run.apex->axes;
        put(codeColumn, QString::fromStdString(m_facts.study.participants[run.participant].participant.code));
        put(biasXColumn, error(x.bias_mm, x.biasPercent));
        put(biasYColumn, error(y.bias_mm, y.biasPercent));
        put(sdXColumn, spread(x));
        put(sdYColumn, spread(y));
        put(errorColumn, error(run.apex->meanAbsolute_mm, run.apex->meanAbsolutePercent));
        put(trialsColumn,
            run.spoiled > 0
                ? tr("%1 (%2 repeated)").arg(locale.toString(run.scored), locale.toString(run.spoiled))
                : locale.toString(run.scored));
        put(stateColumn, study_words::runState(run.run.state));
    }
    table->setRowsSeen(std::clamp(table->rowCount(), kFewestApexRows, kMostApexRows));
    connect(table, &QTableWidget::activated, this,
            [this](const QModelIndex& index) { emit runOpened(index.data(Qt::UserRole).toLongLong()); });
    return table;
}

} // namespace chiron::desktop
