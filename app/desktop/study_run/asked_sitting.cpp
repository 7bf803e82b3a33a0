// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/asked_sitting.h"

#include "desktop/studies/study_jobs.h"

#include <QCoreApplication>
#include <memory>

namespace chiron::desktop {

namespace {

core::Result<database::StudyNumber> askedStudy(database::StudyReader& reader, const QString& study) {
    bool number = false;
    const qlonglong given = study.toLongLong(&number);
    const auto found = number ? reader.study(given) : reader.studyByKey(study.toStdString());
    CHIRON_TRY(found);
    return found->summary.id;
}

void openAsked(AppContext& context, const AskedSitting& asked) {
    readStudies(
        context, &context,
        [study = asked.study](database::StudyReader& reader) { return askedStudy(reader, study); },
        [&context, asked](const core::Result<database::StudyNumber>& study) {
            if (!study) {
                context.messages().error(
                    QCoreApplication::translate("AskedSitting", "The study %1 could not be opened.")
                        .arg(asked.study),
                    study.error(), Tried::reading);
                return;
            }
            context.navigator().go(QStringLiteral("study_trials"),
                                   {{QStringLiteral("study"), qlonglong(*study)},
                                    {QStringLiteral("participant"), asked.person},
                                    {QStringLiteral("condition"), QString()}});
        });
}

} // namespace

void followAskedSitting(AppContext& context, const AskedSitting& asked) {
    auto once = std::make_shared<QMetaObject::Connection>();
    *once = QObject::connect(
        &context, &AppContext::actorChanged, &context,
        [&context, asked, once] {
            if (!context.loggedIn())
                return;
            QObject::disconnect(*once);
            openAsked(context, asked);
        },
        Qt::QueuedConnection); // after the home screen has been shown
}

} // namespace chiron::desktop
