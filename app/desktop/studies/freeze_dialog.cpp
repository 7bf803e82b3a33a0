// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/freeze_dialog.h"

#include "desktop/studies/study_store.h"
#include "desktop/widgets/kit.h"

namespace chiron::desktop {

namespace {

/// In groups of eight, so that it can be broken and compared.
QString grouped(const std::string& sha256) {
    QStringList groups;
    for (std::size_t i = 0; i < sha256.size(); i += 8)
        groups << QString::fromStdString(sha256.substr(i, 8));
    return groups.join(QLatin1Char(' '));
}

} // namespace

FreezeDialog::FreezeDialog(AppContext& context, const database::StudySummary& study, const psychophysics::StudyDesign& design, QWidget* parent)
    : FormDialog(context, QStringLiteral("freeze"), tr("Freeze %1").arg(QString::fromStdString(study.title)), parent), m_study(study.id) {
    column()->addWidget(kit::label(theme(), tr("From now on nobody can change the design. Participants can be enrolled, each condition "
                                               "gets a sealed code, and every export carries this SHA-256 of the design:")));
    auto* sha = kit::label(theme(), grouped(catalogue::studySha256(catalogue::studyJson(design))), TextStyle::mono);
    sha->setObjectName(QStringLiteral("freeze.sha256"));
    sha->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const kit::Box box = kit::box(theme(), "raised");
    box.layout->addWidget(sha);
    column()->addWidget(box.frame);
    column()->addWidget(kit::label(theme(), tr("%n condition(s)", nullptr, static_cast<int>(design.conditions.size())) + QStringLiteral(", ") +
                                                tr("%n participant(s) planned", nullptr, design.participantsPlanned),
                                   TextStyle::body, "muted"));
    column()->addWidget(kit::notice(theme(), "warning", tr("This cannot be undone. To change the study later, copy it into a new one.")));
    setAccept(tr("Freeze the design"));
    setAcceptable(true);
    cancelAtEnter();
}

void FreezeDialog::submit() {
    setWorking(true);
    writeStudies(
        context(), this, [study = m_study](database::StudyRepository& studies) { return studies.freezeStudy(study); },
        [this](const core::Result<std::string>& sha) {
            setWorking(false);
            if (!sha) {
                say("bad", tr("The study could not be frozen.\n%1").arg(inWords(sha.error())));
                return;
            }
            context().messages().done(tr("Frozen. Participants can be enrolled now."));
            emit frozen();
            accept();
        });
}

} // namespace chiron::desktop
