// SPDX-License-Identifier: GPL-3.0-or-later
// A study from its draft to its data, as a researcher does it.
#include "catalogue/instrument_catalogue.h"
#include "database/repositories/privacy_repository.h"
#include "desktop/studies/studies_screen.h"
#include "desktop/studies/study_device.h"
#include "desktop/studies/study_screen.h"
#include "desktop/study_data/person_page.h"
#include "desktop/study_data/ranking_box.h"
#include "desktop/study_data/study_data_screen.h"
#include "desktop/widgets/state_panel.h"
#include "support/every_place.h"
#include "support/languages.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSlider>
#include <QTabBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <algorithm>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;

class TestStudyScreens : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_site = std::make_unique<DesktopFixture>();
        m_site->logIn("rhea");
    }
    void cleanupTestCase() { m_site.reset(); }
    void emptyStates();
    void intervalsOfRankingsRise();
    void draftFromPlain();
    void changedUndoneAndKept();
    void faultsAreSaid();
    void frozen();
    void enrolledAndConsented();
    void theNewOneIsSelected();
    void anAccountIsNamed();
    void fieldsAreWrittenDownAtTheEnrolment();
    void askedAfterEachCondition();
    void runsInOrder();
    void questionnaire();
    void dataAndUnblinding();
    void aRunWithoutAValueShowsNone();
    void everyWayOutOfAnExportIsTold();
    void theTableOfTrialsFits();
    void whatGroupsIncludeIsRemembered();
    void theNextParticipantIsEnrolledWhereTheyAreRun();
    void whoWaitsComesBeforeTheNext();
    void whoHasOnlyQuestionsLeftIsAskedThem();
    void nobodyIsSentBackAndForth();
    void whoeverComesNextIsSaidAndSelected();
    void withdrawingSaysWhatIsKeptAndWhatCounts();
    void archivedWithUndo();

private:
    void keepPicture(const QString& name);
    void whoIsInTheGroup(const QString& waiting);
    void go(const char* screen, const QVariantMap& parameters = {}) {
        m_site->go(QLatin1String(screen), parameters);
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    }
    QVariantMap study() const { return {{QStringLiteral("study"), qlonglong(m_study)}}; }
    void click(const char* name) {
        auto* button = m_site->find<QPushButton>(QLatin1String(name));
        QVERIFY2(button, name);
        QVERIFY2(button->isEnabled(), name);
        button->click();
    }
    QString text(const char* name) {
        auto* label = m_site->find<QLabel>(QLatin1String(name));
        return label ? label->text() : QString();
    }
    std::unique_ptr<DesktopFixture> m_site;
    database::StudyNumber m_study = 0, m_data = 0;
    QString m_code;
};

/// Of a person and of a group: the lower limit of an interval stands before the higher one.
void TestStudyScreens::intervalsOfRankingsRise() {
    const std::vector<psychophysics::SaidRanks> said{{1, 2, 3}, {1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {1, 2, 3},
                                                     {1, 2, 3}, {3, 1, 2}, {1, 2, 3}, {2, 3, 1}, {1, 2, 3}};
    const QRegularExpression limits(QStringLiteral("95 %: (\\S+)(?: %)? … (\\S+)"));
    int intervals = 0;
    for (const auto of : {desktop::RankingBox::Of::person, desktop::RankingBox::Of::group}) {
        const desktop::RankingBox box(
            m_site->context,
            of == desktop::RankingBox::Of::person
                ? psychophysics::summariseRankings(said)
                : psychophysics::summariseGroupRankings({{said.begin(), said.begin() + 2},
                                                         {said.begin() + 2, said.begin() + 5},
                                                         {said.begin() + 5, said.begin() + 7},
                                                         {said.begin() + 7, said.end()}}),
            of);
        for (const QLabel* label : box.findChildren<QLabel*>()) {
            const auto found = limits.match(label->text());
            if (!found.hasMatch())
                continue;
            ++intervals;
            const auto value = [](QString text) {
                return text.replace(QChar(0x2212), QLatin1Char('-')).toDouble();
            };
            QVERIFY2(value(found.captured(1)) < value(found.captured(2)), qPrintable(label->text()));
        }
    }
    QVERIFY2(intervals >= 3, qPrintable(QString::number(intervals)));
}

void TestStudyScreens::emptyStates() {
    for (const char* screen : {"studies", "study_run", "study_data"}) {
        go(screen);
        auto* panel = m_site->window->screen()->findChild<desktop::StatePanel*>();
        QTRY_COMPARE_WITH_TIMEOUT(panel->state(), desktop::StatePanel::State::empty, kPatience_ms);
    }
    go("study", {{QStringLiteral("study"), 4711}});
    QTRY_COMPARE_WITH_TIMEOUT(m_site->window->screen()->findChild<desktop::StatePanel*>()->state(),
                              desktop::StatePanel::State::error, kPatience_ms);
}

void TestStudyScreens::draftFromPlain() {
    go("studies");
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("new_study.template.new_rank3")),
                             kPatience_ms);
    click("new_study.template.new_rank3");
    m_site->find<QLineEdit>(QStringLiteral("new_study.key"))->setText(QStringLiteral("first_study"));
    QMetaObject::invokeMethod(m_site->find<QLineEdit>(QStringLiteral("new_study.key")), "textEdited",
                              Q_ARG(QString, QStringLiteral("first_study")));
    click("new_study.accept");
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study"),
                              kPatience_ms);
    m_study = m_site->context.navigator().current().parameters.value(QStringLiteral("study")).toLongLong();
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("design.title")), kPatience_ms);
}

