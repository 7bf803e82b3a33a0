// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/results/learning_curve.h"

#include "report/report_text.h"
#include "session_report/metric_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(LearningCurve)
};

constexpr double kMostNames = 25; // with more attempts the axis numbers them itself

struct Curve {
    std::vector<double> x;
    std::vector<double> y;
};

Curve curveOf(const std::vector<Attempt>& attempts, const std::string& metric, bool felt) {
    Curve curve;
    for (const Attempt& attempt : attempts) {
        if (!attempt.onCurve() || attempt.summary.felt != felt)
            continue;
        const scoring::MetricValue* value = attempt.metric(metric);
        if (value && value->value) {
            // Attempts are numbered as in lists; sessions that are not on the curve leave a gap.
            curve.x.push_back(attempt.summary.attempt);
            curve.y.push_back(*value->value);
        }
    }
    return curve;
}

void draw(report::PlotView& view, const QString& name, const Curve& curve, report::PlotStyle style) {
    if (curve.x.empty())
        return;
    std::vector<report::PlotPoint> points;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        points.push_back({curve.x[i], curve.y[i]});
    if (curve.x.size() > 1)
        view.addLine({}, curve.x, curve.y, style);
    view.addMarkers(name, points, style);
}

} // namespace

std::unique_ptr<report::PlotView> learningCurve(const std::vector<Attempt>& attempts,
                                                const report::MetricRow& row,
                                                const report::PlotTheme& theme) {
    auto view = std::make_unique<report::PlotView>(theme);
    const QString title = session_report::metricTitle(row.id);
    view->setTitle(Words::tr("%1 over the attempts").arg(title));
    const bool counts = row.unit == QLatin1String("count");
    view->setYAxis(
        {counts || row.unit.isEmpty() ? title : Words::tr("%1 (%2)").arg(title, row.unit), {}, {}});
    if (counts)
        view->setYWholeNumbers();
    Curve felt = curveOf(attempts, row.id.toStdString(), true);
    Curve shown = curveOf(attempts, row.id.toStdString(), false);
    double last = 0.0;
    for (const Curve* curve : {&felt, &shown})
        if (!curve->x.empty())
            last = std::max(last, curve->x.back());
    const bool named = last <= kMostNames;
    for (Curve* curve : {&felt, &shown})
        for (double& x : curve->x)
            x -= named ? 1.0 : 0.0; // categories start at 0
    if (row.bandLow && row.bandHigh && !felt.x.empty())
        view->addBand(Words::tr("benchmark, felt (%1)").arg(session_report::bandSourceText(row.bandSource)),
                      *row.bandLow, *row.bandHigh);
    draw(*view, Words::tr("felt"), felt, report::PlotStyle::solidA);
    draw(*view, Words::tr("shown, not felt"), shown, report::PlotStyle::dashedB);
    for (const auto& gate : {row.gateMinimum, row.gateMaximum})
        if (gate)
            view->addLimit(Words::tr("pass mark %1").arg(report::formatGate(row, theme.locale)), *gate);
    view->setXAxis({Words::tr("Attempt"), {}, {}});
    if (named) {
        std::vector<QString> names;
        for (int i = 1; i <= std::max(1, static_cast<int>(last)); ++i)
            names.push_back(theme.locale.toString(i));
        view->setXCategories(names);
    } else {
        view->setXWholeNumbers();
    }
    if (felt.x.empty() && shown.x.empty())
        view->setNote(Words::tr("No completed attempt yet"));
    return view;
}

} // namespace chiron::desktop
