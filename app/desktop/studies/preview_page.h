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

class WorkToken;

/// What a design may be expected to give: simulated observers do it, on a worker. GUI thread.
class PreviewPage final : public QWidget {
    Q_OBJECT
public:
    explicit PreviewPage(const DesignPage& page, QWidget* parent = nullptr);
    ~PreviewPage() override; ///< cancels what is at work
    bool working() const;

private:
    QWidget* observerBox();
    QWidget* observerGrid();
    /// How well an apex is found with so many trials and participants, by the published spread of marks.
    void addApexFacts(const psychophysics::Condition& condition, const std::function<void(const QString&, const QString&)>& fact) const;
    void start();
    void finished(core::Result<std::vector<PreviewResult>> results);
    void setWorking(bool working);
    QWidget* resultBox(const PreviewResult& result);
    QWidget* plotOf(const PreviewResult& result) const;
    QWidget* powerGrid(); ///< what a comparison of two conditions is assumed to be
    void showPower();     ///< of all results, by the assumptions as they are now: nothing is simulated again

    DesignPage m_page;
    psychophysics::ObserverSpec m_observer{.weber = 0.1, .lapse = 0.02};
    int m_runs = 40;
    psychophysics::PowerQuestion m_power; ///< but for the spread of a run, which is simulated
    double m_wantedPower = 0.8;
    struct PowerLabels {
        double runSdLog10;
        QLabel* value;
        QLabel* name;
    };
    std::vector<PowerLabels> m_powers; ///< of the results shown
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