void TestStudyScreens::changedUndoneAndKept() {
    auto* screen = m_site->screen<desktop::StudyScreen>();
    QVERIFY(screen);
    auto* title = m_site->find<QLineEdit>(QStringLiteral("design.title"));
    title->selectAll();
    QTest::keyClicks(title, QStringLiteral("Feeling tubes"));
    QCOMPARE(screen->draft().design().title.at("en"), std::string("Feeling tubes"));
    click("study.undo");
    QTRY_COMPARE_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("design.title"))->text(),
                              QStringLiteral("New study"), kPatience_ms);
    click("study.redo");
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(QStringLiteral("all changes saved")), kPatience_ms);
    auto connection = m_site->database().openReader();
    const auto stored = database::StudyReader(**connection, m_site->context.actor()).study(m_study);
    QVERIFY(stored && stored->summary.title == "Feeling tubes");
}

void TestStudyScreens::faultsAreSaid() {
    auto* screen = m_site->screen<desktop::StudyScreen>();
    screen->draft().change({}, {}, [](psychophysics::StudyDesign& design) {
        design.conditions.front().stimulus.reference = -1.0;
    });
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(QStringLiteral("not saved")), kPatience_ms);
    const auto* freeze = m_site->find<QPushButton>(QStringLiteral("study.freeze"));
    QVERIFY(!freeze->isEnabled() && !freeze->toolTip().isEmpty());
    click("study.undo");
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(QStringLiteral("all changes saved")), kPatience_ms);
    screen->draft().change(
        {}, {},
        [](psychophysics::StudyDesign& design) { // small enough for the rest
            design.questionnaires = tests::smallStudy("x").questionnaires;
            design.blindExperimenter = true;
            design.objective["en"] = "Whether tubes can be told apart."; // else nobody freezes it
            design.ethics = "Not needed: a test.";
        },
        true);
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(QStringLiteral("all changes saved")), kPatience_ms);
    for (int tab = 0; tab < desktop::StudyScreen::tabs; ++tab) { // each page can be built
        screen->showTab(tab);
        QTest::qWait(30);
    }
}

void TestStudyScreens::frozen() {
    const auto* freeze = m_site->find<QPushButton>(QStringLiteral("study.freeze"));
    QVERIFY(freeze->isEnabled() && freeze->toolTip().isEmpty());
    click("study.freeze"); // what cannot be undone does not happen at Enter
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("freeze")), kPatience_ms);
    QTest::keyClick(m_site->find<QDialog>(QStringLiteral("freeze")), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QPushButton>(QStringLiteral("freeze.accept")), kPatience_ms);
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("study.freeze")));
    click("study.freeze");
    const QString sha = text("freeze.sha256").remove(QLatin1Char(' '));
    QCOMPARE(sha.size(), 64);
    auto* seen = m_site->find<QCheckBox>(QStringLiteral("freeze.seen"));
    QVERIFY(seen && seen->isVisible()); // nobody has tried it
    seen->click();
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("freeze.accept"))->isEnabled(),
                             kPatience_ms); // once simulated observers have done it
    click("freeze.accept");
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(sha.left(12)), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("participants.enrol")), kPatience_ms);
}

void TestStudyScreens::enrolledAndConsented() {
    click("participants.enrol");
    m_site->find<QLineEdit>(QStringLiteral("enrol.identity"))->setText(QStringLiteral("Dr Example"));
    click("enrol.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!text("enrol.code").isEmpty(), kPatience_ms);
    m_code = text("enrol.code");
    click("enrol.cancel");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTableWidget>(QStringLiteral("participants.table")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    click("participants.consent");
    auto* agreed = m_site->find<QCheckBox>(QStringLiteral("consent.agreed"));
    QVERIFY(agreed && !m_site->find<QPushButton>(QStringLiteral("consent.accept"))->isEnabled());
    agreed->click();
    click("consent.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("participants.run")) &&
                                 m_site->find<QPushButton>(QStringLiteral("participants.run"))->isEnabled(),
                             kPatience_ms);
    const auto* table = m_site->find<QTableWidget>(QStringLiteral("participants.table"));
    QCOMPARE(table->item(0, 0)->text(), m_code);
    const QTableWidgetItem* row = table->horizontalHeaderItem(3); // of the design, not of the list
    QCOMPARE(row->text(), QStringLiteral("Design row"));
    QVERIFY2(row->toolTip().contains(QStringLiteral("Williams design")), qPrintable(row->toolTip()));
}

/// Whoever was enrolled last is selected, and stays so when the list is read anew: Run acts on them.
void TestStudyScreens::theNewOneIsSelected() {
    const auto selected = [this] {
        const auto* table = m_site->find<QTableWidget>(QStringLiteral("participants.table"));
        return table && table->currentRow() >= 0 ? table->item(table->currentRow(), 0)->text() : QString();
    };
    QCOMPARE(selected(), m_code);
    click("participants.enrol");
    m_site->find<QLineEdit>(QStringLiteral("enrol.identity"))->setText(QStringLiteral("Dr Second"));
    click("enrol.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!text("enrol.code").isEmpty(), kPatience_ms);
    const QString second = text("enrol.code");
    click("enrol.consent"); // the next step
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QCheckBox>(QStringLiteral("consent.agreed")), kPatience_ms);
    QVERIFY(!text("consent.instructions").isEmpty()); // who agrees says that they have read them
    QVERIFY2(text("consent.instructions").contains(QStringLiteral("free minute")),
             qPrintable(text("consent.instructions"))); // as the screens of the run say
    QVERIFY2(text("consent.force").contains(QStringLiteral("renders no force")) && // mouse and keyboard
                 text("consent.force").contains(QStringLiteral("with more than 4\u00a0N")),
             qPrintable(text("consent.force")));
    const auto* dialog = m_site->find<QDialog>(QStringLiteral("consent"));
    QVERIFY(dialog && dialog->width() >= m_site->window->width() &&
            dialog->height() >= m_site->window->height()); // what lies behind names conditions
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(selected(), second, kPatience_ms);
    m_site->find<QCheckBox>(QStringLiteral("consent.agreed"))->click();
    click("consent.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("participants.run"))->isEnabled() &&
                                 tests::waitUntilLoaded(*m_site),
                             kPatience_ms);
    QCOMPARE(selected(), second); // read anew: still the same
    click("participants.run");
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("participant")).toString(),
             second);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
}

