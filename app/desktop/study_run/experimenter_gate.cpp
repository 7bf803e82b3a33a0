// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/experimenter_gate.h"

#include "database/accounts/account_service.h"
#include "desktop/accounts/account_words.h"
#include "desktop/accounts/field_note.h"
#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

ExperimenterGate::ExperimenterGate(AppContext& context, const QString& words, QWidget* parent)
    : FormDialog(context, QStringLiteral("gate"), tr("For the experimenter"), parent) {
    column()->addWidget(kit::label(theme(), words, TextStyle::body));
    m_password = form::passwordField(theme(), column(), tr("Password of %1").arg(context.shownName()),
                                     QStringLiteral("gate.password"));
    m_note = new FieldNote(theme(), *column(), *m_password);
    setAccept(tr("Continue"));
    connect(m_password, &QLineEdit::textChanged, this,
            [this] { setAcceptable(!m_password->text().isEmpty()); });
    m_password->setFocus();
}

void ExperimenterGate::submit() {
    setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), password = m_password->text().toStdString()](WorkToken&) {
            return database::AccountService(*database).tryConfirm(actor, password);
        },
        [this](const tl::expected<database::Actor, database::Refusal>& actor) {
            setWorking(false);
            m_password->clear();
            if (!actor) {
                if (actor.error().kind == database::Refusal::Kind::wrong)
                    m_note->say(wrongPasswordWords());
                else
                    say("warning", refusalWords(actor.error()));
                m_password->setFocus();
                return;
            }
            accept();
            emit opened();
        });
}

} // namespace chiron::desktop
