// SPDX-License-Identifier: GPL-3.0-or-later
// Every template in every language says what its settings do; and once a setting is changed, what says
// otherwise is found.
#include "catalogue/language_words.h"
#include "catalogue/study_catalogue.h"
#include "core/languages.h"
#include "desktop/studies/freeze_checks.h"
#include "desktop/studies/new_study_dialog.h"
#include "desktop/studies/text_claims.h"

#include <QtTest>
#include <algorithm>
#include <set>

using namespace chiron;
using desktop::FalseClaim;
using psychophysics::StudyDesign;
using psychophysics::Task;

namespace {

const QLocale kEnglish{QLocale::English, QLocale::UnitedKingdom};

QString told(const std::vector<FalseClaim>& claims) {
    QString words;
    for (const FalseClaim& claim : claims)
        words += desktop::claimWords(claim) + QLatin1Char('\n');
    return words;
}

std::set<QString> languagesOf(const std::vector<FalseClaim>& claims, FalseClaim::Where where) {
    std::set<QString> languages;
    for (const FalseClaim& claim : claims)
        if (claim.where == where)
            languages.insert(claim.language);
    return languages;
}

std::set<QString> allLanguages() {
    std::set<QString> ids;
    for (const std::string& id : core::languageIds())
        ids.insert(QString::fromStdString(id));
    return ids;
}

const std::set<QString> kAll = allLanguages();

} // namespace

class TestTextClaims : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const auto loaded = catalogue::StudyCatalogue::load();
        QVERIFY(loaded);
        m_templates = loaded->studies();
        QVERIFY(m_templates.size() >= 12);
    }
    void everyTemplateIsTrue();
    void anotherReferenceIsFoundInEveryTitle();
    void everyUnitOfATitleIsRead();
    void anotherTaskIsFound();
    void whatIsSeenIsFound();
    void anotherCriterionIsFound();
    void aConditionIsMeasuredByItsOwnSettings();
    void timeAndTrialsAreFound();
    void everyLanguagesWordsAreFound_data();
    void everyLanguagesWordsAreFound();
    void otherTextsStand();
    void freezingSaysSo();
    void freezingCountsParticipants_data();
    void freezingCountsParticipants();

private:
    StudyDesign of(const std::string& id) const {
        const auto found = std::find_if(m_templates.begin(), m_templates.end(),
                                        [&](const StudyDesign& each) { return each.id == id; });
        return found == m_templates.end() ? StudyDesign() : *found;
    }
    std::vector<StudyDesign> m_templates;
};

void TestTextClaims::everyTemplateIsTrue() {
    m_templates.push_back(desktop::plainStudy());
    for (const StudyDesign& each : m_templates) {
        const auto claims = desktop::falseClaims(each, kEnglish);
        QVERIFY2(claims.empty(),
                 qPrintable(QString::fromStdString(each.id) + QStringLiteral(": ") + told(claims)));
    }
    m_templates.pop_back();
}

/// Each title that holds a number is understood in all its languages: else the test above would say nothing.
void TestTextClaims::anotherReferenceIsFoundInEveryTitle() {
    int found = 0;
    for (const StudyDesign& design : m_templates)
        for (std::size_t i = 0; i < design.conditions.size(); ++i) {
            if (!QString::fromStdString(design.conditions[i].title.at("en"))
                     .contains(QRegularExpression(QStringLiteral("\\d"))))
                continue;
            StudyDesign changed = design;
            changed.conditions[i].stimulus.reference *= 2.0;
            const auto claims = desktop::falseClaims(changed, kEnglish);
            QVERIFY2(languagesOf(claims, FalseClaim::Where::title) == kAll, design.id.c_str());
            QCOMPARE(claims.front().condition, static_cast<int>(i));
            ++found;
        }
    QVERIFY(found >= 10);
}

/// A title is true with the value in any unit of what it measures, and false with the same number in another.
void TestTextClaims::everyUnitOfATitleIsRead() {
    using psychophysics::Attribute;
    for (const auto& [attribute, reference, yes, no] :
         {std::tuple{Attribute::stiffness, 60.0, "60 N/m", "60 g"},
          {Attribute::viscosity, 4.0, "4 N·s/m", "4 N/m"},
          {Attribute::mass, 0.25, "0.25 kg", "0.25 g"},
          {Attribute::mass, 0.25, "250 g", "250 kg"},
          {Attribute::deformation, 0.3, "0.3 s", "0.3 ms"},
          {Attribute::deformation, 0.3, "300 ms", "300 s"},
          {Attribute::apex, 0.02, "20 mm", "20 cm"},
          {Attribute::apex, 0.02, "2 cm", "2 mm"},
          {Attribute::roughness, 3e-5, "30 µm", "30 mm"},
          {Attribute::friction, 0.3, "0.3", "0.4"}}) {
        StudyDesign design = of("stiffness_elastic_tube");
        design.objective = {{"en", "To see."}};
        design.ownInstructions = psychophysics::StudyText{{"en", "Pull."}};
        design.conditions.resize(1);
        psychophysics::StimulusDesign& stimulus = design.conditions.front().stimulus;
        stimulus.attribute = attribute;
        stimulus.reference = reference;
        for (const auto& [words, stands] : {std::pair{yes, true}, {no, false}}) {
            design.conditions.front().title = {{"en", std::string("Of ") + words}};
            const auto claims = desktop::falseClaims(design, kEnglish);
            QVERIFY2(languagesOf(claims, FalseClaim::Where::title).empty() == stands, words);
        }
    }
}

