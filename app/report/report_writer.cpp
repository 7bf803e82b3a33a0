// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_writer.h"

#include "report/page_writer.h"
#include "report/plot_canvas.h"
#include "report/report_blocks.h"
#include "report/report_section.h"
#include "report/report_text.h"
#include "report/session_plots.h"

#include <QDir>
#include <qcustomplot.h>

namespace chiron::report {

namespace {

core::Error storageError(const QString& path, const QString& reason) {
    return {core::ErrorCode::storage, path.toStdString() + ": was not written: " + reason.toStdString()};
}

PageFrame frameOf(const ReportData& data, const PlotTheme& theme) {
    const auto joined = [](QStringList parts) {
        parts.removeAll(QString());
        return parts.join(QStringLiteral(" · "));
    };
    const IntegrityFacts& facts = data.integrity;
    PageFrame frame;
    frame.heading = Words::tr("Session report");
    frame.site = data.site;
    frame.who = joined({facts.sessionId, formatMoment(data.startedUtc, data.offsetMinutes, theme.locale)});
    frame.proof =
        joined({data.demonstration ? Words::tr("Demonstration") : QString(), facts.buildId,
                facts.recordingDigest.isEmpty() ? Words::tr("no recording digest") : facts.recordingDigest});
    frame.title = QStringLiteral("Chiron session report: %1, %2, session %3, recording %4")
                      .arg(data.person, data.exerciseTitle, facts.sessionId, facts.recordingDigest);
    frame.creator = QStringLiteral("Chiron %1").arg(facts.buildId).trimmed();
    return frame;
}

core::Result<void> save(PlotView& plot, const QString& path, QSize size, const PlotTheme& theme) {
    return writePng(path,
                    renderPanels({{&plot, QRectF(QPointF(0, 0), QSizeF(size))}}, size, kPictureScale, theme));
}

} // namespace

core::Result<void> writeSessionPdf(const QString& path, const ReportData& data, const PlotTheme& theme) {
    const ReportBlocks content(data, theme, kPageBodyWidth);
    return writePages(path, frameOf(data, theme), content.blocks(), theme);
}

bool paintSession(QPagedPaintDevice& device, const ReportData& data, const PlotTheme& theme) {
    const ReportBlocks content(data, theme, kPageBodyWidth);
    return paintPages(device, frameOf(data, theme), content.blocks(), theme);
}

core::Result<std::vector<QString>> writeSessionPngs(const QString& folder, const ReportData& data,
                                                    const PlotTheme& theme) {
    const QDir directory(folder);
    if (!directory.mkpath(QStringLiteral(".")))
        return tl::unexpected(storageError(folder, QStringLiteral("the folder could not be made")));
    const QSize wide(900, 360);
    std::vector<QString> written;
    // Stacks the plots in a column, if several tools need several plots.
    const auto writeColumn = [&](const char* name,
                                 std::vector<std::unique_ptr<PlotView>> plots) -> core::Result<void> {
        std::erase(plots, nullptr);
        const QSize size(wide.width(), wide.height() * static_cast<int>(plots.size()));
        std::vector<Panel> panels;
        for (std::size_t i = 0; i < plots.size(); ++i)
            panels.push_back({plots[i].get(), QRectF(0, static_cast<double>(i) * wide.height(), wide.width(),
                                                     wide.height())});
        const QString path = directory.filePath(QLatin1String(name));
        auto result = writePng(path, renderPanels(panels, size, kPictureScale, theme));
        if (result)
            written.push_back(path);
        return result;
    };
    std::vector<std::unique_ptr<PlotView>> forces;
    forces.push_back(forcePlot(data.series, data.forceLimit_N, theme));
    forces.push_back(feltForcePlot(data.series, data.forceLimit_N, theme));
    forces.push_back(measuredForcePlot(data.series, data.forceLimit_N, theme));
    CHIRON_TRY(writeColumn("position.png", positionPlots(data.series, theme)));
    CHIRON_TRY(writeColumn("force.png", std::move(forces)));
    const QString speed = directory.filePath(QStringLiteral("speed.png"));
    CHIRON_TRY(save(*speedPlot(data.series, theme), speed, wide, theme));
    written.push_back(speed);
    for (const auto& section : data.sections)
        CHIRON_TRY(section->savePictures(directory, theme, written));
    return written;
}

core::Result<void> writeComparisonPng(const QString& path, const ComparisonData& data,
                                      const PlotTheme& theme) {
    return save(*comparisonPlot(data, theme), path, QSize(900, 460), theme);
}

} // namespace chiron::report
