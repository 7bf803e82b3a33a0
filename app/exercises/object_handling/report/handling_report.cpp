// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/report/handling_report.h"

#include "report/block_maker.h"
#include "report/plot_view.h"
#include "report/report_text.h"

#include <algorithm>

namespace chiron::report {

namespace {

const QString kNothing = QStringLiteral("–");

QString inUnit(const std::optional<double>& value, const char* unit, const QLocale& locale) {
    return formatValue(value, QLatin1String(unit), locale);
}

} // namespace

std::unique_ptr<PlotView> squeezePlot(const HandlingReport& handling, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(Words::tr("Largest squeeze of each trial"));
    view->setXAxis({Words::tr("Trial"), {}, {}});
    view->setYAxis({Words::tr("Squeeze (N)"), 0.0, {}});
    std::vector<QString> names;
    std::vector<PlotPoint> bars;
    for (const HandlingTrialRow& row : handling.rows) {
        if (row.squeezeMax_N)
            bars.push_back({static_cast<double>(names.size()), *row.squeezeMax_N});
        names.push_back(theme.locale.toString(row.trial + 1));
    }
    view->addBars(Words::tr("squeeze"), bars, PlotStyle::solidA, 0, 1);
    if (handling.squeezeLimit_N > 0.0)
        view->addLimit(Words::tr("limit %1")
                           .arg(formatValue(handling.squeezeLimit_N, QStringLiteral("N"), theme.locale)),
                       handling.squeezeLimit_N);
    view->setXCategories(names);
    if (bars.empty())
        view->setNote(handling.rows.empty() ? Words::tr("No trial was started")
                                            : Words::tr("No trial was finished"));
    return view;
}

std::unique_ptr<PlotView> placePlot(const HandlingReport& handling, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(Words::tr("Where the objects lay at the end"));
    view->setXAxis({Words::tr("Offset from target, x (mm)"), {}, {}});
    view->setYAxis({Words::tr("Offset from target, y (mm)"), {}, {}});
    view->setEqualScale(true);
    if (handling.targetRadius_mm > 0.0)
        view->addCircle(Words::tr("target"), handling.targetRadius_mm);
    std::vector<PlotPoint> placed, left;
    for (const HandlingTrialRow& row : handling.rows)
        if (row.x_mm && row.y_mm)
            (row.outcome == TrialOutcome::done ? placed : left).push_back({*row.x_mm, *row.y_mm});
    view->addMarkers(Words::tr("set down"), placed, PlotStyle::solidA);
    if (!left.empty())
        view->addMarkers(Words::tr("not done"), left, PlotStyle::solidA, true);
    if (placed.empty() && left.empty())
        view->setNote(handling.rows.empty() ? Words::tr("No trial was started")
                                            : Words::tr("No trial was finished"));
    return view;
}

WordTable handlingTable(const HandlingReport& handling, const QLocale& locale) {
    const bool weighing = std::any_of(handling.rows.begin(), handling.rows.end(),
                                      [](const auto& row) { return row.heaviest.has_value(); });
    WordTable table{{Words::tr("Trial"), Words::tr("Outcome"), Words::tr("Largest squeeze"),
                     Words::tr("Squeezed too hard"), Words::tr("Target distance"), Words::tr("x, y (mm)")},
                    {}};
    if (weighing)
        table.head.push_back(Words::tr("Chosen"));
    for (const HandlingTrialRow& row : handling.rows) {
        const QString place = row.x_mm && row.y_mm
                                  ? QStringLiteral("%1, %2").arg(locale.toString(*row.x_mm, 'f', 1),
                                                                 locale.toString(*row.y_mm, 'f', 1))
                                  : kNothing;
        table.rows.push_back({locale.toString(row.trial + 1), trialOutcomeWords(row.outcome, false),
                              inUnit(row.squeezeMax_N, "N", locale), inUnit(row.overLimit_s, "s", locale),
                              row.taken ? inUnit(row.fromTarget_mm, "mm", locale) : Words::tr("never held"),
                              place});
        if (weighing)
            table.rows.back().push_back(!row.heaviest   ? kNothing
                                        : *row.heaviest ? Words::tr("✓ the heaviest")
                                                        : Words::tr("✗ a lighter one"));
    }
    return table;
}

void HandlingSection::addTo(BlockMaker& blocks) const {
    blocks.addHeading(Words::tr("Squeeze and place of each trial"));
    PlotView* squeeze = blocks.keep(squeezePlot(m_handling, blocks.theme()));
    PlotView* place = blocks.keep(placePlot(m_handling, blocks.theme()));
    blocks.add(270, 8, [squeeze, place](QCPPainter& p, const QRectF& box) {
        const double left = box.width() * 0.54 - 8;
        squeeze->paintTo(p, QRectF(box.left(), box.top(), left, box.height()));
        place->paintTo(p, QRectF(box.left() + left + 8, box.top(), box.width() - left - 8, box.height()));
    });
    blocks.addTrialTable(handlingTable(m_handling, blocks.theme().locale));
}

} // namespace chiron::report
