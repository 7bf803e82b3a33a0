// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session/detection_record.h"
#include "desktop/frame/background.h"
#include "desktop/results/results_part.h"
#include "desktop/theme/theme.h"

#include <QLocale>
#include <memory>
#include <optional>

namespace chiron::report {
class PlotView;
}

namespace chiron::desktop {

class StatePanel;

/// Receiver operating characteristic of a person, from how sure they said they were of each finding, over all their sessions of
/// one level: with its area and with what it counts; or what is missing until there is one. GUI thread.
class RocBox final : public ResultsPart {
    Q_OBJECT
public:
    RocBox(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);
    ~RocBox() override;

    void ask(Background& background, database::Database& database, const database::Actor& actor, const ResultsQuestion& question) override;
    /// `felt`: of which device class it is; the two are never pooled.
    void show(const session::PooledDetection& pooled, bool felt);
    using QWidget::show;

private:
    const Theme& m_theme;
    QLocale m_locale;
    StatePanel* m_panel;
    std::shared_ptr<WorkToken> m_work;
    std::optional<int> m_level; ///< that is shown, or read: another metric reads nothing anew
};

/// "Area under the curve: 0.84 ... Sessions: 6. Places with a lump: 24, without: 70." Pure.
QString rocSummary(const session::PooledDetection& pooled, bool felt, const scoring::RocCurve& curve, const QLocale& locale);
/// The curve with the line of chance. GUI thread.
std::unique_ptr<report::PlotView> rocPlot(const scoring::RocCurve& curve, const Theme& theme, const QLocale& locale);

} // namespace chiron::desktop
