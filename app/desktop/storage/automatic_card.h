// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"
#include "desktop/theme/theme.h"

#include <QFrame>
#include <QLocale>

class QCheckBox;
class QSpinBox;
class QVBoxLayout;

namespace chiron::desktop {

/// Settings and state of the automatic backups: whether they are on, how many are kept, how the latest one
/// went, and what is wrong with the folder.
/// Thread: GUI.
class AutomaticCard final : public QFrame {
    Q_OBJECT
public:
    explicit AutomaticCard(const Theme& theme, QWidget* parent = nullptr);

    void present(const database::BackupStanding& standing, bool onTheSitesDisk, const QLocale& locale);

signals:
    void planChosen(const chiron::database::BackupPlan& plan); ///< by the person, not by present()

private:
    void choose();

    const Theme& m_theme;
    database::BackupPlan m_plan;
    QVBoxLayout* m_notices;
    QCheckBox* m_on;
    QSpinBox* m_keep;
};

} // namespace chiron::desktop
