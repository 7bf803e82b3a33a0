// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a condition in which participants looked for an apex: bias and standard deviation per axis,
// errors, P2's figure 4.
#include "session_report/apex_study_plots.h"
#include "session_report/study_report_blocks.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"
#include "session_report/study_warning_words.h"

#include <cmath>
#include <qcustomplot.h>

namespace chiron::session_report {

namespace words = study_report_words;
using psychophysics::ApexAxis;
using psychophysics::ApexSummary;

namespace {

constexpr double kPlotHeight = 380.0;
constexpr double kPercent = 100.0;

QString ofRadius(double percent, const QLocale& locale) {
    return words::percent(percent / kPercent, locale);
}

} // namespace

/// A length with its percentage of the radius; only the percentage while blind, because both together would
/// reveal the radius.
QString StudyReportBlocks::errorText(double mm, double percent) const {
    const QString share = Words::tr("%1 of R").arg(ofRadius(percent, m_theme.locale));
    return m_data.blind() || !std::isfinite(mm)
               ? share
               : Words::tr("%1 mm, %2").arg(words::number(mm, m_theme.locale), share);
}

void StudyReportBlocks::addApex(std::size_t at) {
    const session::AnalysedCondition& condition = m_data.analysis.conditions[at];
    const ApexSummary& group = *condition.apex;
    const QLocale& locale = m_theme.locale;
    const auto& [x, y] = group.axes;
    addPairs(
        {{Words::tr("Bias in x"), errorText(x.bias_mm, x.biasPercent)},
         {Words::tr("Bias in y"), errorText(y.bias_mm, y.biasPercent)},
         {Words::tr("Marks, participants"),
          QStringLiteral("%1, %2").arg(locale.toString(group.trials), locale.toString(group.participants))},
         {Words::tr("SD in x"), errorText(x.sd_mm, x.sdPercent)},
         {Words::tr("SD in y"), errorText(y.sd_mm, y.sdPercent)},
         {Words::tr("Mean absolute error ± SD"),
          QStringLiteral("%1 ± %2").arg(ofRadius(group.meanAbsolutePercent, locale),
                                        ofRadius(group.sdAbsolutePercent, locale))}},
        3);
    std::vector<QString> names;
    std::vector<std::vector<QString>> rows;
    for (const session::AnalysedRun& run : condition.runs) {
        names.push_back(QString::fromStdString(run.participant.code));
        const ApexSummary& own = *run.apex;
        rows.push_back({names.back(), errorText(own.axes[0].bias_mm, own.axes[0].biasPercent),
                        errorText(own.axes[1].bias_mm, own.axes[1].biasPercent),
                        ofRadius(own.axes[0].sdPercent, locale), ofRadius(own.axes[1].sdPercent, locale),
                        ofRadius(own.meanAbsolutePercent, locale), locale.toString(run.scored)});
    }
    std::vector<std::unique_ptr<report::PlotView>> row;
    row.push_back(apexMarksPlot(group, names, m_theme));
    row.push_back(apexErrorPlot(group, names, m_theme));
    addPlotRow(std::move(row), kPlotHeight);
    addTable({Words::tr("Code"), Words::tr("Bias in x"), Words::tr("Bias in y"), Words::tr("SD in x"),
              Words::tr("SD in y"), Words::tr("Error"), Words::tr("Scored")},
             rows, {0.13, 0.24, 0.24, 0.1, 0.1, 0.1, 0.09}, {false, true, true, true, true, true, true});
    for (const psychophysics::Warning& warning : group.warnings)
        addMuted(QStringLiteral("! ") + warningWords(warning));
}

} // namespace chiron::session_report
