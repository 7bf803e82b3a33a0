// SPDX-License-Identifier: GPL-3.0-or-later
// What study reports and screens call things, and how they write numbers: one word for each, and none for
// two.
#include "session_report/study_report_words.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <set>

using namespace chiron;
namespace words = chiron::session_report::study_report_words;
using psychophysics::Attribute;

namespace {

const QLocale kEnglish(QLocale::English, QLocale::UnitedKingdom);

QString plain(QString text) {
    return text.replace(QChar(0x00a0), QLatin1Char(' ')).replace(QChar(0x202f), QLatin1Char(' ')).toLower();
}

} // namespace

class TestStudyWords : public QObject {
    Q_OBJECT
private slots:
    void threeDigitsThatSaySomething();
    void valuesInUnitsThatPeopleRead();
    void sharesInPercent();
    void everyWordIsItsOwn();
    void textsInALanguageOrTheNext();
    void daysOfMoments();
};

void TestStudyWords::threeDigitsThatSaySomething() {
    for (const auto& [value, said] :
         std::initializer_list<std::pair<double, const char*>>{{0.0, "0"},
                                                               {1.0, "1.00"},
                                                               {9.99, "9.99"},
                                                               {10.0, "10.0"},
                                                               {99.9, "99.9"},
                                                               {100.0, "100"},
                                                               {1234567.0, "1,234,567"},
                                                               {12345678.0, "1.23e+07"},
                                                               {0.1, "0.100"},
                                                               {0.0123, "0.0123"},
                                                               {0.0000123, "0.0000123"},
                                                               {0.00000123, "1.23e-06"}}) {
        QCOMPARE(plain(words::number(value, kEnglish)), QString::fromLatin1(said));
        if (value != 0.0)
            QCOMPARE(plain(words::number(-value, kEnglish)), QLatin1Char('-') + QString::fromLatin1(said));
    }
    QCOMPARE(words::number(std::nan(""), kEnglish), QStringLiteral("–"));
    QCOMPARE(words::plainNumber(0.1234567, kEnglish), QStringLiteral("0.123457"));
    QCOMPARE(words::plainNumber(4.0, kEnglish), QStringLiteral("4"));
    QCOMPARE(words::plainNumber(std::nan(""), kEnglish), QStringLiteral("–"));
}

void TestStudyWords::valuesInUnitsThatPeopleRead() {
    for (const auto& [attribute, said] : {std::pair{Attribute::stiffness, "0.0123 n/m"},
                                          {Attribute::mass, "12.3 g"},
                                          {Attribute::deformation, "0.0123 s"},
                                          {Attribute::roughness, "12,300 µm"},
                                          {Attribute::friction, "0.0123"},
                                          {Attribute::viscosity, "0.0123 n·s/m"},
                                          {Attribute::apex, "12.3 mm"}})
        QCOMPARE(plain(words::value(0.0123, attribute, kEnglish)), QString::fromUtf8(said));
    QCOMPARE(words::value(std::numeric_limits<double>::infinity(), Attribute::mass, kEnglish),
             QStringLiteral("–"));
}

void TestStudyWords::sharesInPercent() {
    QCOMPARE(plain(words::percent(0.1234, kEnglish)), QStringLiteral("12.3 %"));
    QCOMPARE(words::percent(std::nan(""), kEnglish), QStringLiteral("–"));
    QCOMPARE(plain(words::intervalPercent(0.05, 0.234, kEnglish)), QStringLiteral("5.00 … 23.4 %"));
    QCOMPARE(words::intervalPercent(std::nan(""), 0.234, kEnglish), QStringLiteral("–"));
    QCOMPARE(words::intervalPercent(0.05, std::numeric_limits<double>::infinity(), kEnglish),
             QStringLiteral("–"));
}

void TestStudyWords::everyWordIsItsOwn() {
    std::set<QString> said;
    int count = 0;
    const auto take = [&](const QString& word) {
        QVERIFY(!word.isEmpty());
        said.insert(word);
        ++count;
    };
    const auto all = [&] { // and the next kind of word
        const bool differ = static_cast<int>(said.size()) == count;
        said.clear();
        count = 0;
        return differ;
    };
    for (int i = 0; i < psychophysics::kAttributes; ++i)
        take(words::attribute(static_cast<Attribute>(i)));
    QVERIFY(all());
    for (int i = 0; i < psychophysics::kTasks; ++i)
        take(words::task(static_cast<psychophysics::Task>(i)));
    QVERIFY(all());
    for (const char* kind : {"staircase", "pest", "constant", "descending", "quest", "quest_plus",
                             "rank3_quest_plus", "another_one"})
        take(words::procedure(kind));
    QVERIFY(all());
    QCOMPARE(words::procedure("another_one"), QStringLiteral("another one"));
    QCOMPARE(words::procedure("rank3_quest_plus_ties"), words::procedure("rank3_quest_plus"));
    for (int i = 0; i < 4; ++i)
        take(words::order(static_cast<psychophysics::OrderDesign>(i)));
    QVERIFY(all());
    for (int i = 0; i < 4; ++i)
        take(words::state(static_cast<database::StudyState>(i)));
    QVERIFY(all());
    for (int i = 0; i < 4; ++i)
        take(words::participantState(static_cast<database::ParticipantState>(i)));
    QVERIFY(all());
    for (int i = 0; i < 3; ++i)
        take(words::runState(static_cast<database::StudyRunState>(i)));
    QVERIFY(all());
    for (const char* reason :
         {"force_error", "stiffness_error", "late_ticks", "saturation", "speed", "peak_force", "time",
          "untouched", "experimenter", "stopped", "withheld", "some_other"})
        take(words::spoiled(reason));
    QVERIFY(all());
    QCOMPARE(words::spoiled("some_other"), QStringLiteral("some other"));
    QCOMPARE(words::state(database::StudyState::frozen), QStringLiteral("Frozen"));
    QCOMPARE(words::participantState(database::ParticipantState::enrolled),
             QStringLiteral("Consent missing"));
    QCOMPARE(words::runState(database::StudyRunState::open), QStringLiteral("Open"));
}

void TestStudyWords::textsInALanguageOrTheNext() {
    const psychophysics::StudyText both{{"de", "weich"}, {"en", "soft"}}, empty{{"de", ""}, {"en", "soft"}},
        other{{"el", "μαλακό"}};
    QCOMPARE(words::text(both, "de"), QStringLiteral("weich"));
    QCOMPARE(words::text(both, "el"), QStringLiteral("soft"));
    QCOMPARE(words::text(empty, "de"), QStringLiteral("soft"));
    QCOMPARE(words::text(other, "de"), QStringLiteral("μαλακό"));
    QCOMPARE(words::text({}, "de"), QString());
}

void TestStudyWords::daysOfMoments() {
    QCOMPARE(words::day("2026-11-05T23:59:59.999Z", kEnglish),
             kEnglish.toString(QDate(2026, 11, 5), QLocale::ShortFormat));
    QCOMPARE(words::day("once", kEnglish), QString());
}

QTEST_APPLESS_MAIN(TestStudyWords)
#include "test_study_words.moc"
