// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "session/study/live_sitting.h"

#include <QLocale>
#include <QScrollArea>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace chiron::report {
class PlotView;
}

namespace chiron::desktop {

/// The experimenter's view: progress, the developing estimate, and the fidelity of the last trial; with
/// buttons to spoil a trial, pause and stop. If the study is blind it shows sealed codes and no estimate.
/// Thread: GUI.
class ExperimenterPanel final : public QScrollArea {
    Q_OBJECT
public:
    ExperimenterPanel(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);

    void show(const session::LiveStudyView& view, const session::LiveStudyNumbers& numbers,
              const psychophysics::Condition& condition);

signals:
    void spoilAsked();
    void pauseAsked();
    void stopAsked();

private:
    QPushButton* add(const char* name, const QString& text, const char* kind, const char* icon);
    void takeEstimates(const session::LiveStudyNumbers& numbers, const psychophysics::Condition& condition);
    void draw(const psychophysics::Condition& condition);
    QString forceText(const session::TrialFidelity& trial) const;
    void drawApex(const psychophysics::ApexSummary& apex);
    QString fidelityText(const session::LiveStudyNumbers& numbers) const;
    QString delayText(const session::RenderingLimits& limits) const;

    /// A procedure's estimate after a trial, as a Weber fraction in per cent.
    struct Point {
        double trial = 0.0;
        double weber = 0.0;
        double low = 0.0;
        double high = 0.0;
    };
    const Theme& m_theme;
    QLocale m_locale;
    QLabel* m_what = nullptr;
    QLabel* m_progress = nullptr;
    QLabel* m_estimate = nullptr;
    QLabel* m_fidelity = nullptr;
    QVBoxLayout* m_plotHolder = nullptr;
    report::PlotView* m_plot = nullptr;
    QPushButton* m_spoil = nullptr;
    QPushButton* m_pause = nullptr;
    QPushButton* m_stop = nullptr;
    int m_seen = -1;                          ///< number of presentations already shown
    std::vector<std::vector<Point>> m_points; ///< [procedure]
};

/// Converts a procedure's first parameter into a Weber fraction: log10 σ by W = 10^(0.954 σ) − 1, a threshold
/// by its scale; NaN for any other parameter.
double weberOf(const std::string& parameter, double value, psychophysics::ProcedureScale scale);

} // namespace chiron::desktop
