// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/station/platform_check.h"
#include "desktop/station/station_record.h"
#include "desktop/theme/theme.h"

#include <QFrame>
#include <QLocale>
#include <memory>
#include <optional>

class QPushButton;
class QVBoxLayout;

namespace chiron::report {
class PlotView;
struct CheckRecord;
struct CheckTable;
struct PlotTheme;
} // namespace chiron::report

namespace chiron::desktop {

/// The fingertip platform on the station screen: starts P3's verification manually, and shows its figures
/// beside the published ones, plots, the effect of degraded parts, and a record to print.
/// Thread: GUI.
class PlatformCard final : public QFrame {
    Q_OBJECT
public:
    PlatformCard(const Theme& theme, const QLocale& locale, bool mayRun, QWidget* parent = nullptr);

    void show(PlatformCheck check);
    void showStopped();
    void showError(const core::Error& error);
    void setReady(bool ready);                    ///< false while the check or a session runs
    QPushButton* button() const { return m_run; } ///< null if the person may not run the check
    /// Writes the newest check; does nothing if there is none yet.
    /// Errors: storage.
    core::Result<void> writeRecord(const QString& path, const CheckCircumstances& of) const;
    using QFrame::show;

signals:
    void checkAsked();
    void recordAsked();

private:
    void clear();
    void addTable(const report::CheckTable& table, const char* name);
    void addPlots();

    const Theme& m_theme;
    QLocale m_locale;
    QPushButton* m_run = nullptr;
    QPushButton* m_record = nullptr;
    QVBoxLayout* m_results;
    std::optional<PlatformCheck> m_check;
};

/// The plots of a check: the sine as commanded, sensed and true; poses as commanded and sensed; the size of
/// their errors.
std::unique_ptr<report::PlotView> platformSinePlot(const PlatformCheck& check, const report::PlotTheme& look);
std::unique_ptr<report::PlotView> platformPosePlot(const PlatformCheck& check, const report::PlotTheme& look);
std::unique_ptr<report::PlotView> platformErrorPlot(const PlatformCheck& check,
                                                    const report::PlotTheme& look);

} // namespace chiron::desktop
