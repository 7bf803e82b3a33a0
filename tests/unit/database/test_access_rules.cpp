// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/access_table.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QtTest>
#include <set>

using namespace chiron::database;

/// The access table by itself: complete, and as data.md and cli.md want it.
class TestAccessRules : public QObject {
    Q_OBJECT
private slots:
    void everyPublicFunctionIsListed();
    void whatMattersMostIsSpeltOut();
    void rolesAdd();
};

void TestAccessRules::everyPublicFunctionIsListed() {
    std::set<QString> listed;
#define LISTED(class_, function) listed.insert(QStringLiteral(#class_ "::" #function));
    CHIRON_REPOSITORY_FUNCTIONS(LISTED)
#undef LISTED
    std::set<QString> found;
    const QDir root(QStringLiteral(CHIRON_SOURCE_DIR "/database"));
    QStringList headers;
    for (const QString& folder : {QStringLiteral("repositories"), QStringLiteral("upkeep")}) {
        for (const QString& name : QDir(root.filePath(folder)).entryList({QStringLiteral("*.h")})) {
            headers.append(root.filePath(folder + "/" + name));
        }
    }
    static const QRegularExpression classText(QStringLiteral("\nclass (\\w+) \\{(.*?)\n\\};"),
                                              QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression hidden(QStringLiteral("\n(private|protected):.*?(?=\npublic:|$)"),
                                           QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression function(QStringLiteral("core::Result<[^;()]*>\\s+(\\w+)\\("));
    for (const QString& header : headers) {
        QFile file(header);
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto classes = classText.globalMatch(QString::fromUtf8(file.readAll()));
        while (classes.hasNext()) {
            const auto inClass = classes.next();
            auto functions = function.globalMatch(inClass.captured(2).remove(hidden));
            while (functions.hasNext()) {
                found.insert(inClass.captured(1) + "::" + functions.next().captured(1));
            }
        }
    }
    QCOMPARE(found, listed);
}

void TestAccessRules::whatMattersMostIsSpeltOut() {
    // Not read from the table: the rules as data.md and cli.md state them.
    using K = ActorKind;
    for (const Role role : {Role::trainee, Role::trainer, Role::researcher}) {
        for (const Action action :
             {Action::createPerson, Action::importPeople, Action::setRoles, Action::setEnabled,
              Action::resetPassword, Action::erasePerson, Action::changeNames, Action::backup,
              Action::setBackupPlan, Action::dailyBackup, Action::restore, Action::exportSite,
              Action::listAudit}) {
            QCOMPARE(scopeOf(action, K::person, {role}), Scope::none);
        }
    }
    // Which code is which condition: the study's author and administrators alone.
    QCOMPARE(scopeOf(Action::sealedConditions, K::person, {Role::researcher}), Scope::own);
    QCOMPARE(scopeOf(Action::sealedConditions, K::person, {Role::trainer}), Scope::none);
    QCOMPARE(scopeOf(Action::sealedConditions, K::anonymous, {}), Scope::none);
    QCOMPARE(scopeOf(Action::session, K::person, {Role::trainee}), Scope::ownAndSimulated);
    QCOMPARE(scopeOf(Action::listPeople, K::person, {Role::trainee}), Scope::none);
    for (const Action action : {Action::voidSession, Action::reinstateSession}) {
        QCOMPARE(scopeOf(action, K::person, {Role::trainee}), Scope::none);
        QCOMPARE(scopeOf(action, K::person, {Role::researcher}), Scope::none);
        QCOMPARE(scopeOf(action, K::person, {Role::trainer}), Scope::all);
    }
    QCOMPARE(scopeOf(Action::session, K::anonymous, {}), Scope::simulated);
    QCOMPARE(scopeOf(Action::beginSession, K::anonymous, {}), Scope::none);
    QCOMPARE(scopeOf(Action::beginSession, K::simulated, {}), Scope::own);
    QCOMPARE(scopeOf(Action::session, K::simulated, {}), Scope::simulated);
    QCOMPARE(scopeOf(Action::listPeople, K::simulated, {}), Scope::none);
    // Nobody stores a result for somebody else, but maintenance after a crash.
    for (const Action action :
         {Action::beginSession, Action::storeTrial, Action::storeScores, Action::finishSession}) {
        for (const Role role : kAllRoles) {
            QCOMPARE(scopeOf(action, K::person, {role}), Scope::own);
        }
    }
}

void TestAccessRules::rolesAdd() {
    QCOMPARE(scopeOf(Action::session, ActorKind::person, {Role::trainee, Role::trainer}), Scope::all);
    QCOMPARE(scopeOf(Action::createPerson, ActorKind::person, {Role::trainee, Role::admin}), Scope::all);
    QCOMPARE(scopeOf(Action::exportPerson, ActorKind::person, {Role::trainee, Role::researcher}), Scope::own);
    QCOMPARE(scopeOf(Action::session, ActorKind::person, {}), Scope::none);
}

QTEST_GUILESS_MAIN(TestAccessRules)
#include "test_access_rules.moc"
