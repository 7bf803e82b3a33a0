// SPDX-License-Identifier: GPL-3.0-or-later
// A study designed by somebody who does not know the program: from nothing to frozen, a page at a time, with
// what is true beside it; and by somebody in a hurry, who leaves fields empty, types values that cannot be,
// and pastes numbers with commas.
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "desktop/studies/check_list.h"
#include "desktop/studies/conditions_page.h"
#include "desktop/studies/difference_table.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/levels_table.h"
#include "desktop/studies/new_study_dialog.h"
#include "desktop/studies/number_list.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/rules_page.h"
#include "desktop/studies/studies_screen.h"
#include "desktop/studies/study_screen.h"
#include "desktop/studies/study_titles.h"
#include "desktop/study_run/trials_screen.h"
#include "desktop/widgets/scroll_page.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "support/every_place.h"
#include "support/languages.h"
#include "support/patience.h"
#include "support/sitting_hands.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>

using chiron::tests::kPatience_ms;

using namespace chiron;
using desktop::StudyScreen;
using tests::DesktopFixture;

namespace {
constexpr int kMostActions = 25;
} // namespace

class TestStudyDesign : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_site = std::make_unique<DesktopFixture>();
        m_site->logIn("rhea");
    }
    void cleanup() { // else the next test is asked whether to leave without what is wrong
        if (!screen())
            return;
        screen()->draft().history().clear();
        if (!screen()->faults().empty())
            screen()->draft().change({}, {}, [this](psychophysics::StudyDesign& now) { now = m_opened; });
        QTRY_VERIFY_WITH_TIMEOUT(screen()->faults().empty(), kPatience_ms);
    }
    void cleanupTestCase() { m_site.reset(); }
    void templatesCiteTheirSource();
    void templatesAreReadWhenLarge();
    void fromNothingToFrozen();
    void aCopyOfAFrozenStudy();
    void titlesOfCopies();
    void aTemplateIsFoundByWords();
    void templatesAreFoundByWhatPeopleCallThem_data();
    void templatesAreFoundByWhatPeopleCallThem();
    void twoConditionsInTwoActions();
    void trialsAreCountedByCondition();
    void whatIsMissingIsLedTo();
    void aSuggestedTitleIsTypedOver();
    void arrowKeysKeepTheTemplateInSight();
    void focusStaysWithThePage();
    void everyTaskHasABlankStart();
    void namesThatAreTaken();
    void shortNamesFollowTheirTitles();
    void whatIsRemovedComesBack();
    void aTableSaysHowItIsSpaced();
    void aTableOfOneSideHasASmallest();
    void everyNumberSaysItsRange();
    void theSummaryIsAlwaysTrue();
    void instructionsFollowTheSettings();
    void instructionsInThreeLanguages();
    void everyFieldSaysWhatItMeans();
    void onlyWhatAppliesIsThere();
    void stepsOfAStaircase();
    void faultsStandAtTheirFields();
    void aFaultOfAnotherConditionIsShown();
    void whatIsWrongTakesNoRoomBefore();
    void theLengthOfARunIsFoundUnderTrials();
    void aCopySaysInWhatItDiffers();
    void whatWasJustMadeWrongIsNotFrozen();
    void aReferenceTakesNobodysName();
    void aTableOfNumbersIsPasted();
    void numbersAreReadAsTheyWereMeant();
    void anUnreadNumberKeepsItsPage();
    void aConditionHasItsOwnInstructions();
    void placeholdersAreNotFrozen();
    void aPreviewThatIsLeftIsTold();
    void whatIsRequiredIsMarked();
    void aPilotIsKeptApart();

private:
    void openDraft(const psychophysics::StudyDesign& design, int tab = StudyScreen::generalTab) {
        m_opened = design;
        m_study = tests::addDraft(*m_site, m_site->context.actor(), design);
        reopen(tab);
    }
    void reopen(int tab) {
        m_site->go(QStringLiteral("study"),
                   {{QStringLiteral("study"), qlonglong(m_study)}, {QStringLiteral("tab"), tab}});
        QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QTabBar>(QStringLiteral("study.tabs")), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    }
    StudyScreen* screen() { return m_site->screen<StudyScreen>(); }
    const psychophysics::StudyDesign& design() { return screen()->draft().design(); }
    template <class W> W* find(const char* name) {
        return m_site->window->screen()->findChild<W*>(QLatin1String(name));
    }
    QString text(const char* name) {
        auto* label = m_site->find<QLabel>(QLatin1String(name));
        return label ? label->text() : QStringLiteral("(none)");
    }
    bool saved() {
        return QTest::qWaitFor(
            [this] { return text("study.state").contains(QStringLiteral("all changes saved")); },
            kPatience_ms);
    }
    /// The one that is seen: pages and screens that were left live until the event loop turns.
    template <class W> W* shown(const char* name) {
        for (QWidget* top : QApplication::topLevelWidgets())
            for (W* found : top->findChildren<W*>(QLatin1String(name)))
                if (found->isVisible())
                    return found;
        return nullptr;
    }
    /// What a person does: each call is one action.
    void click(const char* name) {
        ++m_actions;
        QTRY_VERIFY2_WITH_TIMEOUT(shown<QAbstractButton>(name) && shown<QAbstractButton>(name)->isEnabled(),
                                  name, kPatience_ms);
        shown<QAbstractButton>(name)->click();
    }
    void type(const char* name, const QString& words) {
        ++m_actions;
        QTRY_VERIFY2_WITH_TIMEOUT(shown<QWidget>(name), name, kPatience_ms);
        auto* field = shown<QWidget>(name);
        field->setFocus();
        if (auto* line = qobject_cast<QLineEdit*>(field))
            line->selectAll();
        else if (auto* spin = qobject_cast<QAbstractSpinBox*>(field))
            spin->selectAll();
        else if (auto* page = qobject_cast<QPlainTextEdit*>(field))
            page->selectAll();
        if (words.isEmpty())
            QTest::keyClick(field, Qt::Key_Delete);
        else
            QTest::keyClicks(field, words);
    }
    /// Enter in the field that was typed into.
    void enter(const char* name) {
        ++m_actions;
        QVERIFY2(shown<QWidget>(name), name);
        QTest::keyClick(shown<QWidget>(name), Qt::Key_Return);
    }
    void pilotTried();
    bool inFocus(const char* field) const {
        return m_site->window->focusWidget() &&
               m_site->window->focusWidget()->objectName() == QLatin1String(field);
    }
    QString faultAt(const char* field) {
        auto* fault = find<QWidget>((QByteArray(field) + ".fault").constData());
        if (!fault)
            return {};
        QString words;
        for (const QLabel* label : fault->findChildren<QLabel*>())
            words += label->text();
        return words;
    }
    void step(const char* to) {
        click("study.next");
        QTRY_VERIFY2_WITH_TIMEOUT(find<QWidget>(to), to, kPatience_ms);
    }

    std::unique_ptr<DesktopFixture> m_site;
    database::StudyNumber m_study = 0;
    psychophysics::StudyDesign m_opened;
    int m_actions = 0;
};

void TestStudyDesign::templatesCiteTheirSource() {
    const auto templates = catalogue::StudyCatalogue::load();
    QVERIFY(templates && templates->studies().size() >= 12);
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("new_study.template.new_rank3")),
                             kPatience_ms);
    for (const psychophysics::StudyDesign& each : templates->studies()) {
        QVERIFY2(!each.source.empty(), each.id.c_str());
        const QString shown = text(
            qPrintable(QStringLiteral("new_study.template.%1.source").arg(QString::fromStdString(each.id))));
        QVERIFY2(shown.contains(QString::fromStdString(each.source)), qPrintable(shown));
        for (const auto& [language, words] : each.instructions) // of time and breaks the settings speak
            for (const char* never :
                 {"as you like", "no hurry", "breaks", "möchten", "Pausen", "όσες φορές", "διαλείμματα"})
                QVERIFY2(words.find(never) == std::string::npos,
                         (each.id + " " + language + ": " + never).c_str());
    }
    // The templates come before the study of no template.
    const auto* first = m_site->find<QPushButton>(QStringLiteral("new_study.template.apex"));
    const auto* plain = m_site->find<QPushButton>(QStringLiteral("new_study.template.new_rank3"));
    QVERIFY(first->mapToGlobal(QPoint()).y() < plain->mapToGlobal(QPoint()).y());
    click("new_study.cancel");
}

void TestStudyDesign::templatesAreReadWhenLarge() {
    m_site->settings.setScale(2.0);
    m_site->context.applyAppearance();
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("new_study.template.apex")),
                             kPatience_ms);
    const auto squeezed = [&] { // labels lower than their wrapped words
        QStringList found;
        for (const QLabel* label :
             m_site->find<QPushButton>(QStringLiteral("new_study.template.apex"))->findChildren<QLabel*>())
            if (label->height() < label->heightForWidth(label->width()))
                found << label->text();
        return found;
    };
    QTRY_COMPARE_WITH_TIMEOUT(squeezed(), QStringList(), kPatience_ms);
    click("new_study.cancel");
    m_site->settings.setScale(1.0);
    m_site->context.applyAppearance();
}

/// One of those who design it tries it: the instructions, the controls, some of the free minute, and back to
/// the design, asked once and for no password.
void TestStudyDesign::pilotTried() {
    click("check.pilot");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("pilot.accept")), kPatience_ms);
    click("pilot.agreed");
    click("pilot.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->screen<desktop::TrialsScreen>() &&
                                 m_site->screen<desktop::TrialsScreen>()->live(),
                             kPatience_ms);
    const auto* trials = m_site->screen<desktop::TrialsScreen>();
    using State = session::LiveStudyView::State;
    click("break.button"); // the instructions
    click("training.ready.go");
    QTRY_COMPARE_WITH_TIMEOUT(trials->live()->view().state, State::trying, kPatience_ms);
    click("trials.enough"); // of the free minute
    QTRY_COMPARE_WITH_TIMEOUT(trials->live()->view().state, State::exploring, kPatience_ms);
    QTimer look; // the question waits in the press that asks it
    connect(&look, &QTimer::timeout, this, [&] {
        if (auto* stop = m_site->find<QPushButton>(QStringLiteral("trials.ask.stop"))) {
            look.stop();
            ++m_actions;
            stop->click();
        }
    });
    look.start(100);
    click("trials.stop");
    QVERIFY(!look.isActive());
    QTRY_COMPARE_WITH_TIMEOUT(m_site->context.navigator().current().screen, QStringLiteral("study"),
                              kPatience_ms);
}

