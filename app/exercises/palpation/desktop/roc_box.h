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

/// The receiver operating characteristic of a person, computed from the confidence ratings of all findings in
/// all their sessions of one level. Shows the area under the curve and the counts behind it, or the reason
/// why there is none yet.
/// Thread: GUI.
class RocBox final : public ResultsPart {
    Q_OBJECT
public:
    RocBox(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);
    ~RocBox() override;

    void ask(Background& background, database::Database& database, const database::Actor& actor,
             const ResultsQuestion& question) override;
    /// `felt`: the device class of the sessions; the two classes are never pooled.
    void show(const session::PooledDetection& pooled, bool felt);
    using QWidget::show;

private:
    const Theme& m_theme;
    QLocale m_locale;
    StatePanel* m_panel;
    std::shared_ptr<WorkToken> m_work;
    std::optional<int> m_level; ///< the level that is shown or being read: choosing another metric does not
                                ///< read again
};

/// "Area under the curve: 0.84 ... Sessions: 6. Places with a lump: 24, without: 70." Pure function.
QString rocSummary(const session::PooledDetection& pooled, bool felt, const scoring::RocCurve& curve,
                   const QLocale& locale);
/// The curve with the line of chance.
/// Thread: GUI.
std::unique_ptr<report::PlotView> rocPlot(const scoring::RocCurve& curve, const Theme& theme,
                                          const QLocale& locale);

} // namespace chiron::desktop
