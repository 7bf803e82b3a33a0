// SPDX-License-Identifier: GPL-3.0-or-later
// With mouse and keyboard force is shown, not felt: the texts of the content are true then, too, in every
// language.
#include "catalogue/catalogue.h"
#include "catalogue/study_catalogue.h"
#include "core/languages.h"
#include "support/feeling_words.h"

#include <QtTest>
#include <functional>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

/// What is found wrong, a line for each text.
QString faultsOf(const std::map<std::string, std::string>& text, const std::string& where, bool palpation) {
    QString faults;
    for (const auto& [language, words] : text)
        if (const QString found =
                tests::feelingIn(QString::fromStdString(words), QString::fromStdString(language), palpation);
            !found.isEmpty())
            faults += QStringLiteral("%1, %2: \"%3\" in: %4\n")
                          .arg(QString::fromStdString(where), QString::fromStdString(language), found,
                               QString::fromStdString(words));
    return faults;
}

} // namespace

class TestFeelingWords : public QObject {
    Q_OBJECT
private slots:
    /// A list that finds nothing would prove nothing.
    void wordsOfFeelingAreFound_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("palpation");
        QTest::addColumn<bool>("found");
        const auto row = [](const char* language, const char* text, bool palpation, bool found) {
            QTest::newRow(text) << QString::fromUtf8(language) << QString::fromUtf8(text) << palpation
                                << found;
        };
        row("en", "Rely on what you feel.", false, true);
        row("en", "This device renders no force. Force is shown, not felt.", false, false);
        row("en", "Not felt, but feel it.", false, true);
        row("en", "Mark while you touch the sphere.", false, false); // the tool touches it
        row("en", "Find it by touch.", false, true);
        row("de", "Tasten Sie sich an der Kugel nach oben.", false, true);
        row("de", "Tasten Sie Streifen für Streifen ab.", true, false);
        row("de", "Bewegen: Maus oder Pfeiltasten. Leertaste: Pause. Eingabetaste: weiter.", false, false);
        row("de", "Die Kraft wird gezeigt, nicht gefühlt.", false, false);
        row("de", "Spüren Sie den Widerstand.", true, true);
        row("el", "Ψηλαφήστε πρώτα τη σφαίρα.", false, true);
        row("el", "Ψηλαφήστε έναν μαστό.", true, false);
        row("el", "Αναγνώριση σχήματος με την αφή.", false, true);
        row("el", "Αφήστε την απαλά μέσα του.", false, false);
        row("el", "Η δύναμη προβάλλεται, δεν γίνεται αισθητή.", false, false);
        row("el", "Η ωοθήκη είναι υγρή και ευαίσθητη.", false, false);
        row("el", "Νιώστε το βάρος τους.", false, true);
    }
    void wordsOfFeelingAreFound() {
        QFETCH(QString, language);
        QFETCH(QString, text);
        QFETCH(bool, palpation);
        QFETCH(bool, found);
        QCOMPARE(!tests::feelingIn(text, language, palpation).isEmpty(), found);
    }

    void everyLanguageHasItsWords() {
        for (const std::string& language : core::languageIds())
            QVERIFY(tests::feelingIn(QStringLiteral("…"), QString::fromStdString(language)).isEmpty());
    }

    void exercisesAndLevels() {
        const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
        QString faults;
        int levels = 0;
        for (const Exercise& exercise : catalogue->exercises()) {
            const bool palpation = exercise.id == "palpation";
            faults += faultsOf(exercise.title, exercise.id, palpation);
            faults += faultsOf(exercise.objective, exercise.id, palpation);
            for (const Advice& advice : exercise.advice)
                for (const Translated* text : {&advice.text, &advice.moment})
                    faults += faultsOf(*text, exercise.id + ", advice on " + advice.metric, palpation);
            for (const LegendLine& line : exercise.legend)
                faults += faultsOf(line.text, exercise.id + ", legend of " + line.mark, palpation);
            for (const ExerciseLevel& level : exercise.levels) {
                ++levels;
                for (const Translated* text : {&level.title, &level.goal, &level.objective, &level.measured})
                    faults += faultsOf(*text, exercise.id + " " + level.id, palpation);
                if (level.shownForce)
                    faults +=
                        faultsOf(level.shownForce->note, exercise.id + " " + level.id + ", note", palpation);
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults));
        QVERIFY(levels > 20);
    }

    /// What participants read and are asked about what they have just explored. Whether the program would
    /// train the sense of touch is another question.
    void instructionsOfStudies() {
        const auto studies = StudyCatalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY2(studies.has_value(), studies ? "" : studies.error().message.c_str());
        QString faults;
        int asked = 0;
        for (const psychophysics::StudyDesign& study : studies->studies()) {
            faults += faultsOf(study.instructions, study.id, false);
            for (const psychophysics::Condition& condition : study.conditions)
                faults += faultsOf(condition.instructions, study.id + " " + condition.id, false);
            for (const psychophysics::Questionnaire& questionnaire : study.questionnaires)
                for (const psychophysics::QuestionnaireItem& item : questionnaire.items) {
                    if (item.construct != "face")
                        continue;
                    ++asked;
                    faults += faultsOf(questionnaire.title, study.id + " " + questionnaire.id, false);
                    faults += faultsOf(item.text, study.id + " " + item.id, false);
                }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults));
        QVERIFY(asked > 0);
    }
};

QTEST_GUILESS_MAIN(TestFeelingWords)
#include "test_feeling_words.moc"
