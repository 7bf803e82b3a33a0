// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_writer.h"

#include "report/page_writer.h"
#include "report/plot_canvas.h"
#include "report/report_blocks.h"
#include "report/report_text.h"
#include "report/session_plots.h"

#include <QDir>
#include <QPainter>
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
    frame.who = joined({facts.sessionId, formatMoment(data.startedUtc, data.offsetMinutes, theme.locale)});
    frame.proof = joined({data.demonstration ? Words::tr("Demonstration") : QString(), facts.buildId,
                          facts.recordingDigest.isEmpty() ? Words::tr("no recording digest") : facts.recordingDigest});
    frame.title = QStringLiteral("Chiron session report: %1, %2, session %3, recording %4")
                      .arg(data.person, data.exerciseTitle, facts.sessionId, facts.recordingDigest);
    frame.creator = QStringLiteral("Chiron %1").arg(facts.buildId).trimmed();
    return frame;
}

constexpr double kPngScale = 2.0;

core::Result<void> save(PlotView& left, PlotView* right, const QString& path, QSize size,
                        const PlotTheme& theme) {
    std::vector<Panel> panels{{&left, QRectF(QPointF(0, 0), QSizeF(size))}};
    if (right) {
        const double split = 0.46 * size.width();
        panels = {{&left, QRectF(0, 0, split, size.height())},
                  {right, QRectF(split, 0, size.width() - split, size.height())}};
    }
    return writePng(path, renderPanels(panels, size, kPngScale, theme));
}

core::Result<void> saveMaps(const PalpationTrialReport& trial, const QString& path, const PlotTheme& theme) {
    const QSizeF size(1400, 440);
    QImage image((size * kPngScale).toSize(), QImage::Format_RGB32);
    image.fill(theme.paper);
    QPainter painter(&image);
    painter.scale(kPngScale, kPngScale);
    paintPalpationMaps(painter, QRectF(QPointF(0, 0), size).adjusted(16, 16, -16, -16), trial, theme);
    painter.end();
    return writePng(path, image);
}

/// One picture a trial: palpation_1.png, ...
core::Result<void> saveAllMaps(const PalpationReport& report, const QDir& folder, const PlotTheme& theme, std::vector<QString>& written) {
    for (const PalpationTrialReport& trial : report.trials) {
        const QString path = folder.filePath(QStringLiteral("palpation_%1.png").arg(trial.trial + 1));
        if (auto done = saveMaps(trial, path, theme); !done)
            return done;
        written.push_back(path);
    }
    return {};
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
    const auto write = [&](const char* name, std::unique_ptr<PlotView> left,
                           std::unique_ptr<PlotView> right) {
        const QString path = directory.filePath(QLatin1String(name));
        auto result = save(*left, right.get(), path, right ? QSize(960, 420) : wide, theme);
        if (result)
            written.push_back(path);
        return result;
    };
    // One below the other, where several tools need several plots.
    const auto writeColumn = [&](const char* name, std::vector<std::unique_ptr<PlotView>> plots) -> core::Result<void> {
        std::erase(plots, nullptr);
        const QSize size(wide.width(), wide.height() * static_cast<int>(plots.size()));
        std::vector<Panel> panels;
        for (std::size_t i = 0; i < plots.size(); ++i)
            panels.push_back({plots[i].get(), QRectF(0, static_cast<double>(i) * wide.height(), wide.width(), wide.height())});
        const QString path = directory.filePath(QLatin1String(name));
        auto result = writePng(path, renderPanels(panels, size, kPngScale, theme));
        if (result)
            written.push_back(path);
        return result;
    };
    std::vector<std::unique_ptr<PlotView>> forces;
    forces.push_back(forcePlot(data.series, data.forceLimit_N, theme));
    forces.push_back(feltForcePlot(data.series, data.forceLimit_N, theme));
    forces.push_back(measuredForcePlot(data.series, data.forceLimit_N, theme));
    if (auto done = writeColumn("position.png", positionPlots(data.series, theme)); !done)
        return tl::unexpected(done.error());
    if (auto done = writeColumn("force.png", std::move(forces)); !done)
        return tl::unexpected(done.error());
    if (auto done = write("speed.png", speedPlot(data.series, theme), nullptr); !done)
        return tl::unexpected(done.error());
    if (!data.apexErrors.empty()) {
        auto done = write("apex_errors.png", apexScatterPlot(data.apexErrors, theme),
                          apexTrialPlot(data.apexErrors, theme));
        if (!done)
            return tl::unexpected(done.error());
    }
    if (data.insertion) {
        auto done = write("insertion.png", offsetDepthPlot(*data.insertion, theme), alignmentDepthPlot(*data.insertion, theme));
        if (!done)
            return tl::unexpected(done.error());
    }
    if (data.palpation)
        if (auto done = saveAllMaps(*data.palpation, directory, theme, written); !done)
            return tl::unexpected(done.error());
    return written;
}

core::Result<void> writeComparisonPng(const QString& path, const ComparisonData& data,
                                      const PlotTheme& theme) {
    return save(*comparisonPlot(data, theme), nullptr, path, QSize(900, 460), theme);
}

} // namespace chiron::report
