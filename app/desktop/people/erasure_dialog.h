// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/account_service.h"
#include "desktop/people/form_dialog.h"

#include <functional>

class QLineEdit;

namespace chiron::desktop {

class FieldNote;
class WaitCountdown;

/// What erasing somebody always asks for: a reason, which is kept, and the administrator's own password. Where an erasure stopped half-way it
/// can be sent again and goes on. GUI thread.
class ErasureDialog : public FormDialog {
    Q_OBJECT
protected:
    using Erasure = std::function<core::Result<void>(database::AccountService&, const database::Actor&, const std::string& password, const std::string& reason)>;

    ErasureDialog(AppContext& context, const QString& objectName, const QString& title, QWidget* parent);
    QLineEdit* addReason();
    void addPassword(); ///< and the button; last
    void renew();

    virtual bool isChosen() const = 0;        ///< it is certain who is meant
    virtual QString whom() const = 0;
    virtual Erasure erasure() const = 0;      ///< runs on a worker
    virtual QString doneWords() const = 0;
    virtual QString cannotWords() const = 0;  ///< the data layer says that it is not the time

    void submit() override;

private:
    void refused(const database::Refusal& refusal);
    void finished(const core::Result<void>& done);

    QLineEdit* m_reason = nullptr;
    QLineEdit* m_password = nullptr;
    FieldNote* m_passwordNote = nullptr;
    WaitCountdown* m_wait;
};

} // namespace chiron::desktop