void TestTextClaims::anotherTaskIsFound() {
    for (const auto& [id, task] : {std::pair{"stiffness_2afc", Task::rank3},
                                   {"stiffness_elastic_tube", Task::twoAfc},
                                   {"surgeons", Task::twoAfc}}) {
        StudyDesign design = of(id);
        for (psychophysics::Condition& condition : design.conditions)
            condition.task = task;
        QVERIFY2(languagesOf(desktop::falseClaims(design, kEnglish), FalseClaim::Where::instructions) == kAll,
                 id);
    }
}

void TestTextClaims::whatIsSeenIsFound() {
    StudyDesign apex = of("apex");
    apex.trial.visibleObjects = true;
    const auto claims = desktop::falseClaims(apex, kEnglish);
    QVERIFY2(languagesOf(claims, FalseClaim::Where::instructions) == kAll &&
                 languagesOf(claims, FalseClaim::Where::aim) == kAll,
             qPrintable(told(claims)));
    StudyDesign mass = of("mass");
    mass.trial.visibleObjects = false;
    QVERIFY(languagesOf(desktop::falseClaims(mass, kEnglish), FalseClaim::Where::instructions) == kAll);
}

/// What is read before one condition is not excused by another that it would be true of.
void TestTextClaims::aConditionIsMeasuredByItsOwnSettings() {
    StudyDesign design = of("surgeons"); // three objects in every condition
    QVERIFY(design.conditions.size() > 1);
    design.conditions[1].task = Task::twoAfc;
    design.ownInstructions = psychophysics::StudyText{{"en", "Guess."}};
    design.objective = {{"en", "To see."}};
    design.conditions[0].instructions = {{"en", "You have three objects."}};
    design.conditions[1].instructions = {{"en", "You have two objects."}};
    QVERIFY2(desktop::falseClaims(design, kEnglish).empty(),
             qPrintable(told(desktop::falseClaims(design, kEnglish))));
    std::swap(design.conditions[0].instructions, design.conditions[1].instructions);
    const auto claims = desktop::falseClaims(design, kEnglish);
    QCOMPARE(claims.size(), std::size_t{2});
    for (std::size_t i = 0; i < 2; ++i)
        QVERIFY(claims[i].where == FalseClaim::Where::part && claims[i].condition == static_cast<int>(i));
}

void TestTextClaims::anotherCriterionIsFound() {
    StudyDesign design = of("stiffness_2afc");
    design.conditions.front().criterion = 0.8;
    QVERIFY(languagesOf(desktop::falseClaims(design, kEnglish), FalseClaim::Where::aim) == kAll);
}

void TestTextClaims::timeAndTrialsAreFound() {
    StudyDesign design = of("stiffness_elastic_tube");
    design.ownInstructions = psychophysics::StudyText{{"en", "Take as long as you like."},
                                                      {"de", "Sie haben 45 Sekunden."},
                                                      {"el", "Υπάρχουν 12 δοκιμές."}};
    QVERIFY((languagesOf(desktop::falseClaims(design, kEnglish), FalseClaim::Where::instructions) ==
             std::set<QString>{QStringLiteral("de"), QStringLiteral("el"), QStringLiteral("en")}));
    design.trial.exploreLimit_s = 0.0; // then one may take as long as one likes, and 45 s are nothing still
    QCOMPARE(languagesOf(desktop::falseClaims(design, kEnglish), FalseClaim::Where::instructions),
             (std::set<QString>{QStringLiteral("de"), QStringLiteral("el")}));
    design.trial.answerLimit_s = 45.0;
    design.trial.breakEvery = 12;
    QVERIFY(desktop::falseClaims(design, kEnglish).empty());
}

void TestTextClaims::everyLanguagesWordsAreFound_data() {
    QTest::addColumn<QString>("language");
    for (const QString& language : kAll)
        QTest::newRow(qPrintable(language)) << language;
}

