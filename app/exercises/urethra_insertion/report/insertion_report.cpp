// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/report/insertion_report.h"

#include "report/block_maker.h"
#include "report/plot_canvas.h"
#include "report/plot_view.h"
#include "report/report_text.h"
#include "report/session_plots.h"

#include <QDir>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::report {

namespace {

/// One quantity over depth, on the way in and on the way out.
std::unique_ptr<PlotView> depthPlot(const QString& title, const QString& axis,
                                    const InsertionProfile& profile, const std::vector<double>& in,
                                    const std::vector<double>& out, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(title);
    const auto isNumber = [](double value) { return std::isfinite(value); };
    const bool entered = std::any_of(in.begin(), in.end(), isNumber);
    const double deepest = profile.depth_mm.empty() ? 0.0 : profile.depth_mm.back();
    view->setXAxis({Words::tr("Depth (mm)"),
                    std::min(0.0, profile.depth_mm.empty() ? 0.0 : profile.depth_mm.front()),
                    std::max({deepest, profile.goal_mm, 1.0})});
    view->setYAxis({axis, 0.0, {}});
    view->addLine(Words::tr("in"), profile.depth_mm, in, PlotStyle::solidA);
    if (std::any_of(out.begin(), out.end(), isNumber))
        view->addLine(Words::tr("out"), profile.depth_mm, out, PlotStyle::dashedB);
    const double end_mm = std::max(deepest, profile.goal_mm);
    std::vector<TimedEvent> places;
    for (const auto& [at_mm, name] : {std::pair{profile.bend_mm, Words::tr("bend")},
                                      std::pair{profile.neck_mm, Words::tr("bladder neck")}})
        if (at_mm > 0.0 && at_mm <= end_mm)
            places.push_back({at_mm, name});
    view->addEvents(places);
    if (!entered)
        view->setNote(Words::tr("The endoscope did not enter"));
    return view;
}

} // namespace

std::unique_ptr<PlotView> offsetPlot(const SampleSeries& series, std::string_view id,
                                     const PlotTheme& theme) {
    return derivedPlot(series, id, 1e3,
                       {Words::tr("Distance from the middle of the canal"), Words::tr("Off-centre (mm)"),
                        Words::tr("off-centre")},
                       theme);
}

std::unique_ptr<PlotView> alignmentPlot(const SampleSeries& series, std::string_view id,
                                        const PlotTheme& theme) {
    return derivedPlot(
        series, id, 180.0 / std::numbers::pi,
        {Words::tr("Angle between endoscope and canal"), Words::tr("Alignment (°)"), Words::tr("alignment")},
        theme);
}

std::unique_ptr<PlotView> offsetDepthPlot(const InsertionProfile& profile, const PlotTheme& theme) {
    return depthPlot(Words::tr("Off-centre, largest in each millimetre"), Words::tr("Off-centre (mm)"),
                     profile, profile.offsetIn_mm, profile.offsetOut_mm, theme);
}

std::unique_ptr<PlotView> alignmentDepthPlot(const InsertionProfile& profile, const PlotTheme& theme) {
    return depthPlot(Words::tr("Alignment, largest in each millimetre"), Words::tr("Alignment (°)"), profile,
                     profile.alignmentIn_deg, profile.alignmentOut_deg, theme);
}

void InsertionSection::addTo(BlockMaker& blocks) const {
    const QLocale& locale = blocks.theme().locale;
    blocks.addHeading(Words::tr("Off-centre and alignment over depth"));
    if (m_profile.landmarks > 0)
        blocks.addPairs(
            {{Words::tr("Landmarks of the bladder seen"),
              Words::tr("%1 of %2")
                  .arg(locale.toString(m_profile.landmarksSeen), locale.toString(m_profile.landmarks))}},
            1);
    PlotView* offset = blocks.keep(offsetDepthPlot(m_profile, blocks.theme()));
    PlotView* alignment = blocks.keep(alignmentDepthPlot(m_profile, blocks.theme()));
    blocks.add(250, 4, [offset, alignment](QCPPainter& p, const QRectF& box) {
        const double half = 0.5 * (box.width() - 8);
        offset->paintTo(p, QRectF(box.left(), box.top(), half, box.height()));
        alignment->paintTo(p, QRectF(box.left() + half + 8, box.top(), half, box.height()));
    });
}

core::Result<void> InsertionSection::savePictures(const QDir& folder, const PlotTheme& theme,
                                                  std::vector<QString>& written) const {
    const QString path = folder.filePath(QStringLiteral("insertion.png"));
    if (auto done =
            writePair(path, *offsetDepthPlot(m_profile, theme), *alignmentDepthPlot(m_profile, theme), theme);
        !done)
        return done;
    written.push_back(path);
    return {};
}

} // namespace chiron::report
