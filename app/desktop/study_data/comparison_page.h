// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// The conditions of a study, two by two; and of each two that are not compared what is missing. GUI thread; the facts outlive it.
class ComparisonPage final : public QWidget {
    Q_OBJECT
public:
    ComparisonPage(AppContext& app, const StudyFacts& facts, QWidget* parent = nullptr);

private:
    void fill(QVBoxLayout& layout);
    QWidget* table();
    QString name(std::size_t condition) const;

    AppContext& m_app;
    const StudyFacts& m_facts;
};

} // namespace chiron::desktop
