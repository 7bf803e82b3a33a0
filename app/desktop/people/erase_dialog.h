// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/people/erasure_dialog.h"

class QCheckBox;

namespace chiron::desktop {

/// Erases a person permanently. It says what is erased and what stays, and also requires the person's login
/// name to be typed.
/// Thread: GUI.
class EraseDialog final : public ErasureDialog {
    Q_OBJECT
public:
    EraseDialog(AppContext& context, database::Person person, QWidget* parent);

private:
    bool isChosen() const override;
    QString whom() const override { return QString::fromStdString(m_person.name); }
    Erasure erasure() const override;
    QString doneWords() const override;
    QString cannotWords() const override;

    database::Person m_person;
    QCheckBox* m_withdraw;
    QLineEdit* m_typedName;
};

} // namespace chiron::desktop
