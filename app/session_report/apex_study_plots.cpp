// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/apex_study_plots.h"

#include "session_report/study_report_text.h"

#include <array>
#include <cmath>
#include <map>

namespace chiron::session_report {

using psychophysics::ApexSummary;
using report::PlotPoint;
using report::PlotView;

namespace {

constexpr std::size_t kNamed = 8; ///< largest number of people in the legend

QString nameOf(const std::vector<QString>& names, int participant) {
    const auto at = static_cast<std::size_t>(participant);
    return participant >= 0 && at < names.size() ? names[at] : QString();
}

std::unique_ptr<PlotView> empty(std::unique_ptr<PlotView> plot) {
    plot->setNote(Words::tr("No mark yet"));
    return plot;
}

} // namespace

std::unique_ptr<PlotView> apexMarksPlot(const ApexSummary& summary, const std::vector<QString>& names,
                                        const report::PlotTheme& theme) {
    auto plot = std::make_unique<PlotView>(theme);
    plot->setTitle(Words::tr("Marks around the true apex"));
    plot->setXAxis({Words::tr("Error in x (% of radius)"), {}, {}});
    plot->setYAxis({Words::tr("Error in y (% of radius)"), {}, {}});
    plot->setEqualScale(true);
    plot->addCircle(Words::tr("radius R"), 100.0);
    if (summary.points.empty())
        return empty(std::move(plot));
    std::map<int, std::vector<PlotPoint>> people;
    for (const psychophysics::ApexPoint& point : summary.points)
        people[point.participant].push_back({point.xPercent, point.yPercent});
    int group = 0;
    for (const auto& [participant, points] : people)
        plot->addGroupMarkers(people.size() <= kNamed ? nameOf(names, participant) : QString(), points,
                              group++);
    const auto& [x, y] = summary.axes;
    plot->addArrow(Words::tr("bias"), {0.0, 0.0}, {x.biasPercent, y.biasPercent});
    if (std::isfinite(x.sdPercent) && std::isfinite(y.sdPercent))
        plot->addEllipse(Words::tr("± 1 SD per axis"), {x.biasPercent, y.biasPercent}, x.sdPercent,
                         y.sdPercent);
    return plot;
}

std::unique_ptr<PlotView> apexErrorPlot(const ApexSummary& summary, const std::vector<QString>& names,
                                        const report::PlotTheme& theme) {
    auto plot = std::make_unique<PlotView>(theme);
    plot->setTitle(Words::tr("Error in locating spheres"));
    plot->setYAxis({Words::tr("Absolute error (% of radius)"), 0.0, {}});
    if (summary.bars.empty())
        return empty(std::move(plot));
    std::vector<QString> people;
    std::vector<PlotPoint> means;
    std::vector<double> spreads;
    for (const psychophysics::ApexBar& bar : summary.bars) {
        means.push_back({static_cast<double>(people.size()), bar.meanPercent});
        spreads.push_back(bar.sdPercent);
        people.push_back(nameOf(names, bar.participant));
    }
    plot->addMeans(Words::tr("mean over both axes ± SD"), means, spreads);
    if (summary.bars.size() > 1)
        plot->addReference(Words::tr("group"), summary.meanAbsolutePercent);
    const std::array across{-0.6, static_cast<double>(people.size()) - 0.4};
    const std::array published{psychophysics::kP2MeanPercent, psychophysics::kP2MeanPercent};
    plot->addLine(
        Words::tr("published: %1 %").arg(theme.locale.toString(psychophysics::kP2MeanPercent, 'f', 1)),
        across, published, report::PlotStyle::dottedC);
    plot->setXCategories(people);
    return plot;
}

} // namespace chiron::session_report
