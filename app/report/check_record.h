// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/plot_theme.h"

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

class QPagedPaintDevice;

namespace chiron::report {

class PlotView;

/// A table of a check: words and numbers in display form. The first line holds the column headings.
struct CheckTable {
    QString title;
    std::vector<QStringList> lines;
};

/// The results of a check of a station, for printing and storage: text, tables and plots.
struct CheckRecord {
    QString title;
    QString when; ///< time and place, in display form
    /// Pairs of name and value under the title: who, when, station, device and serial number, build and so
    /// on.
    std::vector<std::pair<QString, QString>> head{};
    QString foot{}; ///< shown at the foot of each page, before the page number
    QString verdict;
    QStringList facts; ///< one paragraph each
    std::vector<CheckTable> tables;
    std::vector<PlotView*> plots; ///< drawn as vectors; owned by the caller
};

/// Writes the record as A4 pages (PDF/A-1b). Replaces `path` only once the whole file is written.
/// Thread: GUI.
/// Errors: storage naming the path.
core::Result<void> writeCheckPdf(const QString& path, const CheckRecord& record, const PlotTheme& theme);

/// Paints the same pages on the caller's device, at its resolution. Each page shows its number and the number
/// of pages. Returns false if the device cannot be painted on or refuses a new page.
/// Thread: GUI.
bool paintCheck(QPagedPaintDevice& device, const CheckRecord& record, const PlotTheme& theme);

} // namespace chiron::report
