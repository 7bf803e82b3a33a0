// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/quality_box.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QVBoxLayout>
#include <algorithm>

namespace chiron::desktop {

namespace {
enum QualityColumn {
    whoColumn,
    doneColumn,
    lateColumn,
    forceColumn,
    scoredColumn,
    repeatedColumn,
    qualityColumns
};
constexpr int kMostQualityRows = 14;
constexpr int kFewestQualityRows = 3;
} // namespace

QualityBox::QualityBox(AppContext& app, const StudyFacts& facts, QWidget* parent) : QFrame(parent) {
    const Theme& theme = app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::notice(
        theme, "info",
        tr("Results stay sealed until the study is unblinded: answers, times and even the number of trials "
           "could "
           "reveal which condition is which. This page shows how well the trials went, for each participant, "
           "across all conditions.")));
    column->addWidget(table(app, facts));
    column->addWidget(kit::label(
        theme, tr("The number of trials is shown only for participants who have completed every condition."),
        TextStyle::small, "muted"));
    column->addStretch(); // otherwise the notice would fill the free height of the page
}

QWidget* QualityBox::table(AppContext& app, const StudyFacts& facts) {
    const QLocale locale = app.locale();
    auto* shown = new FittedTable(app.theme(), qualityColumns);
    shown->setObjectName(QStringLiteral("data.quality"));
    shown->setAccessibleName(tr("Quality of the trials"));
    shown->setHorizontalHeaderLabels(
        {tr("Code"), tr("Conditions done"), tr("Late ticks"), tr("Force"), tr("Scored"), tr("Repeated")});
    shown->setRowCount(static_cast<int>(facts.quality.size()));
    for (int row = 0; row < shown->rowCount(); ++row) {
        const database::ParticipantQuality& quality = facts.quality[static_cast<std::size_t>(row)];
        const auto put = [&](int at, const QString& text) {
            shown->setItem(row, at, new QTableWidgetItem(text));
        };
        for (const ParticipantRow& each : facts.study.participants)
            if (each.participant.id == quality.participant)
                put(whoColumn, QString::fromStdString(each.participant.code));
        int repeated = 0;
        QStringList reasons;
        for (const auto& [reason, count] : quality.spoiled) {
            repeated += count;
            reasons << QStringLiteral("%1: %2").arg(study_words::spoiled(reason), locale.toString(count));
        }
        const QString later = tr("sealed");
        put(doneColumn,
            tr("%1 of %2").arg(locale.toString(quality.conditionsDone), locale.toString(quality.conditions)));
        put(lateColumn, study_words::percent(quality.lateTicks, locale));
        put(forceColumn, !quality.felt   ? QStringLiteral("–")
                         : *quality.felt ? tr("felt")
                                         : tr("shown, not felt"));
        put(scoredColumn, quality.whole ? locale.toString(quality.scored) : later);
        put(repeatedColumn, !quality.whole  ? later
                            : repeated == 0 ? locale.toString(0)
                                            : reasons.join(QStringLiteral(", ")));
    }
    shown->setRowsSeen(std::clamp(shown->rowCount(), kFewestQualityRows, kMostQualityRows));
    return shown;
}

} // namespace chiron::desktop
