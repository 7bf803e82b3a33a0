// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// Compares the conditions of a study in pairs. For pairs that cannot be compared it says what is missing.
/// Thread: GUI; the facts outlive it.
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