/// Instead of an identity, or with it: who has an account gets what they do here when they ask for their
/// data.
void TestStudyScreens::anAccountIsNamed() {
    const auto number = tests::addDraft(*m_site, m_site->context.actor(), tests::smallStudy("linked"));
    tests::writeAs(*m_site, m_site->context.actor(),
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    go("study", {{QStringLiteral("study"), qlonglong(number)}, {QStringLiteral("tab"), 5}});
    click("participants.enrol");
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("enrol.accept"))->isEnabled());
    auto* account = m_site->find<QLineEdit>(QStringLiteral("enrol.account"));
    QVERIFY(account);
    account->setText(QStringLiteral("nobody here"));
    click("enrol.accept");
    const auto said = [this] {
        const auto labels = m_site->find<QDialog>(QStringLiteral("enrol"))->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("nobody here"));
        });
    };
    QTRY_VERIFY_WITH_TIMEOUT(said(), kPatience_ms);
    QVERIFY(text("enrol.code").isEmpty());
    account->setText(QStringLiteral("tina"));
    click("enrol.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!text("enrol.code").isEmpty(), kPatience_ms);
    const QString code = text("enrol.code");
    click("enrol.cancel");
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    const database::Actor tina = m_site->actor("tina");
    auto connection = m_site->database().openReader();
    const auto held = database::PrivacyRepository(**connection, tina).exportPerson(tina.personId());
    QVERIFY(held && held->participations.size() == 1);
    QCOMPARE(QString::fromStdString(held->participations.front().participant.code), code);
}

/// On the Run screen what is asked about a condition comes once it is done, and is shown by condition where
/// the data are.
void TestStudyScreens::askedAfterEachCondition() {
    const database::Actor rhea = m_site->context.actor();
    psychophysics::StudyDesign design = tests::smallStudy("each_condition");
    design.questionnaires.front().when = psychophysics::Questionnaire::When::afterCondition;
    const auto number = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    const auto participant = tests::addParticipant(*m_site, rhea, number, design, "somebody");
    const auto open = [&] {
        go("study_run", {{QStringLiteral("study"), qlonglong(number)},
                         {QStringLiteral("participant"), QString::fromStdString(participant.code)}});
    };
    const auto offered = [&] {
        const auto all = m_site->window->screen()->findChildren<QPushButton*>();
        return std::count_if(all.begin(), all.end(), [](const QPushButton* each) {
            return each->objectName().startsWith(QStringLiteral("run.questionnaire.validity."));
        });
    };
    open();
    QCOMPARE(offered(), 0); // nothing was done yet
    tests::addRun(*m_site, rhea, design, participant, "stiffness", 0.1, 5);
    open();
    QCOMPARE(offered(), 1);
    int done = 0; // asked about the condition that was done, by its number
    while (!text(qPrintable(QStringLiteral("run.state.%1").arg(done))).startsWith(QStringLiteral("done")))
        QVERIFY(++done < 2);
    const auto* asks = m_site->find<QPushButton>(QStringLiteral("run.questionnaire.validity.%1").arg(done));
    QVERIFY2(asks && asks->accessibleName().endsWith(QStringLiteral("about condition %1").arg(done + 1)),
             asks ? qPrintable(asks->accessibleName()) : "nothing");
    const auto all = m_site->window->screen()->findChildren<QPushButton*>();
    (*std::find_if(all.begin(), all.end(), [](const QPushButton* each) {
        return each->objectName().startsWith(QStringLiteral("run.questionnaire.validity."));
    }))->click();
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QRadioButton>(QStringLiteral("questionnaire.realism.4")),
                             kPatience_ms);
    m_site->find<QRadioButton>(QStringLiteral("questionnaire.realism.4"))->click();
    m_site->find<QLineEdit>(QStringLiteral("questionnaire.years"))->setText(QStringLiteral("7"));
    m_site->find<QRadioButton>(QStringLiteral("questionnaire.hand.1"))->click();
    click("questionnaire.submit");
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study_run"),
                              kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QCOMPARE(offered(), 0); // answered; of the other condition there is nothing to ask yet
    auto connection = m_site->database().openReader();
    const auto answers = database::StudyReader(**connection, rhea).questionnaireAnswers(number);
    QVERIFY(answers && answers->size() == 3);
    QVERIFY(std::all_of(answers->begin(), answers->end(), [](const database::QuestionnaireAnswer& each) {
        return each.condition == "stiffness" && each.language == "en";
    }));
    go("study_data", {{QStringLiteral("study"), qlonglong(number)},
                      {QStringLiteral("tab"), int(desktop::StudyDataScreen::questionnairesTab)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLabel>(QStringLiteral("summary.validity.stiffness")),
                             kPatience_ms);
    QVERIFY(!m_site->find<QLabel>(QStringLiteral("summary.validity.mass")));
}

/// What the design says is asked for, stored with the participation, and nobody is enrolled without what must
/// be answered.
void TestStudyScreens::fieldsAreWrittenDownAtTheEnrolment() {
    const database::Actor rhea = m_site->context.actor();
    psychophysics::StudyDesign design = tests::smallStudy("fields");
    const auto instruments = catalogue::loadInstruments();
    QVERIFY(instruments);
    for (const catalogue::Instrument& each : *instruments)
        if (each.questionnaire.when == psychophysics::Questionnaire::When::enrolment ||
            each.questionnaire.id == "nasa_tlx")
            design.questionnaires.push_back(each.questionnaire);
    const auto number = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    go("study", {{QStringLiteral("study"), qlonglong(number)}, {QStringLiteral("tab"), 5}});
    click("participants.enrol");
    m_site->find<QLineEdit>(QStringLiteral("enrol.identity"))->setText(QStringLiteral("Dr Example"));
    click("enrol.accept"); // age is missing: nobody is enrolled
    QVERIFY(text("enrol.code").isEmpty() &&
            m_site->find<QPushButton>(QStringLiteral("enrol.accept"))->isVisible());
    m_site->find<QLineEdit>(QStringLiteral("questionnaire.age"))->setText(QStringLiteral("34"));
    m_site->find<QRadioButton>(QStringLiteral("questionnaire.sex.0"))->click();
    m_site->find<QRadioButton>(QStringLiteral("questionnaire.handedness.1"))->click();
    click("enrol.accept");
    QTRY_VERIFY_WITH_TIMEOUT(!text("enrol.code").isEmpty(), kPatience_ms);
    const QString code = text("enrol.code");
    click("enrol.cancel");
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, rhea);
    const auto answers = reader.questionnaireAnswers(number);
    QVERIFY(answers && answers->size() == 3);
    QVERIFY(answers->front().item == "age" && answers->front().number == 34.0);
    QCOMPARE(answers->front().participant, reader.participantByCode(number, code.toStdString())->id);
    tests::writeAs(*m_site, rhea, [&](database::StudyRepository& studies) {
        return studies.recordConsent(
            answers->front().participant,
            catalogue::studySha256(QByteArray::fromStdString(design.consent.at("en"))));
    });
    go("questionnaire", {{QStringLiteral("study"), qlonglong(number)},
                         {QStringLiteral("participant"), code},
                         {QStringLiteral("questionnaire"), QStringLiteral("nasa_tlx")}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QSlider>(QStringLiteral("questionnaire.mental")), kPatience_ms);
    click("questionnaire.submit"); // a slider that nobody moved is no answer
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("questionnaire"));
    for (const char* scale : {"mental", "physical", "temporal", "performance", "effort", "frustration"})
        QTest::keyClick(m_site->find<QSlider>(QStringLiteral("questionnaire.%1").arg(QLatin1String(scale))),
                        Qt::Key_Right);
    click("questionnaire.submit");
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study_run"),
                              kPatience_ms);
    const auto rated = reader.questionnaireAnswers(number);
    QVERIFY(rated && rated->size() == 9 && rated->back().number == 12.0);
}

