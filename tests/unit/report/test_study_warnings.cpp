// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_report_words.h"
#include "session_report/study_warning_words.h"
#include "support/languages.h"

#include <QSet>
#include <QTranslator>
#include <QtTest>
#include <cmath>

using namespace chiron;
using psychophysics::EstimateMethod;
using psychophysics::Warning;
using psychophysics::WarningKind;
using psychophysics::warningText;

static void initialiseCatalogues() {
    Q_INIT_RESOURCE(i18n);
}

// Every warning of an analysis has words for people in every language of the program, and a token for data. A
// kind that is added without one of them fails here.
class TestStudyWarnings : public QObject {
    Q_OBJECT
private slots:
    /// Three digits, without an exponent from 0.00001 to ten millions.
    void numbersHaveThreeDigits() {
        for (const auto& [value, words] : {std::pair{0.0, "0"},
                                           {1.0, "1.00"},
                                           {-12.345, "-12.3"},
                                           {123.45, "123"},
                                           {1234567.0, "1234567"},
                                           {12345678.0, "1.23e+07"},
                                           {0.00001234, "0.0000123"},
                                           {0.000001234, "1.23e-06"},
                                           {std::nan(""), "–"}})
            QCOMPARE(chiron::session_report::study_report_words::number(value, QLocale::c()),
                     QString::fromUtf8(words));
    }
    void initTestCase() { initialiseCatalogues(); }
    void everyKindHasWords_data();
    void everyKindHasWords();
    void everyMethodHasWords_data() { everyKindHasWords_data(); }
    void everyMethodHasWords();
    void dataStayEnglish();
    void oneAndMany();
};

namespace {

constexpr int kCount = 7;
constexpr int kOf = 41;

Warning warningOf(int kind) {
    return {static_cast<WarningKind>(kind), kCount, kOf, "a detail"};
}

/// What the program would say in a language, with its catalogue installed as long as this lives.
class Spoken {
public:
    explicit Spoken(const QString& language) {
        m_good = m_translator.load(QStringLiteral(":/i18n/chiron_%1.qm").arg(language)) &&
                 QCoreApplication::installTranslator(&m_translator);
    }
    ~Spoken() { QCoreApplication::removeTranslator(&m_translator); }
    bool good() const { return m_good; }

private:
    QTranslator m_translator;
    bool m_good = false;
};

bool isGreek(const QString& words) {
    return words.contains(QRegularExpression(QStringLiteral("[α-ω]{3}")));
}

} // namespace

void TestStudyWarnings::everyKindHasWords_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : tests::languageIds())
        QTest::newRow(language) << QString::fromLatin1(language);
}

void TestStudyWarnings::everyKindHasWords() {
    QFETCH(QString, language);
    QSet<QString> seen;
    for (int kind = 0; kind < static_cast<int>(WarningKind::end); ++kind) {
        const Warning warning = warningOf(kind);
        QString english;
        {
            const Spoken spoken(QStringLiteral("en"));
            QVERIFY(spoken.good());
            english = session_report::warningWords(warning);
        }
        const Spoken spoken(language);
        QVERIFY(spoken.good());
        const QString words = session_report::warningWords(warning);
        const char* name = warningToken(warning.kind).data();
        QVERIFY2(!words.isEmpty(), name);
        QVERIFY2(!words.contains(u'%') && !words.contains(QStringLiteral("(s)")), qPrintable(words));
        QVERIFY2(language == u"en" || words != english, qPrintable(words));
        QVERIFY2(language != u"el" || isGreek(words), qPrintable(words));
        for (const int number : {kCount, kOf})
            QCOMPARE(words.contains(QString::number(number)), english.contains(QString::number(number)));
        seen.insert(words);
    }
    constexpr int kAlike =
        2; // no reference, of comparisons and settings; few participants, of a threshold and an apex
    QCOMPARE(static_cast<int>(seen.size()), static_cast<int>(WarningKind::end) - kAlike);
}

void TestStudyWarnings::everyMethodHasWords() {
    QFETCH(QString, language);
    for (int i = 1; i <= static_cast<int>(EstimateMethod::apexMarks); ++i) {
        const auto method = static_cast<EstimateMethod>(i);
        const QString plain = session_report::methodWords(method);
        const Spoken spoken(language);
        const QString words = session_report::methodWords(method);
        QVERIFY2(!words.isEmpty() && !methodText(method).empty(), methodText(method).data());
        QVERIFY2((words == plain) == (language == u"en") && (language != u"el" || isGreek(words)),
                 qPrintable(words));
    }
    QVERIFY(session_report::methodWords(EstimateMethod::none).isEmpty() &&
            methodText(EstimateMethod::none).empty());
}

// Scripts read tokens; an export of today reads as one of before.
void TestStudyWarnings::dataStayEnglish() {
    const Spoken spoken(QStringLiteral("de"));
    for (int kind = 0; kind < static_cast<int>(WarningKind::end); ++kind) {
        const std::string text = warningText(warningOf(kind));
        static const QRegularExpression form(QStringLiteral("^[a-z]+(_[a-z]+)*: [^#@%$]+$"));
        QVERIFY2(form.match(QString::fromStdString(text)).hasMatch(), text.c_str());
        QVERIFY2(text.starts_with(std::string(warningToken(static_cast<WarningKind>(kind))) + ": "),
                 text.c_str());
    }
    QCOMPARE(warningText({WarningKind::leftOutTrials, 3}),
             std::string("left_out: 3 trials have no usable difference or answer and were left out"));
    QCOMPARE(
        warningText({WarningKind::priorEdgeLow}),
        std::string(
            "prior_edge: the data say nothing at the lower end: the estimate is where the prior put it"));
    QCOMPARE(warningText({WarningKind::withdrawn, 1}),
             std::string("withdrawn: 1 participant who withdrew left out"));
    QCOMPARE(warningText({WarningKind::simulatedLeftOut, 2}),
             std::string("simulated_left_out: 2 participants simulated left out: the group is of people"));
    QCOMPARE(warningText({WarningKind::runsWithoutEstimate, 3, 100}),
             std::string("runs_without_estimate: 3 of 100"));
    QCOMPARE(warningText({WarningKind::notSimulated, 0, 0, "why"}), std::string("not_simulated: why"));
    QVERIFY(warningToken(WarningKind::end).empty());
}

void TestStudyWarnings::oneAndMany() {
    const Spoken spoken(QStringLiteral("de"));
    QCOMPARE(session_report::warningWords({WarningKind::withdrawn, 1}),
             QStringLiteral("1 Person, die ihre Teilnahme zurückgezogen hat, zählt nicht mit."));
    QCOMPARE(session_report::warningWords({WarningKind::withdrawn, 3}),
             QStringLiteral("3 Personen, die ihre Teilnahme zurückgezogen haben, zählen nicht mit."));
}

QTEST_MAIN(TestStudyWarnings)
#include "test_study_warnings.moc"
