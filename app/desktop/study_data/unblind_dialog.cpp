// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/unblind_dialog.h"

#include "desktop/studies/study_jobs.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

namespace {
constexpr int kLongestReason = 500;
} // namespace

UnblindDialog::UnblindDialog(AppContext& context, database::StudyNumber study, int toCome, QWidget* parent)
    : FormDialog(context, QStringLiteral("data.ask_unblind"), tr("Unblind this study?"), parent),
      m_study(study) {
    column()->addWidget(kit::label(
        theme(), tr("Everybody will then see the names of the conditions. It is recorded who unblinded the "
                    "study, when and why. This cannot be undone.")));
    if (toCome > 0) {
        auto* coming = kit::notice(
            theme(), "warning",
            tr("%n participant(s) are still to come. Whoever conducts their runs will no longer be blind.",
               nullptr, toCome));
        coming->setObjectName(QStringLiteral("data.ask_unblind.to_come"));
        column()->addWidget(coming);
    }
    auto* label = kit::label(theme(), tr("Reason for unblinding"), TextStyle::label);
    column()->addWidget(label);
    m_reason = new QLineEdit;
    m_reason->setObjectName(QStringLiteral("data.ask_unblind.reason"));
    m_reason->setAccessibleName(tr("Reason for unblinding"));
    m_reason->setFont(theme().font(TextStyle::body));
    m_reason->setMaxLength(kLongestReason);
    label->setBuddy(m_reason);
    column()->addWidget(m_reason);
    column()->addWidget(kit::label(theme(), tr("Do not name anyone: the reason is stored permanently."),
                                   TextStyle::small, "muted"));
    setAccept(tr("Unblind"), "danger");
    setAcceptable(false);
    connect(m_reason, &QLineEdit::textChanged, this,
            [this](const QString& text) { setAcceptable(!text.trimmed().isEmpty()); });
    m_reason->setFocus();
}

void UnblindDialog::submit() {
    setWorking(true);
    writeStudies(
        context(), this,
        [study = m_study, why = m_reason->text().trimmed().toStdString()](
            database::StudyRepository& studies) { return studies.unblindStudy(study, why); },
        [this](const core::Result<void>& done) {
            setWorking(false);
            if (!done) {
                say("bad", tr("The study was not unblinded.\n%1").arg(inWords(done.error())));
                return;
            }
            emit changed();
            accept();
        });
}

} // namespace chiron::desktop