/// Two alternatives, two tubes of 0.3 and 0.6 N/mm, 15 trials of each, a look at the preview and a pilot:
/// every press and every typed field is one action.
void TestStudyDesign::fromNothingToFrozen() {
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QPushButton>(QStringLiteral("new_study.template.new_rank3")),
                             kPatience_ms);
    m_actions = 0;
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("new_study.template.stiffness_2afc")),
                             kPatience_ms);
    click("new_study.template.stiffness_2afc");
    type("new_study.title", QStringLiteral("Soft and stiff tubes"));
    QCOMPARE(m_site->find<QLineEdit>(QStringLiteral("new_study.key"))->text(),
             QStringLiteral("soft_and_stiff_tubes")); // made of the title
    click("new_study.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPlainTextEdit>(QStringLiteral("design.objective")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    m_study = m_site->context.navigator().current().parameters.value(QStringLiteral("study")).toLongLong();
    type("design.objective", QStringLiteral("Whether the Weber fraction of stiffness depends on the "
                                            "reference. We expect the same for both."));
    type("design.ethics", QStringLiteral("Ethics committee of the university, 17/2026"));
    enter("design.ethics"); // as Next
    QTRY_VERIFY_WITH_TIMEOUT(find<QWidget>("conditions.copy"), kPatience_ms);
    type("condition.reference", QStringLiteral("0.3 N/mm")); // in the unit that people say it in
    QCOMPARE(design().conditions.front().stimulus.reference, 300.0);
    QCOMPARE(find<QLineEdit>("condition.title")->text(),
             QStringLiteral("Tube of 300 N/m")); // names that tell the reference follow it
    QCOMPARE(design().conditions.front().id, std::string("tube_300"));
    type("procedure.0.trials", QStringLiteral("15"));
    QCOMPARE(find<QSpinBox>("procedure.0.minimum_trials")->value(), 15); // no run has more than its most
    click("conditions.copy");
    QTRY_COMPARE_WITH_TIMEOUT(design().conditions.size(), std::size_t{2}, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("condition.title")->text().endsWith(QStringLiteral("(2)")),
                             kPatience_ms);
    type("condition.reference", QStringLiteral("0.6 N/mm")); // the one field in which it differs
    QCOMPARE(design().conditions.back().stimulus.reference, 600.0);
    QCOMPARE(design().conditions.back().title.at("en"), std::string("Tube of 600 N/m"));
    QCOMPARE(design().conditions.back().title.at("de"), std::string("Schlauch mit 600 N/m"));
    QCOMPARE(design().conditions.back().id, std::string("tube_600"));
    ++m_actions; // a page is also reached by its name
    find<QTabBar>("study.tabs")->setCurrentIndex(StudyScreen::previewTab);
    QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("preview.start"), kPatience_ms);
    click("preview.start");
    QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("preview.start")->isEnabled(),
                             kPatience_ms); // what it found was looked at
    step("check.freeze");
    QVERIFY(saved());
    pilotTried();
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("check.freeze"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    click("check.freeze");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("freeze")), kPatience_ms);
    auto* list = m_site->find<QDialog>(QStringLiteral("freeze"))->findChild<desktop::CheckList*>();
    QTRY_VERIFY_WITH_TIMEOUT(!list->has(desktop::FreezeCheck::State::waiting),
                             kPatience_ms); // simulated observers
    QVERIFY(!list->has(desktop::FreezeCheck::State::bad));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("freeze.accept"))
                 ->isEnabled()); // nobody has tried it: worth a look
    click("freeze.seen");
    click("freeze.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("participants.enrol")), kPatience_ms);
    qInfo("actions: %d", m_actions);
    QVERIFY2(m_actions <= kMostActions, qPrintable(QString::number(m_actions)));

    auto connection = m_site->database().openReader();
    const auto stored = database::StudyReader(**connection, m_site->context.actor()).study(m_study);
    QVERIFY(stored);
    const auto frozen = catalogue::readStudy(QByteArray::fromStdString(stored->designJson), "frozen");
    QVERIFY(frozen && frozen->conditions.size() == 2 &&
            frozen->conditions.front().task == psychophysics::Task::twoAfc);
    QCOMPARE(stored->summary.sha256, catalogue::studySha256(QByteArray::fromStdString(stored->designJson)));
    QCOMPARE(frozen->conditions.back().stimulus.reference, 600.0);
    QVERIFY(frozen->trial.practiceTrials > 0 &&
            frozen->trial.probeAtLeast_N > 0.0); // without anybody asking for it
    QVERIFY(frozen->instructions.at("en").find("at most 15 trials") !=
            std::string::npos); // what participants read is frozen as they read it
    QVERIFY(!frozen->source.empty() && frozen->ethics == "Ethics committee of the university, 17/2026");
}

void TestStudyDesign::aCopyOfAFrozenStudy() {
    const psychophysics::StudyDesign original = design();
    click("study.copy");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    auto* title = m_site->find<QLineEdit>(QStringLiteral("new_study.title"));
    QTRY_COMPARE_WITH_TIMEOUT(title->text(), QStringLiteral("Soft and stiff tubes (copy)"), kPatience_ms);
    QCOMPARE(title->selectedText(), title->text()); // to be typed over
    QCOMPARE(m_site->find<QLineEdit>(QStringLiteral("new_study.key"))->text(),
             QStringLiteral("soft_and_stiff_tubes_copy"));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("new_study.template.new_rank3")));
    click("new_study.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("design.ethics")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QVERIFY(m_site->context.navigator().current().parameters.value(QStringLiteral("study")).toLongLong() !=
            m_study);
    QCOMPARE(design().conditions.size(), original.conditions.size());
    QCOMPARE(design().conditions.back().stimulus.reference, 600.0);
    QCOMPARE(design().instructions, original.instructions);
    QVERIFY(design().ethics.empty()); // an approval is of one study
    QVERIFY(find<QLineEdit>("design.title") && !find<QLineEdit>("design.title")->isReadOnly());
    // And from the list.
    m_site->go(QStringLiteral("studies"), {{QStringLiteral("study"), qlonglong(m_study)}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("studies.copy")), kPatience_ms);
    click("studies.copy");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(m_site->find<QLineEdit>(QStringLiteral("new_study.title"))->text(),
                              QStringLiteral("Soft and stiff tubes (copy 2)"),
                              kPatience_ms); // there is a copy already
    type("new_study.title",
         QStringLiteral("soft  and stiff Tubes")); // the original's, but for capitals and a space
    QVERIFY(text("new_study.title.fault").contains(QStringLiteral("Another study has this title")));
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("new_study.accept"))->isEnabled());
    type("new_study.title", QStringLiteral("Softer tubes"));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("new_study.accept"))->isEnabled());
    click("new_study.cancel");
}

/// A suggestion is free, does not grow with each copy, and stays short enough to be stored.
void TestStudyDesign::titlesOfCopies() {
    using desktop::copyTitle;
    using desktop::titleForComparison;
    QCOMPARE(copyTitle(QStringLiteral("Tubes"), {}), QStringLiteral("Tubes (copy)"));
    QCOMPARE(copyTitle(QStringLiteral("Tubes"), {titleForComparison(QStringLiteral("TUBES (Copy)"))}),
             QStringLiteral("Tubes (copy 2)"));
    QCOMPARE(copyTitle(QStringLiteral("Tubes (copy)"), {titleForComparison(QStringLiteral("Tubes (copy)"))}),
             QStringLiteral("Tubes (copy 2)"));
    QCOMPARE(copyTitle(QStringLiteral("Tubes (copy 2)"), {}), QStringLiteral("Tubes (copy)"));
    QVERIFY(copyTitle(QString(500, QLatin1Char('x')), {}).toUtf8().size() <= 500);
    QCOMPARE(desktop::freeTitle(QStringLiteral("Tubes"), {titleForComparison(QStringLiteral("tubes"))}),
             QStringLiteral("Tubes 2"));
}

/// Nothing is chosen beforehand; words find, in any order and without accents; Enter takes what is found, and
/// never creates by itself.
void TestStudyDesign::aTemplateIsFoundByWords() {
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("new_study.template.new_rank3"), kPatience_ms);
    const auto* accept = m_site->find<QPushButton>(QStringLiteral("new_study.accept"));
    QVERIFY(!accept->isEnabled());
    QVERIFY(m_site->find<QLineEdit>(QStringLiteral("new_study.title"))->text().isEmpty());
    auto* dialog = m_site->find<QDialog>(QStringLiteral("new_study"));
    auto* filter = m_site->find<QLineEdit>(QStringLiteral("new_study.filter"));
    QCOMPARE(dialog->focusWidget(), static_cast<QWidget*>(filter));
    type("new_study.filter", QStringLiteral("nothing like this"));
    QVERIFY(shown<QLabel>("new_study.none"));
    QVERIFY(!shown<QPushButton>("new_study.template.friction") &&
            !shown<QPushButton>("new_study.template.new_rank3"));
    QTest::keyClick(filter, Qt::Key_Return);
    QVERIFY(dialog->isVisible() && !accept->isEnabled());
    filter->setText(QStringLiteral("2AFC Stíff")); // key clicks know no accents
    QVERIFY(!shown<QLabel>("new_study.none"));
    QVERIFY(shown<QPushButton>("new_study.template.stiffness_2afc") &&
            !shown<QPushButton>("new_study.template.apex"));
    QTest::keyClick(filter, Qt::Key_Down);
    QVERIFY(dialog->focusWidget() != filter &&
            dialog->focusWidget()->objectName().startsWith(QStringLiteral("new_study.template.")));
    QVERIFY(!accept->isEnabled()); // it was looked at, not taken
    filter->setFocus();
    QTest::keyClick(filter, Qt::Key_Return);
    auto* chosen = m_site->find<QPushButton>(QStringLiteral("new_study.template.stiffness_2afc"));
    QVERIFY(chosen->isChecked() && accept->isEnabled() && dialog->isVisible());
    auto* title = m_site->find<QLineEdit>(QStringLiteral("new_study.title"));
    QCOMPARE(dialog->focusWidget(), static_cast<QWidget*>(title));
    QVERIFY(!title->text().isEmpty() && title->selectedText() == title->text());
    // What somebody typed stays when they choose another, and what is chosen is seen whatever the filter
    // says.
    type("new_study.title", QStringLiteral("Mine"));
    type("new_study.filter", QStringLiteral("friction"));
    QVERIFY(shown<QPushButton>("new_study.template.stiffness_2afc"));
    click("new_study.template.friction");
    QCOMPARE(title->text(), QStringLiteral("Mine"));
    QVERIFY(!shown<QPushButton>("new_study.template.stiffness_2afc"));
    click("new_study.cancel");
}

void TestStudyDesign::templatesAreFoundByWhatPeopleCallThem_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("found");
    const auto row = [](const char* typed, const char* found) {
        QTest::newRow(typed) << QString::fromUtf8(typed) << QString::fromUtf8(found);
    };
    row("2AFC", "stiffness_2afc");
    row("2-AFC", "stiffness_2afc");
    row("two-alternative forced choice", "stiffness_2afc");
    row("2AFC two conditions", "stiffness_2afc_two_tubes");
    row("2 conditions", "stiffness_2afc_two_tubes");
    row("two attributes", "stiffness_and_mass_2afc");
    row("weight", "mass");
    row("softness", "stiffness_elastic_tube");
    row("texture", "roughness");
    row("Watson", "stiffness_2afc");
    row("Stevens", "stiffness_magnitude");
    row("Fechner", "stiffness_adjustment");
}

void TestStudyDesign::templatesAreFoundByWhatPeopleCallThem() {
    QFETCH(QString, typed);
    QFETCH(QString, found);
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("new_study.template.new_rank3"), kPatience_ms);
    m_site->find<QLineEdit>(QStringLiteral("new_study.filter"))->setText(typed);
    QVERIFY(shown<QPushButton>(qPrintable(QStringLiteral("new_study.template.%1").arg(found))));
    QVERIFY(!shown<QPushButton>("new_study.template.apex")); // none of these words is about it
    click("new_study.cancel");
}

