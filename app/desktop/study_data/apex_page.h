// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// Shows the results of an apex search as in P2's figure 4: marks about the true apex by person, bias and SD
/// per axis, errors in mm and per cent of the radius. They come from all participants at one condition, or
/// from one run.
/// Thread: GUI; the facts outlive it.
class ApexPage final : public QWidget {
    Q_OBJECT
public:
    ApexPage(AppContext& app, const StudyFacts& facts, std::size_t condition, QWidget* parent = nullptr);
    ApexPage(AppContext& app, const StudyFacts& facts, const RunFacts& run, QWidget* parent = nullptr);

signals:
    void conditionChosen(uint condition);
    void runOpened(qlonglong run);
    void runChosen(qlonglong run);

private:
    QWidget* chooser();
    QWidget* summaryBox(const psychophysics::ApexSummary& summary, const QString& title, int repeated);
    QWidget* plots(const psychophysics::ApexSummary& summary, const std::vector<QString>& names);
    void addWarnings(QVBoxLayout& column, const psychophysics::ApexSummary& summary) const;
    QWidget* tableBox();
    QString error(double mm, double percent) const;
    QString spread(const psychophysics::ApexAxis& axis) const;

    AppContext& m_app;
    const StudyFacts& m_facts;
    std::size_t m_condition;
};

} // namespace chiron::desktop
