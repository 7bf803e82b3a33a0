// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QDialog>

class QPlainTextEdit;
class QPushButton;

namespace chiron::desktop {

/// Asks for the reason to void a session, or to count a voided one again, and explains the consequences. The
/// session list and playback use it. It cannot be accepted without a reason.
class VoidSessionDialog final : public QDialog {
    Q_OBJECT
public:
    enum class Decision { voidIt, countAgain };

    /// `what`: exercise, level, time and result, so that nobody voids the wrong session.
    VoidSessionDialog(const Theme& theme, qint64 session, const QString& person, const QString& what,
                      QWidget* parent, Decision decision = Decision::voidIt);
    QString reason() const;

private:
    QPlainTextEdit* m_reason;
    QPushButton* m_confirm;
};

} // namespace chiron::desktop