/// The words, and Enter; then only a name is wanted, and what keeps the button grey stands beside it.
void TestStudyDesign::twoConditionsInTwoActions() {
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("new_study.template.new_rank3"), kPatience_ms);
    const auto* accept = m_site->find<QPushButton>(QStringLiteral("new_study.accept"));
    const auto* why = m_site->find<QLabel>(QStringLiteral("new_study.why_not"));
    QVERIFY(!accept->isEnabled() && why && why->isVisible() && !why->text().isEmpty());
    m_actions = 0;
    type("new_study.filter", QStringLiteral("2afc two conditions"));
    enter("new_study.filter");
    QCOMPARE(m_actions, 2);
    auto* tile = m_site->find<QAbstractButton>(QStringLiteral("new_study.template.stiffness_2afc_two_tubes"));
    QVERIFY(tile->isChecked() && accept->isEnabled() && !why->isVisible());
    QVERIFY(tile->accessibleDescription().contains(QStringLiteral("Tube of 120 N/m")));
    click("new_study.accept");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QWidget>("design.ethics"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QCOMPARE(design().conditions.size(), std::size_t{2});
    QTRY_VERIFY2_WITH_TIMEOUT(inFocus("design.ethics"), "begins where something is needed", kPatience_ms);
    type("design.ethics", QStringLiteral("Ethics committee, 17/2026"));
    QVERIFY(saved());
    QTRY_VERIFY_WITH_TIMEOUT(text("study.missing").isEmpty(), kPatience_ms); // nothing else is needed
}

void TestStudyDesign::trialsAreCountedByCondition() {
    psychophysics::StudyDesign two = desktop::plainStudy(psychophysics::Task::twoAfc);
    two.id = "counted";
    two.trial.practiceTrials = 0;
    two.conditions.front().scale = psychophysics::ProcedureScale::difference;
    psychophysics::ProcedureSpec& first = two.conditions.front().procedures.front();
    const std::vector<double> table = two.conditions.front().stimulus.differences;
    first = psychophysics::ConstantSpec{{table[20], table[30]}, 6, true};
    two.conditions.push_back(two.conditions.front());
    two.conditions.back().id = "other";
    two.conditions.back().title = {{"en", "Other"}};
    two.conditions.back().procedures.push_back(two.conditions.back().procedures.front()); // interleaved
    openDraft(two, StudyScreen::conditionsTab);
    QCOMPARE(text("study.card.trials"), QStringLiteral("36 in all (by condition: 12, 24)"));
    click("conditions.1");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QLabel>("conditions.interleaved"), kPatience_ms);
    QVERIFY2(text("conditions.interleaved").contains(QStringLiteral("at most 24 trials")),
             qPrintable(text("conditions.interleaved")));
}

/// On every page stands what freezing still needs; the last one leads to it, and freezes when it is there.
void TestStudyDesign::whatIsMissingIsLedTo() {
    psychophysics::StudyDesign plain = desktop::plainStudy();
    plain.id = "led";
    openDraft(plain, StudyScreen::conditionsTab);
    QVERIFY2(text("study.missing").contains(QStringLiteral("Aim, Ethics")),
             qPrintable(text("study.missing")));
    QVERIFY(shown<QPushButton>("study.next")->text().contains(QStringLiteral("Trials")));
    const auto* page = m_site->window->screen()->findChild<desktop::ScrollPage*>();
    QVERIFY(page && !page->isAncestorOf(shown<QPushButton>("study.next"))); // nobody scrolls to it
    screen()->showTab(StudyScreen::checkTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("study.next")->text().contains(QStringLiteral("Aim")),
                             kPatience_ms);
    click("study.next");
    QTRY_VERIFY_WITH_TIMEOUT(inFocus("design.objective"), kPatience_ms);
    type("design.objective", QStringLiteral("Whether it works."));
    type("design.ethics", QStringLiteral("Not needed: the authors try it themselves."));
    QVERIFY(saved());
    screen()->showTab(StudyScreen::checkTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("study.next")->text().contains(QStringLiteral("Freeze")),
                             kPatience_ms);
    click("study.next");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("freeze")), kPatience_ms);
    const auto* accept = m_site->find<QPushButton>(QStringLiteral("freeze.accept"));
    const auto* list = m_site->find<QDialog>(QStringLiteral("freeze"))->findChild<desktop::CheckList*>();
    QTRY_VERIFY_WITH_TIMEOUT(!list->has(desktop::FreezeCheck::State::waiting), kPatience_ms);
    const auto* why = m_site->find<QLabel>(QStringLiteral("freeze.why_not"));
    QVERIFY(!accept->isEnabled() && why && why->isVisible());
    QVERIFY2(why->text().contains(QStringLiteral("Tick the box")), qPrintable(why->text()));
    QCOMPARE(accept->accessibleDescription(), why->text());
    click("freeze.seen");
    QVERIFY(accept->isEnabled() && !why->isVisible());
    click("freeze.cancel");
}

/// Also by somebody who clicks into the title, which has the focus already; the next click places the cursor.
void TestStudyDesign::aSuggestedTitleIsTypedOver() {
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QVERIFY(QTest::qWaitForWindowActive(m_site->find<QDialog>(QStringLiteral("new_study"))));
    click("new_study.template.new_2afc");
    auto* title = m_site->find<QLineEdit>(QStringLiteral("new_study.title"));
    auto* key = m_site->find<QLineEdit>(QStringLiteral("new_study.key"));
    QTRY_VERIFY_WITH_TIMEOUT(!title->visibleRegion().isEmpty(), kPatience_ms);
    const QPoint end(title->width() - 4, title->height() / 2);
    QTest::mouseClick(title, Qt::LeftButton, {}, end);
    QVERIFY(!title->text().isEmpty() && title->selectedText() == title->text());
    QTest::mouseClick(title, Qt::LeftButton, {}, end);
    QVERIFY(!title->hasSelectedText());
    key->setFocus(Qt::OtherFocusReason);
    QVERIFY(!key->text().isEmpty() && key->selectedText() == key->text());
    QTest::mouseClick(title, Qt::LeftButton, {}, end);
    QTest::keyClicks(title, QStringLiteral("Stiffness, two surfaces"));
    QCOMPARE(title->text(), QStringLiteral("Stiffness, two surfaces"));
    QTest::mouseClick(title, Qt::LeftButton, {}, end);
    QVERIFY(!title->hasSelectedText()); // it is no suggestion any more
    click("new_study.cancel");
}

/// On the tab that was clicked, on the page that came instead, or on the next screen; never in the side bar.
void TestStudyDesign::focusStaysWithThePage() {
    openDraft(tests::smallStudy("focus"));
    m_site->window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_site->window.get()));
    QTRY_VERIFY_WITH_TIMEOUT(shown<QWidget>("design.objective"), kPatience_ms);
    auto* bar = find<QTabBar>("study.tabs");
    shown<QWidget>("design.objective")->setFocus();
    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(StudyScreen::conditionsTab).center());
    QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), static_cast<QWidget*>(bar), kPatience_ms);
    bar->setCurrentIndex(StudyScreen::generalTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QWidget>("design.objective"), kPatience_ms);
    shown<QWidget>("design.objective")->setFocus();
    bar->setCurrentIndex(StudyScreen::trialsTab);
    const auto inThePage = [this] {
        const auto* page = screen()->findChild<desktop::RulesPage*>();
        const QWidget* at = QApplication::focusWidget();
        return page && at && at != page && page->isAncestorOf(at);
    };
    QTRY_VERIFY2_WITH_TIMEOUT(inThePage(),
                              qPrintable(QApplication::focusWidget()
                                             ? QApplication::focusWidget()->objectName()
                                             : QStringLiteral("nowhere")),
                              kPatience_ms);
    m_site->go(QStringLiteral("study_run"));
    QVERIFY(m_site->window->screen()->isAncestorOf(QApplication::focusWidget()));
}

/// Besides the complete templates; and whatever is clicked, the next thing to type is the title.
void TestStudyDesign::arrowKeysKeepTheTemplateInSight() {
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("new_study.template.new_rank3"), kPatience_ms);
    auto* tile = m_site->find<QAbstractButton>(QStringLiteral("new_study.template.apex"));
    auto* title = m_site->find<QLineEdit>(QStringLiteral("new_study.title"));
    tile->click();
    QTRY_VERIFY_WITH_TIMEOUT(!title->visibleRegion().isEmpty(), kPatience_ms); // a click leads to the title
    tile->setFocus(Qt::TabFocusReason);
    QTest::keyClick(tile, Qt::Key_Down);
    auto* next =
        qobject_cast<QAbstractButton*>(m_site->find<QDialog>(QStringLiteral("new_study"))->focusWidget());
    QVERIFY(next && next != tile && next->isChecked());
    QTest::qWait(100); // what choosing it has queued
    QVERIFY(!next->visibleRegion().isEmpty());
    click("new_study.cancel");
}

void TestStudyDesign::everyTaskHasABlankStart() {
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("new_study.template.new_2afc"), kPatience_ms);
    for (int task = 0; task < psychophysics::kTasks; ++task) {
        const std::string name = "new_study.template.new_" +
                                 std::string(psychophysics::token(static_cast<psychophysics::Task>(task)));
        QVERIFY2(shown<QPushButton>(name.c_str()), name.c_str());
    }
    auto* dialog = m_site->find<QDialog>(QStringLiteral("new_study"));
    auto* title = m_site->find<QLineEdit>(QStringLiteral("new_study.title"));
    for (const char* tile : {"new_study.template.friction", "new_study.template.new_2afc"}) {
        QTest::mouseClick(shown<QPushButton>(tile), Qt::LeftButton);
        QCOMPARE(dialog->focusWidget(), static_cast<QWidget*>(title));
        QVERIFY(!title->text().isEmpty() && title->selectedText() == title->text());
        QTRY_VERIFY_WITH_TIMEOUT(!title->visibleRegion().isEmpty(), kPatience_ms);
    }
    QTest::keyClicks(title, QStringLiteral("Two springs")); // over the suggestion
    QCOMPARE(title->text(), QStringLiteral("Two springs"));
    QCOMPARE(m_site->find<QLineEdit>(QStringLiteral("new_study.key"))->text(), QStringLiteral("two_springs"));
    click("new_study.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPlainTextEdit>(QStringLiteral("design.objective")), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QCOMPARE(design().conditions.size(), std::size_t{1});
    QVERIFY(design().conditions.front().task == psychophysics::Task::twoAfc);
    QVERIFY(design().source.empty()); // nobody's published design
}

