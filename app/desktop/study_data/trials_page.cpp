// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/trials_page.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_data/quality_box.h"
#include "desktop/study_data/run_choice.h"
#include "desktop/widgets/kit.h"

#include <QComboBox>
#include <QHeaderView>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::desktop {

namespace {
enum Column {
    numberColumn,
    differenceColumn,
    answerColumn,
    countsColumn,
    timeColumn,
    forceColumn,
    speedColumn,
    lateColumn,
    felt,
    columns
};
constexpr int kMostRows = 16;
constexpr double kLargeScale = 1.5;

double numberIn(const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    return value.isDouble() ? value.toDouble() : std::nan("");
}

} // namespace

TrialsPageOfRun::TrialsPageOfRun(AppContext& app, const StudyFacts& facts, database::StudyRunNumber run,
                                 QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts) {
    const Theme& theme = app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    const RunFacts* shown = runOf(facts, run);
    if (!shown) {
        column->addWidget(kit::notice(theme, "info", tr("There are no runs yet.")));
        return;
    }
    QComboBox* choice = runChoice(app, facts, shown);
    connect(choice, &QComboBox::activated, this,
            [this, choice] { emit runChosen(choice->currentData().toLongLong()); });
    column->addWidget(choice, 0, Qt::AlignLeft);
    if (facts.sealed) {
        column->addWidget(new QualityBox(app, facts));
        return;
    }
    column->addWidget(table(*shown));
}

// The headings are short, so that they fit a window of 1280 pixels in every language; tool tips explain them.
void TrialsPageOfRun::setHeadings(QTableWidget& shown) {
    shown.setHorizontalHeaderLabels({tr("No."), tr("Difference"), tr("Answer"), tr("Counts"), tr("Time (s)"),
                                     tr("Force (N)"), tr("Speed (mm/s)"), tr("Late ticks"), tr("Deviation")});
    const QStringList tips{tr("Number of the presentation"),
                           tr("By how much the object exceeded the reference"),
                           tr("What the participant answered"),
                           tr("Whether the trial counts, and if not, why"),
                           tr("Time until the answer"),
                           tr("Peak force"),
                           tr("Mean speed of the tool"),
                           tr("Share of late ticks"),
                           tr("How far the felt value was from the requested one")};
    for (int column = 0; column < columns; ++column)
        shown.horizontalHeaderItem(column)->setToolTip(tips[column]);
}

QWidget* TrialsPageOfRun::table(const RunFacts& run) const {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    auto* shown = new FittedTable(theme, columns);
    shown->setObjectName(QStringLiteral("data.trials"));
    shown->setAccessibleName(tr("Trials"));
    setHeadings(*shown);
    // This column has the longest texts, and its tool tip shows what does not fit; at a large scale nothing
    // of it would remain, so the table scrolls instead.
    if (theme.scale() < kLargeScale)
        shown->horizontalHeader()->setSectionResizeMode(countsColumn, QHeaderView::Stretch);
    const std::optional<psychophysics::Condition>& condition = m_facts.designed[run.condition];
    shown->setRowCount(static_cast<int>(run.trials.size()));
    for (int row = 0; row < shown->rowCount(); ++row) {
        const database::StudyTrial& trial = run.trials[static_cast<std::size_t>(row)];
        const QJsonObject fidelity =
            QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson)).object();
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            shown->setItem(row, column, item);
            return item;
        };
        put(numberColumn, locale.toString(trial.ordinal + 1));
        put(differenceColumn, study_words::percent(study_words::ratioOf(trial.difference), locale));
        const int right = trial.arrangement >= 0 && condition
                              ? psychophysics::correctAnswer(condition->task, trial.arrangement)
                              : -1;
        put(answerColumn, trial.value             ? study_words::number(*trial.value, locale)
                          : trial.answer < 0      ? tr("none")
                          : right < 0             ? tr("given")
                          : trial.answer == right ? tr("correct")
                                                  : tr("wrong"));
        if (trial.practice)
            put(countsColumn, tr("Practice"));
        else if (!trial.spoiled.empty())
            put(countsColumn, study_words::spoiled(trial.spoiled))
                ->setIcon(theme.icon(QStringLiteral("dialog-warning"), Colour::warning));
        else
            put(countsColumn, tr("Counts"))
                ->setIcon(theme.icon(QStringLiteral("dialog-ok-apply"), Colour::good));
        shown->item(row, countsColumn)->setToolTip(shown->item(row, countsColumn)->text());
        put(timeColumn,
            study_words::number(trial.exploration_s > 0.0 ? trial.exploration_s
                                                          : std::numeric_limits<double>::quiet_NaN(),
                                locale));
        put(forceColumn, study_words::number(numberIn(fidelity, "peak_force_N"), locale));
        put(speedColumn, study_words::number(1e3 * numberIn(fidelity, "mean_speed_m_per_s"), locale));
        put(lateColumn, study_words::percent(numberIn(fidelity, "late_ticks"), locale));
        put(felt, study_words::percent(numberIn(fidelity, "stiffness_error"), locale));
    }
    shown->setRowsSeen(std::clamp(shown->rowCount(), 4, kMostRows));
    return shown;
}

} // namespace chiron::desktop
