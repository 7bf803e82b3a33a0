// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/ranking_summary.h"

#include <QFrame>

class QVBoxLayout;

namespace chiron::desktop {

class AppContext;
class FieldGrid;

/// Shows the results of ranking three objects, each with its explanation: complete orders, agreement (W),
/// similarity to the true order (τ), trend (L), and the worths of the objects by three models as dots with
/// intervals and as a table. Without a ranking it says that there is none.
/// Thread: GUI.
class RankingBox final : public QFrame {
    Q_OBJECT
public:
    enum class Of { person, group };

    /// Keeps nothing of `summary`.
    RankingBox(AppContext& app, const psychophysics::RankingSummary& summary, Of of,
               QWidget* parent = nullptr);

private:
    void addMeasures(QVBoxLayout& column, const psychophysics::RankingSummary& summary, Of of);
    void addMeasure(FieldGrid& grid, const QString& name, const QString& value, const QString& detail,
                    const QString& meaning);
    void addWorths(QVBoxLayout& column, const psychophysics::RankingSummary& summary);
    QWidget* worthPlot(const QString& title, const QString& axis, const psychophysics::WorthEstimate& worth);
    QWidget* worthTable(const psychophysics::RankingSummary& summary);

    AppContext& m_app;
};

} // namespace chiron::desktop