/// Until somebody types another, and never one that another condition has.
void TestStudyDesign::shortNamesFollowTheirTitles() {
    psychophysics::StudyDesign study = tests::smallStudy("short_names");
    study.conditions.front().title["en"] = "Stiffness";
    openDraft(study, StudyScreen::conditionsTab);
    const auto id = [this](std::size_t at = 0) { return design().conditions.at(at).id; };
    QCOMPARE(id(), std::string("stiffness"));
    type("condition.title", QStringLiteral("Soft tube"));
    QCOMPARE(id(), std::string("soft_tube"));
    QCOMPARE(find<QLineEdit>("condition.id")->text(), QStringLiteral("soft_tube"));
    type("condition.title", {}); // typed anew
    type("condition.title", QStringLiteral("Mass"));
    QCOMPARE(id(), std::string("mass_2")); // the other condition's is taken
    QCOMPARE(id(1), std::string("mass"));
    type("condition.title", QStringLiteral("Tube of 300 N/m"));
    QCOMPARE(id(), std::string("tube_of_300_n_m"));
    type("condition.reference", QStringLiteral("450")); // changes the title, and with it the name
    QCOMPARE(design().conditions.front().title.at("en"), std::string("Tube of 450 N/m"));
    QCOMPARE(id(), std::string("tube_of_450_n_m"));
    QCOMPARE(find<QLineEdit>("condition.id")->text(), QStringLiteral("tube_of_450_n_m"));
    type("condition.id", QStringLiteral("tube"));
    type("condition.title", QStringLiteral("Tube of the left hand"));
    QCOMPARE(id(), std::string("tube"));
    click("conditions.1"); // also when somebody comes back to it
    QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), 1, kPatience_ms);
    click("conditions.0");
    QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), 0, kPatience_ms);
    type("condition.title", QStringLiteral("Tube of the right hand"));
    QCOMPARE(id(), std::string("tube"));
    QVERIFY(saved());
    m_site->go(QStringLiteral("studies"));
    reopen(StudyScreen::conditionsTab); // nobody remembers that it was typed
    type("condition.title", QStringLiteral("Tube of the other hand"));
    QCOMPARE(id(), std::string("tube"));
    QVERIFY(saved());
    psychophysics::StudyDesign apex = tests::apexStudy("short_apex", 10);
    apex.conditions.front().id = "sphere_20mm"; // a chosen name that tells the reference
    apex.conditions.front().stimulus.reference = 0.02;
    openDraft(apex, StudyScreen::conditionsTab);
    type("condition.reference", QStringLiteral("25"));
    QCOMPARE(id(), std::string("sphere_25mm"));
    QVERIFY(std::abs(design().conditions.front().stimulus.reference - 0.025) < 1e-12); // in metres
    QVERIFY(saved());
}

/// Without the lesser objects the table has a smallest difference again, which is shown and fits at once.
void TestStudyDesign::aTableOfOneSideHasASmallest() {
    psychophysics::StudyDesign study = tests::smallStudy("one_side");
    psychophysics::Condition& condition = study.conditions.front();
    condition.task = psychophysics::Task::twoAfc;
    condition.scale = psychophysics::ProcedureScale::difference;
    condition.stimulus.differences = desktop::differencesAround(0.6, 40);
    condition.procedures = {psychophysics::ConstantSpec{{condition.stimulus.differences.back()}, 10, true}};
    openDraft(study, StudyScreen::conditionsTab);
    QVERIFY(shown<QWidget>("differences.both") && !shown<QWidget>("differences.low"));
    click("differences.both");
    QTRY_VERIFY_WITH_TIMEOUT(shown<QWidget>("differences.low"), kPatience_ms);
    QVERIFY2(faultAt("differences.low").isEmpty(), qPrintable(faultAt("differences.low")));
    const auto& now = design().conditions.front().stimulus.differences;
    QVERIFY(std::abs(now.front() - std::log10(1.02)) < 1e-9 && now.front() < now.back()); // the usual one
    QVERIFY(std::abs(now.back() - std::log10(1.6)) < 1e-9); // the largest is kept
    step("trial.explore_limit");                            // nothing holds the page
}

/// At once, without a question; and a later change is not taken back in its place.
void TestStudyDesign::whatIsRemovedComesBack() {
    std::vector<desktop::Message> told;
    QObject hears; // no longer than what it writes to
    connect(&m_site->context.messages(), &desktop::Messages::told, &hears,
            [&told](const desktop::Message& message) { told.push_back(message); });
    openDraft(tests::smallStudy("removed"), StudyScreen::conditionsTab);
    click("conditions.remove");
    QCOMPARE(design().conditions.size(), std::size_t{1});
    QVERIFY(!told.empty() && told.back().text.contains(QStringLiteral("Stiffness of a tube")));
    QCOMPARE(told.back().actionText, QStringLiteral("Undo"));
    told.back().action();
    QCOMPARE(design().conditions.size(), std::size_t{2});
    QCOMPARE(design().conditions.front().id, std::string("stiffness"));
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("conditions.1"), kPatience_ms);
    click("conditions.1"); // the one that is shown is removed
    QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), 1, kPatience_ms);
    click("conditions.remove");
    QCOMPARE(design().conditions.size(), std::size_t{1});
    QCOMPARE(design().conditions.front().id, std::string("stiffness"));
    told.back().action();
    QCOMPARE(design().conditions.back().id, std::string("mass"));
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("conditions.1"), kPatience_ms);
    click("conditions.0");
    QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), 0, kPatience_ms);
    click("conditions.remove");
    QTRY_VERIFY_WITH_TIMEOUT(!shown<QPushButton>("conditions.1"), kPatience_ms);
    const auto undo = told.back().action;
    type("condition.reference", QStringLiteral("120"));
    const auto now = design().conditions;
    undo();
    QCOMPARE(design().conditions.size(), now.size());
    QCOMPARE(design().conditions.front().stimulus.reference, now.front().stimulus.reference);
    QVERIFY(told.back().text.contains(QStringLiteral("changed since")));
    // A question and a questionnaire likewise.
    screen()->showTab(StudyScreen::questionnairesTab);
    const std::size_t questions = design().questionnaires.front().items.size();
    click("item.0.1.remove");
    QCOMPARE(design().questionnaires.front().items.size(), questions - 1);
    told.back().action();
    QCOMPARE(design().questionnaires.front().items.size(), questions);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("questionnaire.0.remove"), kPatience_ms);
    click("questionnaire.0.remove");
    QVERIFY(design().questionnaires.empty());
    QVERIFY(told.back().text.contains(QStringLiteral("Face and content validity")));
    told.back().action();
    QCOMPARE(design().questionnaires.size(), std::size_t{1});
    QVERIFY(saved());
    // Whoever has left the study is told so.
    screen()->showTab(StudyScreen::questionnairesTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("questionnaire.0.remove"), kPatience_ms);
    click("questionnaire.0.remove");
    const auto late = told.back().action;
    QVERIFY(saved());
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QTabBar>(QStringLiteral("study.tabs")), kPatience_ms);
    late();
    QVERIFY(told.back().text.contains(QStringLiteral("left the study since then")));
}

/// The differences are spaced geometrically, and the text says so; ends that are the wrong way round are told
/// and make no table.
void TestStudyDesign::aTableSaysHowItIsSpaced() {
    openDraft(tests::smallStudy("spaced"), StudyScreen::conditionsTab);
    const auto differences = [this] { return design().conditions.front().stimulus.differences; };
    const std::vector<double> before = differences();
    QVERIFY2(text("differences.count.meaning").contains(QStringLiteral("geometrically")),
             qPrintable(text("differences.count.meaning")));
    type("differences.low", QStringLiteral("90")); // the largest is 74 %
    enter("differences.low");
    QVERIFY2(faultAt("differences.low").contains(QStringLiteral("below the largest")),
             qPrintable(faultAt("differences.low")));
    QCOMPARE(differences(), before);
    QCOMPARE(find<QTabBar>("study.tabs")->currentIndex(),
             int(StudyScreen::conditionsTab)); // not to be passed
    type("differences.low", QStringLiteral("5"));
    enter("differences.low");
    QVERIFY(std::abs(differences().front() - std::log10(1.05)) < 1e-9);
    const std::vector<double> now = differences();
    for (std::size_t i = 2; i < now.size(); ++i)
        QVERIFY(std::abs(now[i] / now[i - 1] - now[1] / now[0]) < 1e-9);
    QVERIFY(saved());
}

/// Whatever is outside is told where it was typed, with the range, and the design keeps what it had.
void TestStudyDesign::everyNumberSaysItsRange() {
    psychophysics::StudyDesign study = tests::smallStudy("ranges");
    psychophysics::Condition& condition = study.conditions.front();
    condition.task = psychophysics::Task::twoAfc;
    condition.procedures = {psychophysics::StaircaseSpec::kind().usual(condition)};
    openDraft(study, StudyScreen::conditionsTab);
    const auto down = [this] {
        return std::get<psychophysics::StaircaseSpec>(design().conditions.front().procedures.front()).down;
    };
    QTRY_VERIFY_WITH_TIMEOUT(find<QSpinBox>("procedure.0.down"), kPatience_ms);
    QVERIFY2(text("procedure.0.down.meaning").contains(QStringLiteral("1 to 100, usually 3")),
             qPrintable(text("procedure.0.down.meaning")));
    type("procedure.0.down", QStringLiteral("101"));
    enter("procedure.0.down");
    QVERIFY2(faultAt("procedure.0.down").contains(QStringLiteral("from 1 to 100")),
             qPrintable(faultAt("procedure.0.down")));
    QCOMPARE(down(), 3);
    type("procedure.0.down", QStringLiteral("12")); // no more than said is refused
    QCOMPARE(down(), 12);
    screen()->showTab(StudyScreen::trialsTab);
    const std::uint64_t seed = design().seed;
    type("design.seed", QStringLiteral("9007199254740993")); // one that a file cannot hold
    QVERIFY2(faultAt("design.seed").contains(QStringLiteral("9,007,199,254,740,991")),
             qPrintable(faultAt("design.seed")));
    QVERIFY(design().seed != 9007199254740993U);
    type("design.seed", QString::number(seed));
    QVERIFY(faultAt("design.seed").isEmpty());
    type("fidelity.stiffness_error", QStringLiteral("0")); // in per cent, as it is typed
    enter("fidelity.stiffness_error");
    QVERIFY2(faultAt("fidelity.stiffness_error").contains(QStringLiteral("0.1 to 1,000 %")),
             qPrintable(faultAt("fidelity.stiffness_error")));
    screen()->showTab(StudyScreen::questionnairesTab);
    type("item.0.1.highest", QStringLiteral("-5"));
    QTRY_VERIFY_WITH_TIMEOUT(faultAt("item.0.1.highest").contains(QStringLiteral("above the minimum")),
                             kPatience_ms);
}

void TestStudyDesign::namesThatAreTaken() {
    tests::addDraft(*m_site, m_site->context.actor(), tests::smallStudy("taken"));
    m_site->go(QStringLiteral("studies"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!m_site->find<QLineEdit>(QStringLiteral("new_study.title")), kPatience_ms);
    click("studies.new");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("new_study.template.new_rank3")),
                             kPatience_ms);
    click("new_study.template.new_rank3");
    type("new_study.key", QStringLiteral("taken"));
    QTRY_VERIFY_WITH_TIMEOUT(
        text("new_study.key.fault").contains(QStringLiteral("Another study has this key")), kPatience_ms);
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("new_study.accept"))->isEnabled());
    QVERIFY(!m_site->find<QLineEdit>(QStringLiteral("new_study.key"))->accessibleDescription().isEmpty());
    type("new_study.key", QStringLiteral("Soft Tubes"));
    QVERIFY(text("new_study.key.fault").contains(QStringLiteral("lower-case")));
    type("new_study.key", QStringLiteral("soft_tubes"));
    QVERIFY(m_site->find<QPushButton>(QStringLiteral("new_study.accept"))->isEnabled());
    click("new_study.cancel");
    // Two conditions of one name cannot be told apart in any table.
    openDraft(tests::smallStudy("twins"), StudyScreen::conditionsTab);
    const QString first = find<QLineEdit>("condition.title")->text();
    click("conditions.1");
    QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("condition.title")->text() != first, kPatience_ms);
    type("condition.title", first);
    QTRY_VERIFY_WITH_TIMEOUT(faultAt("condition.title").contains(QStringLiteral("same name")), kPatience_ms);
    click("study.next"); // not before it is put right
    QVERIFY(inFocus("condition.title"));
}

