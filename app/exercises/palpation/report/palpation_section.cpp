// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/report/palpation_section.h"

#include "report/block_maker.h"
#include "report/plot_canvas.h"
#include "report/report_text.h"

#include <QDir>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace chiron::report {

namespace {

constexpr double kMapHeight = 222.0; // logical pixels; the legends are beside the maps
// Scale of their text: two maps and their legends share the width of a page.
constexpr double kMapScale = 0.66;

using Kind = PalpationFindingRow::Kind;

QString place(const PalpationFindingRow& row, const QLocale& locale) {
    return QStringLiteral("%1, %2").arg(locale.toString(row.x_mm, 'f', 1), locale.toString(row.y_mm, 'f', 1));
}

/// "7.0 (−0.5)": the reported radius, and its error.
QString radius(const PalpationFindingRow& row, const QLocale& locale) {
    if (!(row.radius_mm > 0.0))
        return QStringLiteral("–");
    const QString said = locale.toString(row.radius_mm, 'f', 1);
    if (!row.sizeError_mm)
        return said;
    const QString sign = *row.sizeError_mm < 0.0 ? QStringLiteral("−") : QStringLiteral("+");
    return QStringLiteral("%1 (%2%3)").arg(said, sign, locale.toString(std::abs(*row.sizeError_mm), 'f', 1));
}

QString rating(int value, const QLocale& locale) {
    return value > 0 ? locale.toString(value) : QStringLiteral("–");
}

QString outcome(const PalpationFindingRow& row) {
    switch (row.kind) {
    case Kind::hit:
        return Words::tr("✓ hit");
    case Kind::falseAlarm:
        return Words::tr("✗ false alarm");
    case Kind::missed:
        break;
    }
    return Words::tr("✗ missed lump");
}

/// "1.42 (95 %: 0.80 to 2.04)", or the reason why there is no value.
QString sensitivity(const core::DetectionCounts& regions, const QLocale& locale) {
    if (!core::isUsable(regions))
        return Words::tr("too few regions: %1 with a lump, %2 without")
            .arg(locale.toString(regions.ofSignal), locale.toString(regions.ofNoise));
    const core::DetectionInterval interval = core::dPrimeInterval(regions);
    return Words::tr("%1 (95 %: %2 to %3)")
        .arg(locale.toString(core::dPrime(regions), 'f', 2), locale.toString(interval.low, 'f', 2),
             locale.toString(interval.high, 'f', 2));
}

int countOf(const PalpationReport& report, Kind kind) {
    int count = 0;
    for (const PalpationTrialReport& trial : report.trials)
        count += static_cast<int>(std::count_if(trial.rows.begin(), trial.rows.end(),
                                                [kind](const auto& row) { return row.kind == kind; }));
    return count;
}

void addFindings(BlockMaker& blocks, const PalpationReport& report) {
    const QLocale& locale = blocks.theme().locale;
    std::vector<std::vector<QString>> rows;
    for (const PalpationTrialReport& trial : report.trials)
        for (const PalpationFindingRow& row : trial.rows)
            rows.push_back({locale.toString(trial.trial + 1), rating(row.number, locale), place(row, locale),
                            radius(row, locale), rating(row.hardness, locale), rating(row.confidence, locale),
                            outcome(row),
                            row.error_mm ? locale.toString(*row.error_mm, 'f', 1) : QStringLiteral("–")});
    if (rows.empty()) {
        blocks.addText(Words::tr("Nothing was reported, and nothing was there"), blocks.theme().font(12),
                       blocks.theme().ink, 6);
        return;
    }
    blocks.addTable({Words::tr("Trial"), Words::tr("No."), Words::tr("x, y (mm)"), Words::tr("Radius (mm)"),
                     Words::tr("Hardness"), Words::tr("Confidence"), Words::tr("Outcome"),
                     Words::tr("Error (mm)")},
                    rows, {0.08, 0.07, 0.16, 0.13, 0.12, 0.13, 0.19, 0.12},
                    {true, true, true, true, true, true, false, true});
}

void addMaps(BlockMaker& blocks, const PalpationTrialReport& trial) {
    blocks.addHeading(trial.timedOut ? Words::tr("Trial %1, time ran out").arg(trial.trial + 1)
                                     : Words::tr("Trial %1").arg(trial.trial + 1));
    blocks.add(kMapHeight, 4, [&theme = blocks.theme(), &trial](QCPPainter& p, const QRectF& box) {
        PlotTheme small = theme;
        small.scale = kMapScale;
        paintPalpationMaps(p, box, trial, small);
    });
}

core::Result<void> saveMaps(const PalpationTrialReport& trial, const QString& path, const PlotTheme& theme) {
    const QSizeF size(1400, 440);
    QImage image((size * kPictureScale).toSize(), QImage::Format_RGB32);
    image.fill(theme.paper);
    QPainter painter(&image);
    painter.scale(kPictureScale, kPictureScale);
    paintPalpationMaps(painter, QRectF(QPointF(0, 0), size).adjusted(16, 16, -16, -16), trial, theme);
    painter.end();
    return writePng(path, image);
}

} // namespace

void PalpationSection::addTo(BlockMaker& blocks) const {
    const QLocale& locale = blocks.theme().locale;
    const int hits = countOf(m_report, Kind::hit);
    blocks.addHeading(Words::tr("What was found"));
    blocks.addPairs(
        {{Words::tr("Lumps found"),
          Words::tr("%1 of %2")
              .arg(locale.toString(hits), locale.toString(hits + countOf(m_report, Kind::missed)))},
         {Words::tr("False alarms"), locale.toString(countOf(m_report, Kind::falseAlarm))},
         {Words::tr("Regions: hits, false alarms"),
          Words::tr("%1 of %2, %3 of %4")
              .arg(locale.toString(m_report.regions.hits), locale.toString(m_report.regions.ofSignal),
                   locale.toString(m_report.regions.falseAlarms), locale.toString(m_report.regions.ofNoise))},
         {Words::tr("Sensitivity d′"), sensitivity(m_report.regions, locale)},
         {Words::tr("Criterion c"), core::isUsable(m_report.regions)
                                        ? locale.toString(core::criterion(m_report.regions), 'f', 2)
                                        : QString()}},
        3);
    addFindings(blocks, m_report);
    for (const PalpationTrialReport& trial : m_report.trials)
        addMaps(blocks, trial);
}

// Writes one picture per trial: palpation_1.png and so on.
core::Result<void> PalpationSection::savePictures(const QDir& folder, const PlotTheme& theme,
                                                  std::vector<QString>& written) const {
    for (const PalpationTrialReport& trial : m_report.trials) {
        const QString path = folder.filePath(QStringLiteral("palpation_%1.png").arg(trial.trial + 1));
        CHIRON_TRY(saveMaps(trial, path, theme));
        written.push_back(path);
    }
    return {};
}

void paintPalpationMaps(QPainter& painter, const QRectF& box, const PalpationTrialReport& trial,
                        const PlotTheme& theme) {
    constexpr double kGap = 16.0;
    const double half = 0.5 * (box.width() - kGap);
    PalpationMapView view = trial.view;
    for (const auto kind : {simulation::SurfaceMapKind::coverage, simulation::SurfaceMapKind::force}) {
        view.kind = kind;
        const double left =
            kind == simulation::SurfaceMapKind::coverage ? box.left() : box.left() + half + kGap;
        PalpationMapPainter(trial.map, view, theme)
            .paint(painter, QRectF(left, box.top(), half, box.height()));
    }
}

} // namespace chiron::report
