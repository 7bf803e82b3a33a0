// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/studies/preview_work.h"
#include "desktop/studies/study_page.h"

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace chiron::desktop {

class FieldGrid;
class WorkToken;

/// Shows the expected results of a design. Simulated observers produce them on a worker.
/// Thread: GUI.
class PreviewPage final : public QWidget {
    Q_OBJECT
public:
    explicit PreviewPage(const DesignPage& page, QWidget* parent = nullptr);
    ~PreviewPage() override; ///< cancels running work
    bool working() const;

private:
    QWidget* observerBox();
    QWidget* observerGrid();
    /// Adds how well an apex is found with this number of trials and participants, from the published spread
    /// of marks.
    void addApexFacts(const psychophysics::Condition& condition,
                      const std::function<void(const QString&, const QString&)>& fact) const;
    void start();
    void finished(core::Result<std::vector<PreviewResult>> results);
    void setWorking(bool working);
    QWidget* resultBox(const PreviewResult& result);
    QWidget* plotOf(const PreviewResult& result) const;
    /// A field in per cent for a standard deviation in log10 units.
    QDoubleSpinBox* spreadField(FieldGrid& grid, const QString& label, const QString& name, double& sd_log10);
    QWidget* powerGrid(); ///< assumptions for a comparison of two conditions
    void showPower();     ///< for all results, under the current assumptions; simulates nothing again

    DesignPage m_page;
    psychophysics::ObserverSpec m_observer{.weber = 0.1, .lapse = 0.02};
    int m_runs = 40;
    psychophysics::PowerQuestion m_power; ///< except for the SD of a run, which is simulated
    double m_wantedPower = 0.8;
    struct PowerLabels {
        double runSdLog10;
        double runSdError; ///< its Monte Carlo standard error
        QLabel* value;
        QLabel* name;
    };
    std::vector<PowerLabels> m_powers; ///< of the displayed results
    QDoubleSpinBox* m_personSd = nullptr;
    QDoubleSpinBox* m_effectSd = nullptr;
    std::shared_ptr<WorkToken> m_work;
    QPushButton* m_start = nullptr;
    QPushButton* m_cancel = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_note = nullptr;
    QVBoxLayout* m_results = nullptr;
    QTimer* m_poll = nullptr;
};

} // namespace chiron::desktop