/// Beside every page, and after every change: also of what is changed on another page than the one that it
/// was first shown with.
void TestStudyDesign::theSummaryIsAlwaysTrue() {
    openDraft(tests::smallStudy("summary"), StudyScreen::conditionsTab);
    QVERIFY(text("study.card.conditions").contains(QStringLiteral("300 N/m")));
    type("condition.reference", QStringLiteral("450"));
    QVERIFY(text("study.card.conditions").contains(QStringLiteral("450 N/m")) &&
            !text("study.card.conditions").contains(QStringLiteral("300 N/m")));
    QVERIFY2(text("differences.summary").contains(QStringLiteral("458 N/m")),
             qPrintable(text("differences.summary"))); // of the table, too: 1.86 % more
    QVERIFY(text("study.state").contains(QStringLiteral("saving")) ||
            text("study.state").contains(QStringLiteral("saved")));
    screen()->showTab(StudyScreen::trialsTab);
    QCOMPARE(text("study.card.trials"), QStringLiteral("at most 40 in each condition, 80 in all"));
    QCOMPARE(text("study.card.feedback"), QStringLiteral("none"));
    type("trial.practice_trials", QStringLiteral("3"));
    QCOMPARE(text("study.card.trials"),
             QStringLiteral("at most 40 in each condition, 80 in all, and 6 for practice"));
    type("trial.explore_limit", QStringLiteral("45"));
    QVERIFY(text("study.card.time").contains(QStringLiteral("45 s to explore")));
    type("trial.break_every", QStringLiteral("10"));
    QVERIFY(text("study.card.breaks").contains(QStringLiteral("every 10 trials")));
    click("trial.feedback");
    QCOMPARE(text("study.card.feedback"), QStringLiteral("after each trial"));
    QCOMPARE(text("study.card.questions"), QStringLiteral("0 before, 4 after"));
    click("study.undo");
    QTRY_COMPARE_WITH_TIMEOUT(text("study.card.feedback"), QStringLiteral("in practice only"), kPatience_ms);
    // What is wrong is not said to be kept.
    screen()->showTab(StudyScreen::conditionsTab);
    type("condition.reference", QStringLiteral("0"));
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(QStringLiteral("not saved")), kPatience_ms);
    QVERIFY(!text("study.state").contains(QStringLiteral("all changes saved")));
}

void TestStudyDesign::instructionsFollowTheSettings() {
    psychophysics::StudyDesign study = tests::smallStudy("instructions");
    study.ownInstructions = psychophysics::StudyText{{"en", "Hold the grasper lightly."}};
    desktop::renewInstructions(study);
    openDraft(study, StudyScreen::trialsTab);
    const auto read = [&] { return QString::fromStdString(design().instructions.at("en")); };
    QVERIFY(read().startsWith(QStringLiteral("Hold the grasper lightly.")));
    QCOMPARE(text("design.instructions.shown"), read());
    QVERIFY2(text("design.instructions.limits").contains(QStringLiteral("more than 4\u00a0N")),
             qPrintable(text("design.instructions.limits"))); // read before each part, and not frozen
    type("fidelity.peak_force", QStringLiteral("3"));
    QVERIFY2(text("design.instructions.limits").contains(QStringLiteral("more than 3\u00a0N")),
             qPrintable(text("design.instructions.limits")));
    type("fidelity.peak_force", QStringLiteral("4"));
    QVERIFY(read().contains(QStringLiteral("You have 30 seconds to explore")) &&
            read().contains(QStringLiteral("another 20 seconds to answer")));
    type("trial.explore_limit", QStringLiteral("0"));
    QVERIFY(read().contains(QStringLiteral("as long as you like")) &&
            !read().contains(QStringLiteral("seconds to")));
    QVERIFY(!find<QWidget>("trial.answer_limit")->isVisible()); // without an end of exploring it never starts
    type("trial.explore_limit", QStringLiteral("12"));
    QVERIFY(read().contains(QStringLiteral("You have 12 seconds to explore")) &&
            !read().contains(QStringLiteral("as long as you like over")));
    QVERIFY(read().contains(QStringLiteral("You are not told whether your answers are right.")));
    click("trial.feedback");
    QVERIFY(read().contains(QStringLiteral("After each trial you are told whether your answer was right.")));
    QVERIFY(read().contains(QStringLiteral("Each part has at most 40 trials.")));
    QVERIFY(read().contains(QStringLiteral("No breaks are planned")));
    type("trial.break_every", QStringLiteral("20"));
    QVERIFY(read().contains(QStringLiteral("After every 20 trials there is a break of at least 30 seconds")));
    type("trial.practice_trials", QStringLiteral("1"));
    QVERIFY(read().contains(QStringLiteral("Each part begins with 1 practice trial, which does not count.")));
    type("design.instructions", QStringLiteral("Rest your arm."));
    QVERIFY(read().startsWith(QStringLiteral("Rest your arm.")) &&
            !read().contains(QStringLiteral("Hold the grasper")));
    QCOMPARE(text("design.instructions.shown"), read());
    QVERIFY(saved());
    // A draft that holds a sentence of an earlier version is stored anew once it is opened.
    psychophysics::StudyDesign noisy = study;
    noisy.id = "noisy";
    noisy.instructions["en"] += " During the trials you hear a steady noise.";
    openDraft(noisy, StudyScreen::trialsTab);
    QCOMPARE(design().instructions, study.instructions);
    QVERIFY(saved());
    {
        auto connection = m_site->database().openReader();
        const auto stored = database::StudyReader(**connection, m_site->context.actor()).study(m_study);
        QVERIFY(stored && stored->designJson.find("steady noise") == std::string::npos);
    }
    // A study that was written before keeps every word, and says what to do.
    psychophysics::StudyDesign older = tests::smallStudy("older");
    older.ownInstructions.reset();
    openDraft(older, StudyScreen::trialsTab);
    QCOMPARE(find<QPlainTextEdit>("design.instructions")->toPlainText(),
             QString::fromStdString(older.instructions.at("en")));
    QCOMPARE(design().instructions, older.instructions); // not changed by looking at it
}

/// The same numbers in every language; other tasks, other sentences.
void TestStudyDesign::instructionsInThreeLanguages() {
    psychophysics::StudyDesign study = tests::smallStudy("languages");
    study.trial.practiceTrials = 7;
    study.trial.breakEvery = 13;
    study.trial.exploreLimit_s = 41;
    for (const char* language : tests::languageIds()) {
        const QString words =
            desktop::participantSentences(study, QLatin1String(language)).join(QLatin1Char(' '));
        for (const char* number : {"7", "13", "41", "40", "30", "20"})
            QVERIFY2(words.contains(QLatin1String(number)), qPrintable(words));
        QVERIFY2(!words.contains(QLatin1Char('%')), qPrintable(words));
    }
    for (const char* language : tests::otherLanguages())
        QVERIFY2(desktop::participantSentences(study, QLatin1String(language)) !=
                     desktop::participantSentences(study, QStringLiteral("en")),
                 language);
    for (psychophysics::Condition& condition : study.conditions)
        condition.task = psychophysics::Task::twoAfc;
    QVERIFY(desktop::participantSentences(study, QStringLiteral("en"))
                .join(QLatin1Char(' '))
                .contains(QStringLiteral("one of two answers")));
    const QString apex = desktop::participantSentences(tests::apexStudy("apex", 10), QStringLiteral("en"))
                             .join(QLatin1Char(' '));
    QVERIFY2(apex.contains(QStringLiteral("There are 10 trials.")) &&
                 apex.contains(QStringLiteral("highest point")) &&
                 !apex.contains(QStringLiteral("to answer")),
             qPrintable(apex));
    // The time of a study with both: the objects of a comparison go away, and a search ends.
    psychophysics::StudyDesign both = tests::smallStudy("both");
    both.trial.exploreLimit_s = 41;
    both.conditions.push_back(tests::apexStudy("apex", 10).conditions.front());
    const QString mixed = desktop::participantSentences(both, QStringLiteral("en")).join(QLatin1Char(' '));
    QVERIFY2(mixed.contains(QStringLiteral("Then the objects go away")) &&
                 mixed.contains(QStringLiteral("the trial ends after these 41 seconds")),
             qPrintable(mixed));
    // An object alone is compared with a reference that no trial presents: it is said where that comes from.
    for (psychophysics::Condition& condition : study.conditions)
        condition.task = psychophysics::Task::yesNo;
    const QString alone = desktop::participantSentences(study, QStringLiteral("en")).join(QLatin1Char(' '));
    QVERIFY2(alone.contains(QStringLiteral("the reference, which the experimenter shows you")),
             qPrintable(alone));
    // In the languages that the researcher wrote in; in all where nothing was written.
    study.ownInstructions = psychophysics::StudyText{{"en", "One."}, {"de", "Eins."}};
    desktop::renewInstructions(study);
    QVERIFY(study.instructions.contains("de") && !study.instructions.contains("el"));
    study.ownInstructions = psychophysics::StudyText{};
    desktop::renewInstructions(study);
    QCOMPARE(study.instructions.size(), std::size_t{3});
}

void TestStudyDesign::everyFieldSaysWhatItMeans() {
    for (int task = 0; task < psychophysics::kTasks; ++task) {
        psychophysics::StudyDesign study = tests::smallStudy("meaning_" + std::to_string(task));
        desktop::takeTask(study.conditions.front(), static_cast<psychophysics::Task>(task));
        openDraft(study);
        for (const int tab : {StudyScreen::generalTab, StudyScreen::conditionsTab, StudyScreen::trialsTab,
                              StudyScreen::previewTab}) {
            screen()->showTab(tab);
            for (const desktop::FieldGrid* grid : screen()->findChildren<desktop::FieldGrid*>())
                for (const QWidget* field : grid->findChildren<QWidget*>()) {
                    if (!grid->hasField(field->objectName()) ||
                        field->objectName().startsWith(QStringLiteral("procedure.0.kind")))
                        continue; // a procedure's kind has its sentence beside it
                    QVERIFY2(!field->accessibleName().isEmpty() && !field->accessibleDescription().isEmpty(),
                             qPrintable(field->objectName()));
                    QVERIFY2(grid->findChild<QLabel*>(field->objectName() + QStringLiteral(".meaning")),
                             qPrintable(field->objectName()));
                    QVERIFY2(!field->accessibleName().contains(QStringLiteral("log10")),
                             qPrintable(field->accessibleName()));
                }
        }
    }
}