void TestStudyScreens::runsInOrder() {
    go("study_run", study());
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("run.begin")), kPatience_ms);
    QCOMPARE(m_site->find<QComboBox>(QStringLiteral("run.participant"))->currentData().toString(),
             m_code); // the first who still takes part
    const auto* onlyShown = m_site->find<QWidget>(QStringLiteral("run.shown")); // this station has a mouse
    QVERIFY(!desktop::studyDeviceRendersForce() && onlyShown);
    QString leftOut;
    for (const QLabel* label : onlyShown->findChildren<QLabel*>())
        leftOut += label->text();
    QVERIFY2(leftOut.contains(QStringLiteral("left out of groups and comparisons")), qPrintable(leftOut));
    for (const QLabel* label :
         m_site->window->screen()->findChildren<QLabel*>()) // sealed: the condition's name is nowhere
        QVERIFY2(!label->text().contains(QStringLiteral("Stiffness")), qPrintable(label->text()));
}

void TestStudyScreens::questionnaire() {
    go("questionnaire", {{QStringLiteral("study"), qlonglong(m_study)},
                         {QStringLiteral("participant"), m_code},
                         {QStringLiteral("questionnaire"), QStringLiteral("validity")}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QRadioButton>(QStringLiteral("questionnaire.realism.4")),
                             kPatience_ms);
    click("questionnaire.submit"); // nothing answered: stays
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("questionnaire"));
    m_site->find<QRadioButton>(QStringLiteral("questionnaire.realism.4"))->click();
    m_site->find<QLineEdit>(QStringLiteral("questionnaire.years"))->setText(QStringLiteral("7"));
    m_site->find<QRadioButton>(QStringLiteral("questionnaire.hand.1"))->click();
    click("questionnaire.submit");
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study_run"),
                              kPatience_ms);
    auto connection = m_site->database().openReader();
    QCOMPARE(
        database::StudyReader(**connection, m_site->context.actor()).questionnaireAnswers(m_study)->size(),
        3U);
}

/// CHIRON_KEEP_PICTURES=<folder> keeps pictures of the data's pages.
void TestStudyScreens::keepPicture(const QString& name) {
    if (const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !folder.isEmpty())
        m_site->window->grab().save(folder + name);
}

/// Three of four are in the group: who is not is named, with what to do, and so it is where conditions are
/// compared. What has warnings is seen to have them.
void TestStudyScreens::whoIsInTheGroup(const QString& waiting) {
    QVERIFY2(text("data.group_statement").contains(QStringLiteral("3 of 4")),
             qPrintable(text("data.group_statement")));
    const auto said = [this](const char* name) {
        QString words;
        for (const QWidget* notice : m_site->window->screen()->findChildren<QWidget*>(QLatin1String(name)))
            for (const QLabel* label : notice->findChildren<QLabel*>())
                words += label->text();
        return words;
    };
    QVERIFY2(said("data.group_missing").contains(waiting), qPrintable(said("data.group_missing")));
    const auto* runs = m_site->find<QTableWidget>(QStringLiteral("data.runs"));
    const auto columnOf = [runs](const QString& heading) {
        for (int column = 0; column < runs->columnCount(); ++column)
            if (runs->horizontalHeaderItem(column)->text() == heading)
                return column;
        return -1;
    };
    const int weber = columnOf(QStringLiteral("Weber fraction")),
              warnings = columnOf(QStringLiteral("Warnings")),
              group = columnOf(QStringLiteral("In the group"));
    QVERIFY(weber >= 0 && warnings >= 0 && group >= 0);
    for (int row = 0; row < runs->rowCount(); ++row) {
        QCOMPARE(runs->item(row, weber)->text().startsWith(QStringLiteral("! ")),
                 !runs->item(row, warnings)->text().isEmpty());
        QCOMPARE(runs->item(row, group)->text(), QStringLiteral("yes"));
    }
    click("data.compare");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTableWidget>(QStringLiteral("data.comparison_table")),
                             kPatience_ms);
    QCOMPARE(m_site->find<QTabBar>(QStringLiteral("data.tabs"))->currentIndex(),
             int(desktop::StudyDataScreen::comparisonTab));
    QVERIFY2(said("data.comparison_missing").contains(waiting), qPrintable(said("data.comparison_missing")));
}

