// SPDX-License-Identifier: GPL-3.0-or-later
// A blinded study as its author sees it and as somebody sees it who may not know: codes instead of conditions, on every page, and runs all the same.
#include "desktop/studies/study_screen.h"
#include "desktop/study_run/trials_screen.h"
#include "support/every_place.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

using namespace chiron;

class TestMaskedStudy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase() { m_site.reset(); }
    void theAuthorSeesTheDesign();
    void othersSeeCodes();
    void othersRunIt();

private:
    /// Everything that can be read on the screen.
    QString told() const {
        QStringList all;
        const QWidget* screen = m_site->window->screen();
        for (const auto* label : screen->findChildren<QLabel*>())
            all << label->text();
        for (const auto* button : screen->findChildren<QAbstractButton*>())
            all << button->text();
        for (const auto* field : screen->findChildren<QLineEdit*>()) // of spin boxes, too
            all << field->text();
        for (const auto* field : screen->findChildren<QComboBox*>())
            all << field->currentText();
        for (const auto* table : screen->findChildren<QTableWidget*>())
            for (int i = 0; i < table->rowCount() * table->columnCount(); ++i)
                all << (table->item(i / table->columnCount(), i % table->columnCount()) ? table->item(i / table->columnCount(), i % table->columnCount())->text() : QString());
        return all.join(QLatin1Char('\n'));
    }
    void show(const char* screen, int tab) {
        m_site->go(QLatin1String(screen), {{QStringLiteral("study"), qlonglong(m_study)}, {QStringLiteral("tab"), tab}, {QStringLiteral("participant"), m_code}});
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), 30000);
    }
    std::unique_ptr<tests::DesktopFixture> m_site;
    database::StudyNumber m_study = 0;
    QString m_code;
};

void TestMaskedStudy::initTestCase() {
    m_site = std::make_unique<tests::DesktopFixture>();
    const auto ada = m_site->actor("ada");
    QVERIFY(database::AccountService(m_site->database()).createPerson(ada, {"rob", "Rob Runner", {database::Role::researcher}, tests::kTestPassword, false}));
    m_study = tests::addVisitedStudies(*m_site).blind;
    const auto rhea = m_site->actor("rhea");
    m_code = QString::fromStdString(tests::addParticipant(*m_site, rhea, m_study, tests::smallStudy("jnd_blind", true), "resident 2").code);
}

void TestMaskedStudy::theAuthorSeesTheDesign() {
    m_site->logIn("rhea");
    show("study", desktop::StudyScreen::conditionsTab);
    QVERIFY(told().contains(QStringLiteral("Stiffness of a tube")));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("study.export")));
}

void TestMaskedStudy::othersSeeCodes() {
    m_site->logIn("rob");
    for (int tab = 0; tab < desktop::StudyScreen::tabs; ++tab) {
        show("study", tab);
        for (const char* condition : {"Stiffness of a tube", "Mass of an object", "300", "N/m", " kg"})
            QVERIFY2(!told().contains(QLatin1String(condition)), qPrintable(QStringLiteral("%1: %2").arg(tab).arg(told())));
    }
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("study.export"))); // no file of a design that nobody froze
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("preview.start")));
    show("study", desktop::StudyScreen::conditionsTab);
    auto connection = m_site->database().openReader();
    QStringList codes;
    const auto sealed = database::StudyReader(**connection, m_site->context.actor()).conditionCodes(m_study);
    QVERIFY(sealed);
    for (const database::SealedCondition& each : *sealed)
        codes << QString::fromStdString(each.sealedCode);
    QCOMPARE(m_site->find<QLabel>(QStringLiteral("conditions.codes"))->text(), codes.join(QStringLiteral(" · ")));
    const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES");
    if (!folder.isEmpty())
        m_site->window->grab().save(folder + QStringLiteral("/masked_conditions.png"));
    show("study_data", 0);
    QVERIFY2(!told().contains(QStringLiteral("Stiffness of")), qPrintable(told()));
}

void TestMaskedStudy::othersRunIt() {
    show("study_run", 0);
    m_site->find<QPushButton>(QStringLiteral("run.begin"))->click();
    auto* screen = m_site->screen<desktop::TrialsScreen>();
    QVERIFY(screen);
    QVERIFY(screen->live()); // rendered by its own condition, which the list does not tell
    QVERIFY(!told().contains(QStringLiteral("Stiffness of")) && !told().contains(QStringLiteral("Mass of")));
}

QTEST_MAIN(TestMaskedStudy)
#include "test_masked_study.moc"
