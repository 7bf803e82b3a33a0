// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/report/apex_report.h"

#include "report/block_maker.h"
#include "report/plot_canvas.h"
#include "report/plot_view.h"
#include "report/report_text.h"
#include <QDir>

namespace chiron::report {

namespace {

constexpr int kLateShape = 2; // group of addGroupMarkers for timeouts: different from marks and misses

} // namespace

std::unique_ptr<PlotView> apexScatterPlot(const std::vector<ApexError>& errors, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(Words::tr("Where the marks lie on the sphere"));
    view->setXAxis({Words::tr("Error in x (% of radius)"), {}, {}});
    view->setYAxis({Words::tr("Error in y (% of radius)"), {}, {}});
    view->setEqualScale(true);
    view->addCircle(Words::tr("outline"), 100.0);
    std::vector<PlotPoint> hits, misses, late;
    for (const ApexError& error : errors)
        (error.timedOut ? late : error.miss ? misses : hits).push_back({error.x_percent, error.y_percent});
    if (!hits.empty() || errors.empty())
        view->addMarkers(Words::tr("mark"), hits, PlotStyle::solidA);
    if (!misses.empty())
        view->addMarkers(Words::tr("miss"), misses, PlotStyle::solidA, true);
    if (!late.empty())
        view->addGroupMarkers(Words::tr("no mark: time was up"), late, kLateShape);
    if (errors.empty())
        view->setNote(Words::tr("No trial was marked"));
    return view;
}

std::unique_ptr<PlotView> apexTrialPlot(const std::vector<ApexError>& errors, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(Words::tr("Error in locating virtual spheres (%)"));
    view->setXAxis({Words::tr("Trial"), {}, {}});
    view->setYAxis({Words::tr("Error (% of radius)"), {}, {}});
    std::vector<QString> names;
    std::vector<PlotPoint> x, y, misses, late;
    for (const ApexError& error : errors) {
        const double place = static_cast<double>(names.size());
        names.push_back(QString::number(error.trial + 1));
        x.push_back({place, error.x_percent});
        y.push_back({place, error.y_percent});
        if (error.timedOut || error.miss)
            (error.timedOut ? late : misses).push_back({place, 0.0});
    }
    view->addBars(QStringLiteral("x"), x, PlotStyle::solidA, 0, 2);
    view->addBars(QStringLiteral("y"), y, PlotStyle::dashedB, 1, 2);
    if (!misses.empty())
        view->addMarkers(Words::tr("miss"), misses, PlotStyle::solidA, true);
    if (!late.empty())
        view->addGroupMarkers(Words::tr("no mark: time was up"), late, kLateShape);
    view->setXCategories(names);
    if (errors.empty())
        view->setNote(Words::tr("No trial was marked"));
    return view;
}

void ApexSection::addTo(BlockMaker& blocks) const {
    blocks.addHeading(Words::tr("Error in locating the apex"));
    PlotView* scatter = blocks.keep(apexScatterPlot(m_errors, blocks.theme()));
    PlotView* bars = blocks.keep(apexTrialPlot(m_errors, blocks.theme()));
    blocks.add(290, 4, [scatter, bars](QCPPainter& p, const QRectF& box) {
        const double left = box.width() * 0.46;
        scatter->paintTo(p, QRectF(box.left(), box.top(), left, box.height()));
        bars->paintTo(p, QRectF(box.left() + left + 8, box.top(), box.width() - left - 8, box.height()));
    });
}

core::Result<void> ApexSection::savePictures(const QDir& folder, const PlotTheme& theme,
                                             std::vector<QString>& written) const {
    if (m_errors.empty())
        return {};
    const QString path = folder.filePath(QStringLiteral("apex_errors.png"));
    if (auto done =
            writePair(path, *apexScatterPlot(m_errors, theme), *apexTrialPlot(m_errors, theme), theme);
        !done)
        return done;
    written.push_back(path);
    return {};
}

} // namespace chiron::report
