// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QDialog>

class QPlainTextEdit;

namespace chiron::desktop {

/// Asks for the reason before a session is declared void, and says what stays. Nothing is sent without a reason. GUI thread.
class VoidDialog : public QDialog {
    Q_OBJECT
public:
    explicit VoidDialog(const Theme& theme, QWidget* parent = nullptr);
    QString reason() const;

private:
    QPlainTextEdit* m_reason;
};

} // namespace chiron::desktop