void TestStudyScreens::dataAndUnblinding() {
    const tests::VisitedStudies studies = tests::addVisitedStudies(*m_site);
    m_data = studies.data;
    go("study_data", {{QStringLiteral("study"), qlonglong(studies.data)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTableWidget>(QStringLiteral("data.runs")), kPatience_ms);
    QCOMPARE(m_site->find<QTableWidget>(QStringLiteral("data.runs"))->rowCount(), 3);
    whoIsInTheGroup(studies.waiting);
    for (int tab = 0; tab < desktop::StudyDataScreen::tabs; ++tab) {
        m_site->find<QTabBar>(QStringLiteral("data.tabs"))->setCurrentIndex(tab);
        QTest::qWait(50);
        const bool ranks =
            tab == desktop::StudyDataScreen::groupTab || tab == desktop::StudyDataScreen::personTab;
        const auto* worths =
            m_site->window->screen()->findChild<QTableWidget*>(QStringLiteral("data.worths"));
        QCOMPARE(worths != nullptr, ranks);
        QVERIFY(!worths || worths->rowCount() == 9); // three models of three objects
        QStringList words;
        for (const QLabel* label : m_site->window->screen()->findChildren<QLabel*>())
            words << label->text();
        QVERIFY2(words.filter(QStringLiteral("log10")).isEmpty(), qPrintable(words.join(QLatin1Char('\n'))));
        if (tab == desktop::StudyDataScreen::personTab) { // spreads are told in per cent, with their meaning
            const qsizetype noise = words.indexOf(QStringLiteral("Internal noise"));
            QVERIFY2(noise >= 0 && words.value(noise + 1).endsWith(QStringLiteral(" %")) &&
                         words.value(noise + 2).endsWith(QStringLiteral(" %")) &&
                         words.value(noise + 3).contains(QStringLiteral("one standard deviation")),
                     qPrintable(words.join(QLatin1Char('\n'))));
        }
        keepPicture(QStringLiteral("/study_data_%1.png").arg(tab));
    }
    go("study_data", {{QStringLiteral("study"), qlonglong(studies.blind)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("data.unblind")), kPatience_ms);
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("data.condition.0"))->text() !=
            QStringLiteral("Stiffness of a tube"));
    for (const int tab : {desktop::StudyDataScreen::groupTab, desktop::StudyDataScreen::personTab,
                          desktop::StudyDataScreen::trialsTab}) {
        m_site->find<QTabBar>(QStringLiteral("data.tabs"))->setCurrentIndex(tab);
        QTest::qWait(50);
        const QWidget* screen = m_site->window->screen();
        const auto* quality = screen->findChild<QTableWidget*>(QStringLiteral("data.quality"));
        QVERIFY(quality && quality->rowCount() == 1);
        keepPicture(QStringLiteral("/study_sealed_%1.png").arg(tab));
        for (const char* name :
             {"data.runs", "data.trials", "data.worths"}) // how many trials there were, too, could tell
            QVERIFY2(!screen->findChild<QTableWidget*>(QLatin1String(name)), name);
        QVERIFY(!screen->findChild<QWidget*>(QStringLiteral("data.group_plot")) &&
                !screen->findChild<QWidget*>(QStringLiteral("data.curve")));
    }
    m_site->find<QTabBar>(QStringLiteral("data.tabs"))->setCurrentIndex(desktop::StudyDataScreen::groupTab);
    click("data.unblind");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("data.ask_unblind.accept")),
                             kPatience_ms);
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("data.ask_unblind.accept"))
                 ->isEnabled()); // not without a reason
    QString toCome;              // one has begun, five are planned
    for (const QLabel* label :
         m_site->find<QWidget>(QStringLiteral("data.ask_unblind.to_come"))->findChildren<QLabel*>())
        toCome += label->text();
    QVERIFY2(toCome.contains(QStringLiteral("6 participants are still to come")), qPrintable(toCome));
    m_site->find<QLineEdit>(QStringLiteral("data.ask_unblind.reason"))->setText(QStringLiteral("  "));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("data.ask_unblind.accept"))->isEnabled());
    m_site->find<QLineEdit>(QStringLiteral("data.ask_unblind.reason"))
        ->setText(QStringLiteral("A serious event"));
    click("data.ask_unblind.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("data.condition.0")) &&
                                 m_site->find<QPushButton>(QStringLiteral("data.condition.0"))->text() ==
                                     QStringLiteral("Stiffness of a tube"),
                             30000);
}

/// The estimate of a short run comes from the prior: the page says that there is no value, and why, instead
/// of showing it.
void TestStudyScreens::aRunWithoutAValueShowsNone() {
    desktop::StudyFacts facts;
    facts.study.participants.resize(1);
    facts.designed.resize(1);
    facts.runs.resize(1);
    desktop::RunFacts& run = facts.runs.front();
    run.run.state = database::StudyRunState::open;
    run.scored = 2;
    run.presence = session::Presence::guessing;
    run.estimate.trials = 2;
    run.estimate.weber = 0.0306;
    run.estimate.weber95 = {0.001, 0.9};
    run.estimate.sigma_log10 = 0.0123;
    run.estimate.warnings = {{psychophysics::WarningKind::priorEdgeHigh}};
    const auto shown = [&] {
        const desktop::PersonPage page(m_site->context, facts, 0);
        QStringList words;
        for (const QLabel* label : page.findChildren<QLabel*>())
            words << label->text();
        return words.join(QLatin1Char('\n'));
    };
    QString words = shown();
    QVERIFY2(words.contains(QStringLiteral("no value yet")) && !words.contains(QStringLiteral("3.06")) &&
                 words.contains(QStringLiteral("the threshold may be far above the largest difference")) &&
                 !words.contains(QStringLiteral("Internal noise")),
             qPrintable(words));
    run.estimate.warnings = {{psychophysics::WarningKind::fewTrials, 2}}; // doubtful, and a value
    run.presence = session::Presence::used;
    words = shown();
    QVERIFY2(words.contains(QStringLiteral("! 3.06")) && !words.contains(QStringLiteral("no value")),
             qPrintable(words));
}

