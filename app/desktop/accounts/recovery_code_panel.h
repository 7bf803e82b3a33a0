// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QCheckBox;
class QPushButton;

namespace chiron::desktop {

/// The recovery code, shown once: copy, print, and a tick that it is written down before it goes for ever. GUI thread.
class RecoveryCodePanel : public QWidget {
    Q_OBJECT
public:
    /// What the backups made so far have of this person; said, because a restore brings it back.
    enum class Backups { none, haveNoCode, haveEarlierCode };
    RecoveryCodePanel(const Theme& theme, const QString& loginName, const QString& code, Backups backups, QWidget* parent = nullptr);
    bool isConfirmed() const;

signals:
    void finished(); ///< after the tick

private:
    void print();

    const Theme& m_theme;
    QString m_name;
    QString m_code;
    QCheckBox* m_written;
    QPushButton* m_next;
};

} // namespace chiron::desktop
