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
}

namespace chiron::desktop {

/// The fingertip platform on the station screen: P3's verification started by hand, its figures beside the published ones, plots, what
/// makes them worse, and a record to be printed. GUI thread.
class PlatformCard final : public QFrame {
    Q_OBJECT
public:
    PlatformCard(const Theme& theme, const QLocale& locale, bool mayRun, QWidget* parent = nullptr);

    void show(PlatformCheck check);
    void showStopped();
    void showError(const core::Error& error);
    void setReady(bool ready); ///< false: while it runs, or while a session does
    QPushButton* button() const { return m_run; } ///< null for who may only look
    /// Writes the newest check; nothing before there is one. Failure: storage.
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

/// The plots of a check: the sine as wanted, sensed and really so; poses as wanted and sensed; how large their errors were.
std::unique_ptr<report::PlotView> platformSinePlot(const PlatformCheck& check, const report::PlotTheme& look);
std::unique_ptr<report::PlotView> platformPosePlot(const PlatformCheck& check, const report::PlotTheme& look);
std::unique_ptr<report::PlotView> platformErrorPlot(const PlatformCheck& check, const report::PlotTheme& look);

} // namespace chiron::desktop