/// Every word of translations/words, in a text that says what is not set.
void TestTextClaims::everyLanguagesWordsAreFound() {
    QFETCH(QString, language);
    const catalogue::LanguageWords::Claims& words = catalogue::wordsOfLanguage(language.toStdString()).claims;
    StudyDesign design = of("stiffness_elastic_tube");
    design.objective = {{"en", "To see."}};
    const auto found = [&](const QString& said) {
        design.ownInstructions = psychophysics::StudyText{{language.toStdString(), said.toStdString()}};
        return languagesOf(desktop::falseClaims(design, kEnglish), FalseClaim::Where::instructions) ==
               std::set<QString>{language};
    };
    for (const QStringList* counted : {&words.objects, &words.trials, &words.seconds})
        for (const QString& each : *counted)
            QVERIFY2(found(QStringLiteral("977 ") + each), qPrintable(each));
    design.trial.exploreLimit_s = design.trial.answerLimit_s = 45.0;
    design.trial.breakAtLeast_s = design.trial.betweenTrials_s = 45.0;
    int numbers = 0;
    for (const auto& [number, names] : words.numbers)
        for (const QString& each : names) {
            QVERIFY2(found(each + QLatin1Char(' ') + words.seconds.front()), qPrintable(each));
            ++numbers;
        }
    QVERIFY(numbers >= 3);
    const auto allFound = [&](const QStringList& statements) {
        for (QString each : statements)
            if (!found(each.replace(QLatin1Char('*'), QLatin1String("xyz"))))
                return false;
        return !statements.isEmpty();
    };
    design.trial.visibleObjects = true;
    QVERIFY(allFound(words.objectsNotSeen));
    design.trial.visibleObjects = false;
    QVERIFY(allFound(words.objectsSeen));
    QVERIFY(allFound(words.timeNotLimited));
    for (psychophysics::Condition& condition : design.conditions)
        condition.criterion = 0.8;
    QVERIFY(allFound(words.criterionThreeOfFour));
}

/// What is not understood is nobody's fault.
void TestTextClaims::otherTextsStand() {
    StudyDesign design = of("stiffness_elastic_tube");
    design.conditions.front().title = {{"en", "Group 3 (2), day 5"}};
    design.ownInstructions = psychophysics::StudyText{{"en", "Pull twice. One of them differs."}};
    design.objective = {{"en", "Whether 12 people feel 5 % of 0.3."}};
    const auto claims = desktop::falseClaims(design, kEnglish);
    QVERIFY2(claims.empty(), qPrintable(told(claims)));
}

void TestTextClaims::freezingCountsParticipants_data() {
    QTest::addColumn<int>("planned");
    QTest::addColumn<desktop::FreezeCheck::State>("state");
    QTest::addColumn<QString>("words");
    QTest::newRow("none") << 0 << desktop::FreezeCheck::State::bad << QStringLiteral("at least one");
    QTest::newRow("one") << 1 << desktop::FreezeCheck::State::advice
                         << QStringLiteral("One participant says nothing about others");
    QTest::newRow("two") << 2 << desktop::FreezeCheck::State::good << QStringLiteral("2");
    QTest::newRow("twelve") << 12 << desktop::FreezeCheck::State::good << QStringLiteral("12");
}

void TestTextClaims::freezingCountsParticipants() {
    QFETCH(int, planned);
    QFETCH(desktop::FreezeCheck::State, state);
    QFETCH(QString, words);
    StudyDesign design = of("stiffness_elastic_tube");
    design.conditions.resize(1); // one condition: every number of people is balanced
    design.participantsPlanned = planned;
    for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, {}, kEnglish))
        if (each.name == QStringLiteral("participants")) {
            QCOMPARE(each.state, state);
            QVERIFY2(each.words.contains(words), qPrintable(each.words));
            return;
        }
    QFAIL("no such check");
}

void TestTextClaims::freezingSaysSo() {
    StudyDesign design = of("stiffness_elastic_tube");
    const auto check = [&] {
        for (const desktop::FreezeCheck& each : desktop::freezeChecks(design, {}, kEnglish))
            if (each.name == QStringLiteral("texts"))
                return each;
        return desktop::FreezeCheck();
    };
    QCOMPARE(check().state, desktop::FreezeCheck::State::good);
    design.conditions.front().stimulus.reference = 120.0;
    QCOMPARE(check().state, desktop::FreezeCheck::State::advice);
    QVERIFY2(check().words.contains(QStringLiteral("60 N/m")) &&
                 check().words.contains(QStringLiteral("120")),
             qPrintable(check().words));
    QCOMPARE(check().field, QStringLiteral("condition.title"));
}

QTEST_MAIN(TestTextClaims)
#include "test_text_claims.moc"
