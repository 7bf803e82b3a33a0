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

/// A table of a check: words and numbers as they are shown, the first line its heads.
struct CheckTable {
    QString title;
    std::vector<QStringList> lines;
};

/// What a check of a station found, to be printed and kept: in words, tables and plots.
struct CheckRecord {
    QString title;
    QString when; ///< and where, as it is shown
    /// Who, when, station, device and serial number, build ...: a name and its value each, under the title.
    std::vector<std::pair<QString, QString>> head{};
    QString foot{}; ///< at the foot of each page, before its number
    QString verdict;
    QStringList facts; ///< a paragraph each
    std::vector<CheckTable> tables;
    std::vector<PlotView*> plots; ///< drawn as vectors; the caller's
};

/// Writes it as A4 pages (PDF/A-1b). GUI thread; replaces `path` only when the whole file is written. Fails with storage, naming
/// the path.
core::Result<void> writeCheckPdf(const QString& path, const CheckRecord& record, const PlotTheme& theme);

/// The same pages on somebody's own device, at its resolution. False where it cannot be painted on, or gives no further page. GUI thread.
/// Each page bears its number and how many there are.
bool paintCheck(QPagedPaintDevice& device, const CheckRecord& record, const PlotTheme& theme);

} // namespace chiron::report