void TestStudyDesign::onlyWhatAppliesIsThere() {
    psychophysics::StudyDesign apex = tests::apexStudy("apex_fields", 10);
    openDraft(apex, StudyScreen::conditionsTab);
    for (const char* name : {"condition.task", "condition.criterion", "condition.scale", "differences.levels",
                             "procedure.0.kind", "conditions.more_procedures"})
        QVERIFY2(!find<QWidget>(name), name);
    QVERIFY(find<QWidget>("condition.reference") && find<QSpinBox>("procedure.0.repeats"));
    type("procedure.0.repeats", QStringLiteral("24"));
    QCOMPARE(text("study.card.trials"), QStringLiteral("24"));
    screen()->showTab(StudyScreen::trialsTab);
    QVERIFY(!find<QWidget>("trial.answer_limit") && !find<QWidget>("trial.must_touch_all") &&
            !find<QWidget>("design.order"));
    screen()->showTab(StudyScreen::previewTab);
    QVERIFY(!find<QWidget>("preview.weber") &&
            !find<QWidget>("preview.lapse")); // nobody's Weber fraction finds an apex
    click("preview.start");
    QTRY_VERIFY_WITH_TIMEOUT(find<QFrame>("preview.result"), kPatience_ms);
    QString said;
    for (const QLabel* label : find<QFrame>("preview.result")->findChildren<QLabel*>())
        said += label->text() + QLatin1Char('\n');
    QVERIFY2(said.contains(QStringLiteral("3.56 mm")) && said.contains(QStringLiteral("24")),
             qPrintable(said));
    // Another attribute brings a task and a table back; of a function of QUEST+ there is a choice, of levels
    // per cents.
    screen()->showTab(StudyScreen::conditionsTab);
    auto* attribute = find<QComboBox>("condition.attribute");
    attribute->setCurrentIndex(static_cast<int>(psychophysics::Attribute::mass));
    emit attribute->activated(attribute->currentIndex());
    QTRY_VERIFY_WITH_TIMEOUT(find<QComboBox>("condition.task"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QWidget>("differences.low"), kPatience_ms);
    QVERIFY(!shown<QCheckBox>("differences.both")); // a ranking has no lesser objects
    auto* task = find<QComboBox>("condition.task");
    task->setCurrentIndex(task->findData(static_cast<int>(psychophysics::Task::twoAfc)));
    emit task->activated(task->currentIndex());
    QTRY_VERIFY_WITH_TIMEOUT(find<QComboBox>("procedure.0.function"), kPatience_ms);
    QVERIFY(!shown<QCheckBox>("differences.both")); // nor has a logarithm
    auto* scale = find<QComboBox>("condition.scale");
    const int logarithm = scale->currentIndex();
    scale->setCurrentIndex(1 - logarithm);
    emit scale->activated(scale->currentIndex());
    QTRY_VERIFY_WITH_TIMEOUT(shown<QCheckBox>("differences.both"), kPatience_ms);
    scale = shown<QComboBox>("condition.scale");
    scale->setCurrentIndex(logarithm);
    emit scale->activated(logarithm);
    QTRY_VERIFY_WITH_TIMEOUT(!shown<QCheckBox>("differences.both"), kPatience_ms);
    QVERIFY(find<QComboBox>("procedure.0.function")->count() >= 4);
    QCOMPARE(find<QDoubleSpinBox>("procedure.0.grid0.low")->suffix(), QStringLiteral(" %"));
    const auto& plus = std::get<psychophysics::QuestPlusSpec>(design().conditions.front().procedures.front());
    QVERIFY(std::abs(find<QDoubleSpinBox>("procedure.0.grid0.low")->value() - 2.0) <
            0.01); // the table's smallest
    type("procedure.0.grid0.low", QStringLiteral("3"));
    QCOMPARE(plus.parameters.front().values.size(), std::size_t{41});
    QVERIFY(std::abs(plus.parameters.front().values.front() - std::log10(std::log10(1.03))) < 1e-6);
    auto* function = find<QComboBox>("procedure.0.function");
    function->setCurrentIndex(function->findData(QStringLiteral("norm_cdf")));
    emit function->activated(function->currentIndex());
    QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(std::get<psychophysics::QuestPlusSpec>(
                                                         design().conditions.front().procedures.front())
                                                         .parameters.front()
                                                         .name),
                              QStringLiteral("mean"), kPatience_ms);
    QVERIFY2(saved(), qPrintable(text("study.faults"))); // with parameters that it has
}

/// A list of steps that somebody types is the list that is stored, in its order.
void TestStudyDesign::stepsOfAStaircase() {
    psychophysics::StudyDesign study = tests::smallStudy("steps");
    psychophysics::Condition& condition = study.conditions.front();
    condition.task = psychophysics::Task::twoAfc;
    condition.procedures = {psychophysics::StaircaseSpec::kind().usual(condition)};
    openDraft(study, StudyScreen::conditionsTab);
    const auto steps = [this] {
        return std::get<psychophysics::StaircaseSpec>(design().conditions.front().procedures.front()).stepsUp;
    };
    const std::vector<double> before = steps();
    QTRY_VERIFY_WITH_TIMEOUT(find<QLineEdit>("procedure.0.steps_up"), kPatience_ms);
    type("procedure.0.steps_up", QStringLiteral("5; 3; 2"));
    QCOMPARE(steps().size(), std::size_t{3});
    QVERIFY(steps() != before && steps()[0] > steps()[1] && steps()[1] > steps()[2] && steps()[2] > 0.0);
}

void TestStudyDesign::faultsStandAtTheirFields() {
    openDraft(tests::smallStudy("faults"));
    const auto wrong = [&](const char* field, const QString& words, const char* expected) {
        type(field, words);
        QTRY_VERIFY2_WITH_TIMEOUT(
            faultAt(field).contains(QLatin1String(expected)),
            qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(field), faultAt(field))), kPatience_ms);
        auto* widget = find<QWidget>(field);
        QVERIFY2(widget->accessibleDescription().contains(QLatin1String(expected)), field); // heard, too
        QVERIFY(!find<QWidget>((QByteArray(field) + ".fault").constData())
                     ->findChildren<QLabel*>()
                     .front()
                     ->pixmap(Qt::ReturnByValue)
                     .isNull()); // a sign
        find<QWidget>("study.next")->setFocus();
        click("study.next");
        QVERIFY2(inFocus(field), field); // and not the next page
    };
    const auto right = [&](const char* field, const QString& words) {
        type(field, words);
        QTRY_VERIFY2_WITH_TIMEOUT(
            faultAt(field).isEmpty(),
            qPrintable(
                QStringLiteral("%1: %2, %3").arg(QLatin1String(field), faultAt(field), text("study.state"))),
            kPatience_ms);
    };
    wrong("design.title", {}, "empty");
    right("design.title", QStringLiteral("Tubes"));
    wrong("design.objective", {}, "empty");
    right("design.objective", QStringLiteral("To see."));
    wrong("design.planned", QStringLiteral("0"), "At least one participant");
    QTRY_VERIFY_WITH_TIMEOUT(text("study.state").contains(QStringLiteral("not saved")), kPatience_ms);
    right("design.planned", QStringLiteral("8"));
    screen()->showTab(StudyScreen::conditionsTab);
    wrong("condition.reference", QStringLiteral("30000"),
          "1.00 N/m to 20,000 N/m"); // above all that can be rendered
    right("condition.reference", QStringLiteral("300"));
    wrong("condition.id", QStringLiteral("Two Words"), "lower-case");
    wrong("condition.id", QStringLiteral("mass"), "already used"); // by the other condition
    right("condition.id", QStringLiteral("tube"));
    // From another page the button above all of them leads to the first.
    screen()->draft().change(
        {}, {}, [](psychophysics::StudyDesign& study) { study.conditions[1].stimulus.reference = -1.0; });
    screen()->showTab(StudyScreen::generalTab);
    QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("study.to_fault")->isVisible(), kPatience_ms);
    QVERIFY(!find<QTabBar>("study.tabs")->tabIcon(StudyScreen::conditionsTab).isNull());
    click("study.to_fault");
    QTRY_VERIFY_WITH_TIMEOUT(find<QDoubleSpinBox>("condition.reference") && inFocus("condition.reference"),
                             kPatience_ms);
    QCOMPARE(find<QTabBar>("study.tabs")->currentIndex(), int(StudyScreen::conditionsTab));
    click("study.undo");
    QVERIFY(saved());
}

/// No empty strip is kept below the names of the pages, and nothing of a page moves when a fault is told.
void TestStudyDesign::whatIsWrongTakesNoRoomBefore() {
    openDraft(tests::smallStudy("no_strip"), StudyScreen::conditionsTab);
    const auto top = [this](const QWidget* part) { return part->mapTo(screen(), QPoint()).y(); };
    const auto* tabs = find<QTabBar>("study.tabs");
    const auto* page = screen()->findChild<desktop::ConditionsPage*>();
    const auto* button = find<QPushButton>("conditions.copy");
    QTRY_VERIFY_WITH_TIMEOUT(button->isVisible() && button->width() > 0, kPatience_ms);
    QCoreApplication::processEvents();
    const int strip_px = top(page) - top(tabs) - tabs->height();
    QVERIFY2(strip_px >= 0 && strip_px < tabs->height() / 2, qPrintable(QString::number(strip_px)));
    const int before = top(button);
    screen()->draft().change(
        {}, {}, [](psychophysics::StudyDesign& study) { study.conditions[1].stimulus.reference = -1.0; });
    QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("study.to_fault")->isVisible(), kPatience_ms);
    QVERIFY(find<QWidget>("study.faults")->isVisible() &&
            !find<QWidget>("study.faults")->accessibleName().isEmpty());
    QCoreApplication::processEvents();
    QCOMPARE(top(find<QPushButton>("conditions.copy")), before);
    click("study.undo");
    QVERIFY(saved());
}

/// People look for the number of trials there, and each line leads to the field of its condition.
void TestStudyDesign::theLengthOfARunIsFoundUnderTrials() {
    psychophysics::StudyDesign study = tests::smallStudy("length");
    std::get<psychophysics::Rank3Spec>(study.conditions[0].procedures[0]).stop.trials = 31;
    openDraft(study, StudyScreen::trialsTab);
    const auto line = [this](int at) {
        return find<QLabel>(qPrintable(QStringLiteral("length.%1").arg(at)))->text();
    };
    QVERIFY2(line(0).contains(QStringLiteral("at most 31 trials")), qPrintable(line(0)));
    QCOMPARE(screen()->findChildren<QLabel*>(QRegularExpression(QStringLiteral("^length\\.\\d+$"))).size(),
             qsizetype(study.conditions.size()));
    screen()->draft().change({}, {}, [](psychophysics::StudyDesign& changed) {
        std::get<psychophysics::Rank3Spec>(changed.conditions[0].procedures[0]).stop.trials = 44;
    });
    QTRY_VERIFY_WITH_TIMEOUT(line(0).contains(QStringLiteral("at most 44 trials")), kPatience_ms);
    for (const int at : {1, 0}) {
        screen()->showTab(StudyScreen::trialsTab);
        QCoreApplication::processEvents();
        click(qPrintable(QStringLiteral("length.change.%1").arg(at)));
        QTRY_COMPARE_WITH_TIMEOUT(find<QTabBar>("study.tabs")->currentIndex(),
                                  int(StudyScreen::conditionsTab), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), at, kPatience_ms);
        const auto focused = [this] {
            const QWidget* focus = m_site->window->focusWidget();
            return focus ? focus->objectName() : QString();
        };
        QTRY_VERIFY_WITH_TIMEOUT(focused().startsWith(QStringLiteral("procedure.0.")), kPatience_ms);
    }
    QVERIFY(inFocus("procedure.0.trials"));
    QVERIFY(saved());
}