/// Closed, asked twice, done, there already, and left meanwhile: no export ends without a word.
void TestStudyScreens::everyWayOutOfAnExportIsTold() {
    go("study_data", {{QStringLiteral("study"), qlonglong(m_data)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTableWidget>(QStringLiteral("data.runs")), kPatience_ms);
    QStringList told;
    QObject hears; // no longer than what it writes to
    QObject::connect(&m_site->context.messages(), &desktop::Messages::told, &hears,
                     [&told](const desktop::Message& message) { told << message.text; });
    const auto hasTold = [&](const char* words) {
        return told.join(QLatin1Char('|')).contains(QLatin1String(words));
    };
    click("data.csv");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QFileDialog>(QStringLiteral("data.folder")), kPatience_ms);
    m_site->find<QFileDialog>(QStringLiteral("data.folder"))->reject();
    QVERIFY2(hasTold("Nothing was exported"), qPrintable(told.join(QLatin1Char('|'))));

    const QTemporaryDir folder;
    auto* screen = m_site->screen<desktop::StudyDataScreen>();
    told.clear();
    screen->exportCsvTo(folder.path());
    click("data.csv"); // while it is written
    QVERIFY2(hasTold("still being written"), qPrintable(told.join(QLatin1Char('|'))));
    QTRY_VERIFY2_WITH_TIMEOUT(hasTold("were written to"), qPrintable(told.join(QLatin1Char('|'))),
                              kPatience_ms);
    QVERIFY(!QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
    told.clear();
    const QString tables =
        QDir(folder.path())
            .filePath(QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).front());
    const auto again = [&](const char* choice,
                           bool mayReplace = true) { // it is there already: somebody is asked
        told.clear();
        screen->exportCsvTo(folder.path());
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QMessageBox>(QStringLiteral("data.there")), kPatience_ms);
        auto* box = m_site->find<QMessageBox>(QStringLiteral("data.there"));
        QCOMPARE(box->findChild<QPushButton*>(QStringLiteral("data.there.replace")) != nullptr, mayReplace);
        box->findChild<QPushButton*>(QLatin1String(choice))->click();
        QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QMessageBox>(QStringLiteral("data.there")),
                                 kPatience_ms); // the next one is not mistaken for it
    };
    QFile mark(QDir(tables).filePath(QStringLiteral("mark")));
    QVERIFY(mark.open(QIODevice::WriteOnly));
    again("data.there.cancel");
    QVERIFY2(hasTold("is as it was"), qPrintable(told.join(QLatin1Char('|'))));
    again("data.there.beside");
    QTRY_VERIFY2_WITH_TIMEOUT(hasTold("were written to"), qPrintable(told.join(QLatin1Char('|'))),
                              kPatience_ms);
    QVERIFY(QFileInfo::exists(tables + QStringLiteral("-2/trials.csv")) && mark.exists());
    again("data.there.replace");
    QTRY_VERIFY2_WITH_TIMEOUT(hasTold("were written to"), qPrintable(told.join(QLatin1Char('|'))),
                              kPatience_ms);
    QVERIFY(QFileInfo::exists(tables + QStringLiteral("/trials.csv")) && !mark.exists());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 2);
    QVERIFY(QDir(tables).removeRecursively() &&
            QDir().mkpath(tables)); // a folder that is nobody's export is never replaced
    again("data.there.beside", false);
    QTRY_VERIFY2_WITH_TIMEOUT(hasTold("were written to"), qPrintable(told.join(QLatin1Char('|'))),
                              kPatience_ms);

    const QTemporaryDir other;
    told.clear();
    screen->exportCsvTo(other.path());
    m_site->go(QStringLiteral("studies")); // and the screen is gone when it is done
    QTRY_VERIFY2_WITH_TIMEOUT(hasTold("were written to"), qPrintable(told.join(QLatin1Char('|'))),
                              kPatience_ms);
}

/// Whoever looks again finds it as they left it.
void TestStudyScreens::whatGroupsIncludeIsRemembered() {
    const auto open = [this] {
        go("study_data", {{QStringLiteral("study"), qlonglong(m_data)}});
        return QTest::qWaitFor(
            [this] { return m_site->find<QCheckBox>(QStringLiteral("data.with_shown")) != nullptr; },
            kPatience_ms);
    };
    QVERIFY(open());
    auto* shown = m_site->find<QCheckBox>(QStringLiteral("data.with_shown"));
    QVERIFY(shown->isVisible() && !shown->isChecked());
    shown->click();
    go("studies");
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QCheckBox>(QStringLiteral("data.with_shown")), kPatience_ms);
    QVERIFY(open());
    QVERIFY(m_site->find<QCheckBox>(QStringLiteral("data.with_shown"))->isChecked());
    m_site->find<QCheckBox>(QStringLiteral("data.with_shown"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QCheckBox>(QStringLiteral("data.with_shown")) &&
                                 !m_site->find<QCheckBox>(QStringLiteral("data.with_shown"))->isChecked(),
                             kPatience_ms);
}

