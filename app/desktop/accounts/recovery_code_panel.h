// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QCheckBox;
class QPushButton;

namespace chiron::desktop {

/// Shows the recovery code, which cannot be shown again later. It offers to copy and print the code and asks
/// the person to tick that it is written down.
/// Thread: GUI.
class RecoveryCodePanel : public QWidget {
    Q_OBJECT
public:
    /// Which recovery code of this person the existing backups contain. The panel mentions it, because
    /// restoring a backup brings that state back.
    enum class Backups { none, haveNoCode, haveEarlierCode };
    RecoveryCodePanel(const Theme& theme, const QString& loginName, const QString& code, Backups backups,
                      QWidget* parent = nullptr);
    /// The tick and the button that go on, for a PageFooter. They stand at the end of the panel until
    /// somebody takes them.
    QWidget* foot() const { return m_foot; }
    bool isConfirmed() const;
    /// The text of the printed sheet.
    QString printedText() const;

signals:
    void finished(); ///< the person ticked the box and went on

private:
    void print();

    const Theme& m_theme;
    QString m_name;
    QString m_code;
    QWidget* m_foot;
    QCheckBox* m_written;
    QPushButton* m_next;
};

} // namespace chiron::desktop