/// Once the reference of a copied condition differs, both names tell it, in each language; a name that
/// somebody typed stays.
void TestStudyDesign::aCopySaysInWhatItDiffers() {
    const auto titled = [this](const char* words) { // the page is made anew for another condition
        const auto* title = shown<QLineEdit>("condition.title");
        return title && title->text() == QLatin1String(words);
    };
    psychophysics::StudyDesign study = tests::smallStudy("mass_names");
    study.conditions.resize(1);
    psychophysics::Condition& mass = study.conditions.front();
    mass.id = "mass";
    mass.title = {{"en", "Mass"}, {"de", "Masse"}};
    mass.stimulus.attribute = psychophysics::Attribute::mass;
    mass.stimulus.reference = 0.05;
    openDraft(study, StudyScreen::conditionsTab);
    click("conditions.copy");
    QTRY_COMPARE_WITH_TIMEOUT(design().conditions.size(), std::size_t{2}, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(titled("Mass (2)"), kPatience_ms);
    type("condition.reference", QStringLiteral("100"));
    QCOMPARE(design().conditions[1].stimulus.reference, 0.1);
    QCOMPARE(design().conditions[1].title.at("en"), std::string("Mass, 100 g"));
    QCOMPARE(design().conditions[1].title.at("de"), std::string("Masse, 100 g"));
    QCOMPARE(design().conditions[0].title.at("en"), std::string("Mass, 50 g"));
    QCOMPARE(design().conditions[0].title.at("de"), std::string("Masse, 50 g"));
    QCOMPARE(design().conditions[1].id, std::string("mass_100_g"));
    QTRY_VERIFY_WITH_TIMEOUT(titled("Mass, 100 g"), kPatience_ms);
    type("condition.reference", QStringLiteral("120")); // and follows it from then on
    QCOMPARE(design().conditions[1].title.at("en"), std::string("Mass, 120 g"));
    click("study.undo");
    QVERIFY(saved());
    psychophysics::StudyDesign typed = tests::smallStudy("mass_names_typed");
    typed.conditions = study.conditions;
    openDraft(typed, StudyScreen::conditionsTab);
    type("condition.title", QStringLiteral("Weights"));
    click("conditions.copy");
    QTRY_COMPARE_WITH_TIMEOUT(design().conditions.size(), std::size_t{2}, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(titled("Weights (2)"), kPatience_ms);
    type("condition.reference", QStringLiteral("100"));
    QCOMPARE(design().conditions[0].title.at("en"), std::string("Weights"));
    QCOMPARE(design().conditions[1].title.at("en"), std::string("Weights, 100 g"));
    QVERIFY(saved());
}

/// On the page that is open already, the first condition is found from the second.
void TestStudyDesign::aFaultOfAnotherConditionIsShown() {
    openDraft(tests::smallStudy("first_wrong"), StudyScreen::conditionsTab);
    const auto condition = [this] { return screen()->findChild<desktop::ConditionsPage*>()->shown(); };
    click("conditions.1");
    QTRY_COMPARE_WITH_TIMEOUT(condition(), 1, kPatience_ms);
    screen()->draft().change(
        {}, {}, [](psychophysics::StudyDesign& study) { study.conditions[0].stimulus.reference = -1.0; });
    QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("study.to_fault")->isVisible(), kPatience_ms);
    click("study.to_fault");
    QTRY_COMPARE_WITH_TIMEOUT(condition(), 0, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(inFocus("condition.reference"), kPatience_ms);
    click("study.undo");
    QVERIFY(saved());
}

/// Nobody has to wait until it is noticed.
void TestStudyDesign::whatWasJustMadeWrongIsNotFrozen() {
    openDraft(tests::smallStudy("just_wrong"), StudyScreen::checkTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QAbstractButton>("check.freeze"), kPatience_ms);
    screen()->draft().change(
        {}, {}, [](psychophysics::StudyDesign& study) { study.conditions[1].stimulus.reference = -1.0; });
    shown<QAbstractButton>("check.freeze")->click();
    QVERIFY(!m_site->find<QDialog>(QStringLiteral("freeze")));
    QTRY_COMPARE_WITH_TIMEOUT(find<QTabBar>("study.tabs")->currentIndex(), int(StudyScreen::conditionsTab),
                              kPatience_ms);
    click("study.undo");
    QVERIFY(saved());
}

/// What a name would become may be another condition's already, whichever of them comes first.
void TestStudyDesign::aReferenceTakesNobodysName() {
    psychophysics::StudyDesign study = tests::smallStudy("references");
    study.conditions[1] = study.conditions[0];
    study.conditions[0].title["en"] = "Tube of 450 N/m";
    study.conditions[0].id = "tube_450";
    study.conditions[0].stimulus.reference = 450.0;
    study.conditions[1].title["en"] = "Tube of 300 N/m (2)";
    study.conditions[1].id = "tube_300_2";
    openDraft(study, StudyScreen::conditionsTab);
    click("conditions.1");
    QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), 1, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QDoubleSpinBox>("condition.reference"), kPatience_ms);
    shown<QDoubleSpinBox>("condition.reference")->setValue(450.0); // at once
    QCOMPARE(design().conditions[1].title.at("en"), std::string("Tube of 450 N/m (2)"));
    QCOMPARE(design().conditions[1].id, std::string("tube_450_2"));
    QVERIFY(saved());
    study = tests::smallStudy("named_alike");
    study.conditions[0].title["en"] = "Stiffness";
    study.conditions[1].title["en"] = "Mass";
    openDraft(study, StudyScreen::conditionsTab);
    click("conditions.1");
    QTRY_COMPARE_WITH_TIMEOUT(screen()->findChild<desktop::ConditionsPage*>()->shown(), 1, kPatience_ms);
    type("condition.title", QStringLiteral("Stiffness"));
    QCOMPARE(design().conditions[1].id, std::string("stiffness_2"));
    type("condition.title", QStringLiteral("Mass"));
    QVERIFY(saved());
}

/// 41 numbers from a German table; one that is none; one that would be less than nothing.
void TestStudyDesign::aTableOfNumbersIsPasted() {
    psychophysics::StudyDesign study = tests::smallStudy("pasted");
    openDraft(study, StudyScreen::conditionsTab);
    QStringList lines;
    for (int i = 0; i < 41; ++i)
        lines << QString::number(2.0 + 0.25 * i, 'f', 2).replace(QLatin1Char('.'), QLatin1Char(','));
    QGuiApplication::clipboard()->setText(lines.join(QStringLiteral("\r\n")));
    click("differences.levels.paste");
    QTRY_COMPARE_WITH_TIMEOUT(design().conditions.front().stimulus.differences.size(), std::size_t{41},
                              kPatience_ms);
    QVERIFY(std::abs(design().conditions.front().stimulus.differences.front() - std::log10(1.02)) < 1e-9);
    QVERIFY(std::abs(design().conditions.front().stimulus.differences.back() - std::log10(1.12)) < 1e-9);
    QTRY_COMPARE_WITH_TIMEOUT(
        m_site->find<QTableWidget>(QStringLiteral("differences.levels.table"))->rowCount(), 41, kPatience_ms);
    QVERIFY(saved());
    QGuiApplication::clipboard()->setText(QStringLiteral("2; 3; many; 5"));
    click("differences.levels.paste");
    QVERIFY(faultAt("differences.levels").contains(QStringLiteral("many")));
    QCOMPARE(design().conditions.front().stimulus.differences.size(),
             std::size_t{41}); // nothing of it is taken
    QGuiApplication::clipboard()->setText(QStringLiteral("-120\n5"));
    click("differences.levels.paste");
    QVERIFY2(faultAt("differences.levels").contains(QStringLiteral("below zero")) &&
                 faultAt("differences.levels").contains(QStringLiteral("120 %")) &&
                 !faultAt("differences.levels").contains(QStringLiteral("-120")),
             qPrintable(faultAt("differences.levels")));
    QGuiApplication::clipboard()->setText(
        QStringLiteral("-50; -20; -10")); // the reference above all of them: no ranking has a least one
    click("differences.levels.paste");
    QTRY_VERIFY_WITH_TIMEOUT(faultAt("differences.levels").contains(QStringLiteral("above the reference")),
                             kPatience_ms);
    QGuiApplication::clipboard()->setText(QStringLiteral("5; 9000")); // beyond what can be rendered
    click("differences.levels.paste");
    QTRY_VERIFY_WITH_TIMEOUT(faultAt("differences.levels").contains(QStringLiteral("can be rendered")),
                             kPatience_ms);
    QGuiApplication::clipboard()->setText(QStringLiteral("5 10 20 40"));
    click("differences.levels.paste");
    QTRY_VERIFY_WITH_TIMEOUT(faultAt("differences.levels").isEmpty(), kPatience_ms);
    QVERIFY(saved());
    // A level of constant stimuli that the table has not.
    screen()->draft().change(
        {}, {},
        [](psychophysics::StudyDesign& changed) {
            changed.conditions.front().procedures = {psychophysics::ConstantSpec{{0.05, 0.9}, 10, true}};
        },
        true);
    QTRY_VERIFY_WITH_TIMEOUT(faultAt("procedure.0.levels").contains(QStringLiteral("outside the table")),
                             kPatience_ms);
}

void TestStudyDesign::numbersAreReadAsTheyWereMeant() {
    const QLocale german(QLocale::German), english(QLocale::English, QLocale::UnitedKingdom);
    using Values = std::vector<double>;
    for (const QLocale& locale :
         {german, english}) { // a table copied from a colleague's program has the colleague's commas
        QCOMPARE(desktop::readNumbers(QStringLiteral("0,5; 1; 2,25"), locale).values,
                 (Values{0.5, 1.0, 2.25}));
        QCOMPARE(desktop::readNumbers(QStringLiteral("0.5\t1\n2.25"), locale).values,
                 (Values{0.5, 1.0, 2.25}));
        QCOMPARE(desktop::readNumbers(QStringLiteral("0.5, 1, 2.25"), locale).values,
                 (Values{0.5, 1.0, 2.25}));
        QCOMPARE(desktop::readNumbers(QStringLiteral("0.5,1,2.25"), locale).values, (Values{0.5, 1.0, 2.25}));
        QCOMPARE(desktop::readNumbers(QStringLiteral("5 % 10 %"), locale).values, (Values{5.0, 10.0}));
        QCOMPARE(desktop::readNumbers(QStringLiteral("\u2212"
                                                     "3; 4"),
                                      locale)
                     .values,
                 (Values{-3.0, 4.0}));
        QCOMPARE(desktop::readNumbers(QStringLiteral("0,5,1,5"), locale).unread,
                 QStringLiteral("0,5,1,5")); // two numbers or four
        QCOMPARE(desktop::readNumbers(QStringLiteral("1; x; 2"), locale).unread, QStringLiteral("x"));
        QVERIFY(desktop::readNumbers(QString(), locale).values.empty());
    }
    QCOMPARE(desktop::readNumbers(QStringLiteral("0,5"), german).values, Values{0.5});
    QCOMPARE(desktop::readNumbers(QStringLiteral("5,10"), english).values, (Values{5.0, 10.0}));
}

