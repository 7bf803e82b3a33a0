// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// All participants at one condition: each one's Weber fraction with its interval, and what they share. GUI thread; the facts outlive it.
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
    void addAgreement(QVBoxLayout& layout) const; ///< of rankings
    QWidget* plotBox();
    QWidget* tableBox();
    void addGroupWords(QVBoxLayout& layout) const; ///< who is in the group's value and who is not
    std::vector<const RunFacts*> runs() const;

    AppContext& m_app;
    const StudyFacts& m_facts;
    std::size_t m_condition;
};

} // namespace chiron::desktop
