// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// Shows all participants at one condition: each one's Weber fraction with its interval, and the group's
/// estimate.
/// Thread: GUI; the facts outlive it.
class GroupPage final : public QWidget {
    Q_OBJECT
public:
    GroupPage(AppContext& app, const StudyFacts& facts, std::size_t condition, QWidget* parent = nullptr);

signals:
    void conditionChosen(uint condition);
    void runOpened(qlonglong run);
    void comparisonAsked();

private:
    QWidget* chooser();
    QWidget* groupBox();
    QStringList weberWords(const psychophysics::GroupEstimate& group) const;
    void addAgreement(QVBoxLayout& layout) const; ///< of the participants' rankings
    QWidget* plotBox();
    QWidget* tableBox();
    /// Says who is included in the group's value and who is not.
    void addGroupWords(QVBoxLayout& layout) const;
    std::vector<const RunFacts*> runs() const;

    AppContext& m_app;
    const StudyFacts& m_facts;
    std::size_t m_condition;
};

} // namespace chiron::desktop