/// What was typed and not taken is not left behind without a word: Next goes to it, and on from there.
/// What is different in a condition is asked for once there are two; it stays with the one, and an emptied
/// field is no text.
void TestStudyDesign::aConditionHasItsOwnInstructions() {
    psychophysics::StudyDesign one = tests::smallStudy("glove");
    one.conditions.resize(1);
    openDraft(one, StudyScreen::conditionsTab);
    QVERIFY(find<QWidget>("condition.title") && !find<QPlainTextEdit>("condition.instructions"));
    QVERIFY(!find<QPushButton>("conditions.remove")->isEnabled()); // a study has at least one
    click("conditions.copy");
    QTRY_COMPARE_WITH_TIMEOUT(design().conditions.size(), std::size_t{2}, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(find<QPlainTextEdit>("condition.instructions"), kPatience_ms);
    const int shown = screen()->findChild<desktop::ConditionsPage*>()->shown();
    const auto own = [&](int at) {
        return design().conditions.at(static_cast<std::size_t>(at)).instructions;
    };
    find<QPlainTextEdit>("condition.instructions")
        ->setPlainText(QStringLiteral("Put on the glove. There are four objects."));
    QTRY_COMPARE_WITH_TIMEOUT(own(shown),
                              (psychophysics::StudyText{{"en", "Put on the glove. There are four objects."}}),
                              kPatience_ms);
    QVERIFY(own(1 - shown).empty());
    QVERIFY2(text("condition.instructions.claims").contains(QStringLiteral("four objects")),
             qPrintable(text("condition.instructions.claims")));
    find<QPlainTextEdit>("condition.instructions")->setPlainText(QStringLiteral("Put on the glove."));
    QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("condition.instructions.claims")->isHidden(), kPatience_ms);
    click("conditions.copy");
    QTRY_COMPARE_WITH_TIMEOUT(design().conditions.size(), std::size_t{3}, kPatience_ms);
    QVERIFY(own(2).empty() && !own(shown).empty());
    click(qPrintable(QStringLiteral("conditions.%1").arg(shown)));
    QTRY_VERIFY_WITH_TIMEOUT(find<QPlainTextEdit>("condition.instructions") &&
                                 find<QPlainTextEdit>("condition.instructions")->toPlainText() ==
                                     QLatin1String("Put on the glove."),
                             kPatience_ms);
    find<QPlainTextEdit>("condition.instructions")->setPlainText({});
    QTRY_VERIFY_WITH_TIMEOUT(own(shown).empty(), kPatience_ms);
    QVERIFY(saved());
}

void TestStudyDesign::anUnreadNumberKeepsItsPage() {
    openDraft(tests::smallStudy("unread"), StudyScreen::conditionsTab);
    const double before = design().conditions.front().stimulus.reference;
    type("condition.reference", QStringLiteral("0.5 kg"));
    enter("condition.reference");
    QVERIFY2(faultAt("condition.reference").contains(QStringLiteral("0.5 kg")),
             qPrintable(faultAt("condition.reference")));
    QCOMPARE(design().conditions.front().stimulus.reference, before);
    QCOMPARE(find<QTabBar>("study.tabs")->currentIndex(), int(StudyScreen::conditionsTab));
    QVERIFY(inFocus("condition.reference"));
    type("condition.reference", QStringLiteral("0.25 N/mm"));
    enter("condition.reference");
    QTRY_COMPARE_WITH_TIMEOUT(find<QTabBar>("study.tabs")->currentIndex(), int(StudyScreen::trialsTab),
                              kPatience_ms);
    QCOMPARE(design().conditions.front().stimulus.reference, 250.0);
    QVERIFY(saved());
}

void TestStudyDesign::placeholdersAreNotFrozen() {
    psychophysics::StudyDesign plain = desktop::plainStudy();
    plain.id = "hasty";
    openDraft(plain, StudyScreen::checkTab);
    QTRY_VERIFY_WITH_TIMEOUT(find<QWidget>("check.aim.go"), kPatience_ms);
    QVERIFY(find<QWidget>("check.ethics.go") && find<QWidget>("check.pilot.go"));
    QVERIFY(!find<QWidget>("check.consent.go")); // what a new study has is not called short
    QVERIFY(!find<QWidget>("check.participants.go") && !find<QWidget>("check.practice.go") &&
            !find<QWidget>("check.design.go"));
    click("check.freeze");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("freeze")), kPatience_ms);
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("freeze.accept"))->isEnabled() &&
            m_site->find<QWidget>(QStringLiteral("freeze.cannot"))->isVisible());
    QVERIFY(!m_site->find<QCheckBox>(QStringLiteral("freeze.seen"))
                 ->isVisible()); // no word makes up for what is missing
    const auto* why = m_site->find<QLabel>(QStringLiteral("freeze.why_not"));
    QVERIFY(why && why->isVisible());
    QVERIFY2(why->text().contains(QStringLiteral("Aim, Ethics")), qPrintable(why->text()));
    auto* go = m_site->find<QDialog>(QStringLiteral("freeze"))
                   ->findChild<QPushButton*>(QStringLiteral("check.aim.go"));
    QVERIFY(go);
    go->click();
    QTRY_VERIFY_WITH_TIMEOUT(find<QPlainTextEdit>("design.objective") && inFocus("design.objective"),
                             kPatience_ms);
    QVERIFY(find<QPlainTextEdit>("design.objective")
                ->toPlainText()
                .isEmpty()); // the placeholder is not shown as somebody's aim
    type("design.objective", QStringLiteral("Whether it works."));
    type("design.ethics", QStringLiteral("Not needed: the authors try it themselves."));
    QVERIFY(saved());
    screen()->showTab(StudyScreen::checkTab);
    QTRY_VERIFY_WITH_TIMEOUT(find<QWidget>("check.aim") && !find<QWidget>("check.aim.go") &&
                                 !find<QWidget>("check.ethics.go"),
                             kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(
        !find<desktop::CheckList>("check.list")->has(desktop::FreezeCheck::State::waiting), kPatience_ms);
    QVERIFY2(text("check.precision.words").contains(QStringLiteral("factor of")),
             qPrintable(text("check.precision.words")));
    QVERIFY2(text("check.duration.words").contains(QStringLiteral("as simulated")),
             qPrintable(text("check.duration.words")));
    screen()->draft().change(
        {}, {}, [](psychophysics::StudyDesign& study) { study.trial.practiceTrials = 0; }, true);
    QTRY_VERIFY_WITH_TIMEOUT(find<QWidget>("check.practice.go"), kPatience_ms); // the lines follow the design
}

void TestStudyDesign::aPreviewThatIsLeftIsTold() {
    QStringList told;
    QObject hears; // no longer than what it writes to
    connect(&m_site->context.messages(), &desktop::Messages::told, &hears,
            [&told](const desktop::Message& message) { told << message.text; });
    const auto stopped = [&told] {
        return told.join(QLatin1Char('|')).contains(QStringLiteral("The simulation was stopped"));
    };
    openDraft(tests::smallStudy("left_preview"), StudyScreen::previewTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QSpinBox>("preview.runs"), kPatience_ms);
    shown<QSpinBox>("preview.runs")->setValue(2000); // long enough to be left
    click("preview.start");
    screen()->showTab(StudyScreen::generalTab);
    QVERIFY2(stopped(), qPrintable(told.join(QLatin1Char('|'))));
    told.clear();
    screen()->showTab(StudyScreen::previewTab);
    QTRY_VERIFY_WITH_TIMEOUT(shown<QPushButton>("preview.start"), kPatience_ms);
    m_site->go(QStringLiteral("studies")); // with nothing at work nothing is said
    QVERIFY(!stopped());
}

/// What freezing asks for is said where it is typed, and what freezing asks at last is in sight of its
/// button.
void TestStudyDesign::whatIsRequiredIsMarked() {
    openDraft(tests::smallStudy("required"));
    for (const char* field : {"design.title", "design.objective", "design.ethics", "design.consent"})
        QVERIFY2(find<QWidget>(field)->accessibleName().contains(QStringLiteral("required")), field);
    screen()->draft().change(
        {}, {}, [](psychophysics::StudyDesign& study) { study.ethics = "Not needed."; }, true);
    screen()->showTab(StudyScreen::checkTab);
    QVERIFY(saved());
    click("check.freeze");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QDialog>(QStringLiteral("freeze")), kPatience_ms);
    auto* dialog = m_site->find<QDialog>(QStringLiteral("freeze"));
    auto* seen = dialog->findChild<QCheckBox*>(QStringLiteral("freeze.seen"));
    QTRY_VERIFY_WITH_TIMEOUT(
        !dialog->findChild<desktop::CheckList*>()->has(desktop::FreezeCheck::State::waiting), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(seen->isVisible(), kPatience_ms); // nobody has tried it
    QVERIFY(dialog->rect().contains(QRect(seen->mapTo(dialog, QPoint()), seen->size())) &&
            !seen->visibleRegion().isEmpty());
    click("freeze.cancel");
}

/// With the real screens, on this station; and nothing of it is the study's.
void TestStudyDesign::aPilotIsKeptApart() {
    psychophysics::StudyDesign study = tests::smallStudy("tried");
    study.trial.mustTouchAll = false;
    study.trial.betweenTrials_s = 0.1;
    openDraft(study, StudyScreen::checkTab);
    const database::StudyNumber draft = m_study;
    click("check.pilot");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->find<QPushButton>(QStringLiteral("pilot.accept")), kPatience_ms);
    QVERIFY(!m_site->find<QPushButton>(QStringLiteral("pilot.accept"))->isEnabled()); // not without agreement
    QVERIFY(text("pilot.consent").contains(QStringLiteral("my own free will")));
    click("pilot.agreed");
    click("pilot.accept");
    QTRY_VERIFY_WITH_TIMEOUT(m_site->screen<desktop::TrialsScreen>() &&
                                 m_site->screen<desktop::TrialsScreen>()->live(),
                             kPatience_ms);
    auto* trials = m_site->screen<desktop::TrialsScreen>();
    QVERIFY(tests::beginTrials(trials)); // as any participant: instructions, controls, a free minute
    QTRY_VERIFY_WITH_TIMEOUT(trials->live()->view().canAnswer, kPatience_ms);
    for (const char* button : {"answer.2", "answer.0", "answer.confirm"}) {
        QTRY_VERIFY_WITH_TIMEOUT(tests::sittingButton(trials, button)->isEnabled(), kPatience_ms);
        tests::sittingButton(trials, button)->click();
    }
    QTRY_VERIFY_WITH_TIMEOUT(trials->live()->numbers().scored + trials->live()->numbers().spoiled > 0,
                             kPatience_ms);
    const int scored = trials->live()->numbers().scored;
    QVERIFY(tests::stopSitting(*m_site, trials, 30000, QStringLiteral("study"))); // back at the design
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("study")).toLongLong(),
             qlonglong(draft));
    QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>("check.pilot.row"), kPatience_ms);
    QVERIFY2(text("check.pilot.row").contains(QStringLiteral("%1 trial").arg(scored)),
             qPrintable(text("check.pilot.row")));
    QCOMPARE(find<QWidget>("check.pilot.go") == nullptr, scored > 0);
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, m_site->context.actor());
    const auto pilots = reader.listPilots("tried");
    QVERIFY(pilots && pilots->size() == 1);
    const auto list = reader.listStudies(true);
    QVERIFY(list && std::none_of(list->begin(), list->end(),
                                 [](const database::StudySummary& each) { return !each.pilotOf.empty(); }));
    QVERIFY(reader.participants(draft)->empty());
    for (const char* place : {"studies", "study_run", "study_data"}) { // and no screen offers it
        m_site->go(QLatin1String(place));
        QTRY_VERIFY_WITH_TIMEOUT(tests::waitUntilLoaded(*m_site), kPatience_ms);
        for (const QComboBox* choice : m_site->window->screen()->findChildren<QComboBox*>())
            for (int i = 0; i < choice->count(); ++i)
                QVERIFY2(!choice->itemText(i).contains(QStringLiteral("Pilot: ")), place);
        for (const QTableWidget* table : m_site->window->screen()->findChildren<QTableWidget*>())
            for (int row = 0; row < table->rowCount(); ++row)
                QVERIFY2(!table->item(row, 0) ||
                             !table->item(row, 0)->text().startsWith(QStringLiteral("Pilot: ")),
                         place);
    }
}

QTEST_MAIN(TestStudyDesign)
#include "test_study_design.moc"
