// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/roster_import.h"
#include "report/plot_theme.h"

#include <QString>
#include <vector>

class QPagedPaintDevice;

namespace chiron::desktop {

/// A slip of paper for each new person: who, login name, password, site, and what to do first.
struct LoginSlips {
    QString site; ///< its name; may be empty
    std::vector<database::ImportedPerson> people;
};

/// As A4 pages to be cut, a PDF that only its owner may read. GUI thread. Failure: storage, naming the path.
core::Result<void> writeLoginSlips(const QString& path, const LoginSlips& slips, const report::PlotTheme& theme);

/// The same pages on a printer. False where it cannot be painted on. GUI thread.
bool paintLoginSlips(QPagedPaintDevice& device, const LoginSlips& slips, const report::PlotTheme& theme);

} // namespace chiron::desktop
