// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/results/results_place.h"

#include "desktop/frame/app_context.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

struct ResultsWords {
    Q_DECLARE_TR_FUNCTIONS(Results)
};

} // namespace

bool hasResults(const database::SessionSummary& session) {
    return session.person != database::Actor::kSimulatedPerson && !session.ofStudy;
}

Place resultsPlace(const database::SessionSummary& session, const QString& name) {
    return {QStringLiteral("results"),
            {{QStringLiteral("person"), static_cast<qint64>(session.person)},
             {QStringLiteral("name"), name.isEmpty() ? QString::fromStdString(session.personName) : name},
             {QStringLiteral("exercise"), QString::fromStdString(session.exercise)},
             {QStringLiteral("level"), session.level}}};
}

QString resultsCommand(const AppContext& context, const database::SessionSummary& session) {
    if (!hasResults(session))
        return {};
    if (session.person == context.actor().personId())
        return ResultsWords::tr("My results");
    using enum database::Role;
    const bool may = context.has(trainer) || context.has(researcher) || context.has(admin);
    return may ? ResultsWords::tr("Results of %1").arg(QString::fromStdString(session.personName))
               : QString();
}

} // namespace chiron::desktop
