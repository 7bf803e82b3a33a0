// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/roster_import.h"
#include "report/plot_theme.h"

#include <QString>
#include <vector>

class QPagedPaintDevice;

namespace chiron::desktop {

/// The content of the login slips: one slip of paper per new person with name, login name, password, site and
/// first step.
struct LoginSlips {
    QString site; ///< name of the site; may be empty
    std::vector<database::ImportedPerson> people;
};

/// Writes the slips as a PDF of A4 pages to cut up. Only the file's owner may read it.
/// Thread: GUI.
/// Errors: storage naming the path.
core::Result<void> writeLoginSlips(const QString& path, const LoginSlips& slips,
                                   const report::PlotTheme& theme);

/// Paints the same pages on a printer. Returns false if the printer cannot be painted on.
/// Thread: GUI.
bool paintLoginSlips(QPagedPaintDevice& device, const LoginSlips& slips, const report::PlotTheme& theme);

} // namespace chiron::desktop
