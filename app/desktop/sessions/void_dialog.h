// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QDialog>

class QPlainTextEdit;
class QPushButton;

namespace chiron::desktop {

/// Asks for the reason for which a session is voided, and says what that does: from the list of sessions and from playback.
/// Accepted only with a reason.
class VoidSessionDialog final : public QDialog {
    Q_OBJECT
public:
    /// `what`: exercise, level, time and result, so that nobody voids the wrong one.
    VoidSessionDialog(const Theme& theme, qint64 session, const QString& person, const QString& what, QWidget* parent);
    QString reason() const;

private:
    QPlainTextEdit* m_reason;
    QPushButton* m_confirm;
};

} // namespace chiron::desktop