/// From the page where somebody was just seen off: enrolled, agreed, and ready to begin.
void TestStudyScreens::theNextParticipantIsEnrolledWhereTheyAreRun() {
    go("study_run", {{QStringLiteral("study"), qlonglong(m_data)}});
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("run.enrol")), kPatience_ms);
    click("run.enrol");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("enrol.identity")), kPatience_ms);
    m_site->find<QLineEdit>(QStringLiteral("enrol.identity"))->setText(QStringLiteral("The next one"));
    click("enrol.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("enrol.consent")), kPatience_ms);
    const QString code = m_site->find<QLabel>(QStringLiteral("enrol.code"))->text();
    click("enrol.consent");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QCheckBox>(QStringLiteral("consent.agreed")), kPatience_ms);
    m_site->find<QCheckBox>(QStringLiteral("consent.agreed"))->click();
    click("consent.accept");
    const auto chosen = [this] {
        const auto* participant = m_site->find<QComboBox>(QStringLiteral("run.participant"));
        return participant ? participant->currentData().toString() : QString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(
        chosen(), code,
        kPatience_ms); // the page behind the dialog shows somebody else until it is read again
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("run.begin")), kPatience_ms);
}

/// Whoever is done is followed by somebody who waits; enrolling another person comes second.
void TestStudyScreens::whoWaitsComesBeforeTheNext() {
    auto connection = m_site->database().openReader();
    const auto participants =
        database::StudyReader(**connection, m_site->context.actor()).participants(m_data);
    QVERIFY(participants.has_value());
    QString done;
    for (const database::Participant& each : *participants)
        if (!each.simulated && each.state == database::ParticipantState::completed)
            done = QString::fromStdString(each.code);
    QVERIFY(!done.isEmpty());
    go("study_run", {{QStringLiteral("study"), qlonglong(m_data)}, {QStringLiteral("participant"), done}});
    const auto button = [this](const char* name) {
        return m_site->window->screen()->findChild<QPushButton*>(QLatin1String(name));
    };
    QTRY_VERIFY_WITH_TIMEOUT(button("run.next") && button("run.enrol"), kPatience_ms);
    QCOMPARE(button("run.next")->property("kind").toString(), QStringLiteral("primary"));
    QCOMPARE(button("run.enrol")->property("kind").toString(), QString());
    button("run.next")->click();
    const auto* choice = m_site->window->screen()->findChild<QComboBox*>(QStringLiteral("run.participant"));
    QTRY_VERIFY_WITH_TIMEOUT(choice->currentData().toString() != done, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(button("run.begin") || button("run.consent"), kPatience_ms);
    QVERIFY(!button("run.next")); // first the one who is here now
}

/// After the last condition the questions are the next step, here and from the list of participants. Whoever
/// comes next is offered once they are answered, and before people who have only questions left.
void TestStudyScreens::whoHasOnlyQuestionsLeftIsAskedThem() {
    const database::Actor rhea = m_site->context.actor();
    const psychophysics::StudyDesign design = tests::smallStudy("only_questions");
    const auto number = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    const auto done = tests::addParticipant(*m_site, rhea, number, design, "done");
    const auto waits = tests::addParticipant(*m_site, rhea, number, design, "waits");
    for (const char* condition : {"stiffness", "mass"})
        tests::addRun(*m_site, rhea, design, done, condition, 0.1, 5);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.completeParticipant(done.id); });
    const QString code = QString::fromStdString(done.code);
    const QString next = QString::fromStdString(waits.code);
    const auto open = [&](const QString& participant) {
        go("study_run",
           {{QStringLiteral("study"), qlonglong(number)}, {QStringLiteral("participant"), participant}});
    };
    const auto button = [this](const char* name) {
        return m_site->window->screen()->findChild<QPushButton*>(QLatin1String(name));
    };
    const auto kind = [&](const char* name) {
        return button(name) ? button(name)->property("kind").toString() : QStringLiteral("none");
    };
    open(QString());
    QCOMPARE(m_site->find<QComboBox>(QStringLiteral("run.participant"))->currentData().toString(), next);
    QCOMPARE(kind("run.questionnaire.validity"), QString()); // first the conditions
    QCOMPARE(kind("run.begin"), QStringLiteral("primary"));
    open(code);
    QCOMPARE(kind("run.questionnaire.validity"), QStringLiteral("primary"));
    QCOMPARE(kind("run.enrol"), QString());
    QVERIFY(!button("run.next"));
    go("study", {{QStringLiteral("study"), qlonglong(number)},
                 {QStringLiteral("tab"), desktop::StudyScreen::participantsTab}});
    auto* table = m_site->find<QTableWidget>(QStringLiteral("participants.table"));
    QVERIFY(table && table->rowCount() == 2);
    table->selectRow(table->item(0, 0)->text() == code ? 0 : 1);
    QVERIFY(button("participants.run")->isEnabled());
    tests::addAnswers(*m_site, rhea, done, 3);
    open(code);
    QVERIFY(!button("run.questionnaire.validity"));
    QVERIFY2(button("run.next") && button("run.next")->text().contains(next), "the next one is not offered");
    QCOMPARE(kind("run.next"), QStringLiteral("primary"));
}

/// Two who have agreed and begun nothing when the study was closed.
void TestStudyScreens::nobodyIsSentBackAndForth() {
    const database::Actor rhea = m_site->context.actor();
    const psychophysics::StudyDesign design = tests::smallStudy("back_and_forth");
    const auto number = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    std::vector<database::Participant> both;
    for (const char* name : {"one", "two"})
        both.push_back(tests::addParticipant(*m_site, rhea, number, design, name));
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.closeStudy(number); });
    for (const database::Participant& each : both) {
        go("study_run", {{QStringLiteral("study"), qlonglong(number)},
                         {QStringLiteral("participant"), QString::fromStdString(each.code)}});
        const QWidget* screen = m_site->window->screen();
        QVERIFY(screen->findChild<QPushButton*>(QStringLiteral("run.questionnaire.validity")));
        QVERIFY(!screen->findChild<QPushButton*>(QStringLiteral("run.next")));
    }
}

