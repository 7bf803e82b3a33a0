// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"

class QLineEdit;

namespace chiron::desktop {

class FieldNote;

/// Asks for the password of the logged-in person, so that only the experimenter can continue.
/// Thread: GUI.
class ExperimenterGate final : public FormDialog {
    Q_OBJECT
public:
    /// `words`: what the session does meanwhile, and what the password is for.
    ExperimenterGate(AppContext& context, const QString& words, QWidget* parent);

signals:
    void opened();

protected:
    void submit() override;

private:
    QLineEdit* m_password = nullptr;
    FieldNote* m_note = nullptr;
};

} // namespace chiron::desktop
