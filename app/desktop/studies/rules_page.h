// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QWidget>

namespace chiron::desktop {

/// Tells how many trials each condition has, and edits the rules of a trial, breaks, instructions, order,
/// blinding, and the limits beyond which a trial is repeated. Thread: GUI.
class RulesPage final : public QWidget {
    Q_OBJECT
public:
    explicit RulesPage(const DesignPage& page, QWidget* parent = nullptr);

signals:
    /// Somebody wants to change the number of trials of a condition: the field of ConditionsPage that sets
    /// it.
    void lengthAsked(int condition, const QString& field);

private:
    QWidget* lengthBox(const DesignPage& page);
    QWidget* rulesBox(const DesignPage& page);
    QWidget* instructionsBox(const DesignPage& page);
    QWidget* orderBox(const DesignPage& page);
    QWidget* fidelityBox(const DesignPage& page);
};

} // namespace chiron::desktop