/// By whoever comes back from a run or a questionnaire; somebody who was chosen on purpose stays.
void TestStudyScreens::whoeverComesNextIsSaidAndSelected() {
    const database::Actor rhea = m_site->context.actor();
    psychophysics::StudyDesign design = tests::smallStudy("comes_next");
    design.questionnaires.clear();
    const auto number = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    const auto done = tests::addParticipant(*m_site, rhea, number, design, "done");
    const auto waits = tests::addParticipant(*m_site, rhea, number, design, "waits");
    const QString first = QString::fromStdString(done.code), second = QString::fromStdString(waits.code);
    const auto comeBack = [&](const QString& participant, bool ran) {
        QVariantMap place{{QStringLiteral("study"), qlonglong(number)},
                          {QStringLiteral("participant"), participant}};
        if (ran)
            place.insert(QStringLiteral("just_ran"), true);
        go("study_run", place);
    };
    const auto selected = [this] {
        return m_site->window->screen()
            ->findChild<QComboBox*>(QStringLiteral("run.participant"))
            ->currentData()
            .toString();
    };
    const auto said = [this] {
        return m_site->window->screen()->findChild<QLabel*>(QStringLiteral("run.who_is_next"))->text();
    };
    tests::addRun(*m_site, rhea, design, done, "stiffness", 0.1, 5);
    comeBack(first, true); // there is another condition
    QCOMPARE(selected(), first);
    QVERIFY2(said().contains(first) && !said().contains(second), qPrintable(said()));
    QVERIFY(m_site->window->screen()
                ->findChild<QLabel*>(QStringLiteral("run.sequence"))
                ->text()
                .contains(QStringLiteral("free minute")));
    tests::addRun(*m_site, rhea, design, done, "mass", 0.1, 5);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.completeParticipant(done.id); });
    comeBack(first, false);
    QCOMPARE(selected(), first);
    QVERIFY2(said().contains(second), qPrintable(said()));
    comeBack(first, true);
    QCOMPARE(selected(), second);
    QVERIFY2(said().contains(first + QStringLiteral(" has nothing left to do")) &&
                 said().contains(second + QStringLiteral(" comes next and is selected")),
             qPrintable(said()));
    QVERIFY(m_site->window->screen()->findChild<QPushButton*>(QStringLiteral("run.begin")));
    for (const char* condition : {"stiffness", "mass"})
        tests::addRun(*m_site, rhea, design, waits, condition, 0.1, 5);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.completeParticipant(waits.id); });
    comeBack(second, true);
    QCOMPARE(selected(), second); // nobody else is waiting
    QVERIFY2(said().contains(QStringLiteral("Enrol the next participant")), qPrintable(said()));
}

/// Before somebody presses a button that cannot be undone.
void TestStudyScreens::withdrawingSaysWhatIsKeptAndWhatCounts() {
    const database::Actor rhea = m_site->context.actor();
    const psychophysics::StudyDesign design = tests::smallStudy("withdrawing");
    const auto number = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(number); });
    const auto leaves = tests::addParticipant(*m_site, rhea, number, design, "leaves");
    go("study", {{QStringLiteral("study"), qlonglong(number)},
                 {QStringLiteral("tab"), desktop::StudyScreen::participantsTab}});
    QTRY_VERIFY_WITH_TIMEOUT(
        m_site->find<QPushButton>(QStringLiteral("participants.withdraw")) &&
            m_site->find<QPushButton>(QStringLiteral("participants.withdraw"))->isEnabled(),
        kPatience_ms);
    click("participants.withdraw");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("withdraw")), kPatience_ms);
    QVERIFY(text("withdraw.when").contains(QStringLiteral("resumed under Run")));
    QVERIFY(text("withdraw.kept").contains(QStringLiteral("everything that was recorded")));
    QVERIFY(text("withdraw.counts").contains(QStringLiteral("left out of group values and comparisons")));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("withdraw.accept"))
                ->text()
                .contains(QString::fromStdString(leaves.code)));
    click("withdraw.cancel");
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QDialog>(QStringLiteral("withdraw")), kPatience_ms);
    auto connection = m_site->database().openReader();
    const auto participants = database::StudyReader(**connection, rhea).participants(number);
    QVERIFY(participants && participants->front().state == database::ParticipantState::consented);
}

/// Nothing is cut off or scrolled to at 1280 pixels, in any language; every heading says what it means.
void TestStudyScreens::theTableOfTrialsFits() {
    constexpr int kReadable_px = 120; // "Zählt", "Practice" and the beginning of a reason
    for (const char* language : tests::languagesEnglishLast()) {
        m_site->settings.setLanguage(QLatin1String(language));
        go("study_data", {{QStringLiteral("study"), qlonglong(m_data)},
                          {QStringLiteral("tab"), desktop::StudyDataScreen::trialsTab}});
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTableWidget>(QStringLiteral("data.trials")), kPatience_ms);
        auto* table = m_site->find<QTableWidget>(QStringLiteral("data.trials"));
        QCOMPARE(m_site->window->width(), 1280);
        QTRY_VERIFY2_WITH_TIMEOUT(table->horizontalScrollBar()->maximum() == 0, language, kPatience_ms);
        QVERIFY2(
            table->columnWidth(3) >= kReadable_px,
            qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(language)).arg(table->columnWidth(3))));
        for (int column = 0; column < table->columnCount(); ++column)
            QVERIFY(!table->horizontalHeaderItem(column)->toolTip().isEmpty());
        QVERIFY(!table->item(0, 3)->toolTip().isEmpty());
    }
}

void TestStudyScreens::archivedWithUndo() {
    std::function<void()> undo;
    QObject::connect(&m_site->context.messages(), &desktop::Messages::told, this,
                     [&undo](const desktop::Message& message) { undo = message.action; });
    go("studies", study());
    auto* table = m_site->find<QTableWidget>(QStringLiteral("studies.table"));
    QTRY_VERIFY_WITH_TIMEOUT(table->rowCount() > 0, kPatience_ms); // those of the tests before
    const int all = table->rowCount();
    click("studies.archive");
    QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), all - 1, kPatience_ms);
    QVERIFY(undo);
    undo();
    QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), all, kPatience_ms);
}

QTEST_MAIN(TestStudyScreens)
#include "test_study_screens.moc"
