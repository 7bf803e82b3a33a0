// SPDX-License-Identifier: GPL-3.0-or-later
// Why a metric has no value: what scores keep, and what it is read as.
#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"
#include "scoring/undefined_reason.h"

#include <QtTest>
#include <array>
#include <set>

using namespace chiron::scoring;

namespace {

/// As sessions of before have them stored, word for word; those with counts apart.
constexpr auto kStoredBefore = std::to_array<const char*>({
    "fewer than three speed samples",
    "fewer than two lumps of a trial were found and their hardness said",
    "fewer than two lumps were found and their hardness said",
    "fewer than two lumps were there",
    "fewer than two positions",
    "fewer than two samples",
    "needs two trials or more",
    "neither movement nor contact",
    "no contact",
    "no jerk: speed changes evenly",
    "no lump was found",
    "no lump was there",
    "no movement",
    "no position to score",
    "no samples",
    "no sub-movement of 100 ms",
    "no trial was finished",
    "no trials",
    "no two lumps of different hardness were found and rated",
    "no weighing was asked for",
    "nobody said how sure a finding is",
    "nothing was pressed",
    "nothing was touched, so nothing was predicted",
    "of no lump that was found the size was said",
    "one trial alone has no chance level",
    "speed has no spectrum up to 10 Hz",
    "start and end are less than 5 mm apart",
    "the apex's true place is not known",
    "the inspection was not reached",
    "the level asks for no hardness",
    "the level asks for no size",
    "the level has no landmarks",
    "the lumps that were found are equally hard",
    "the task has no such target",
    "the tension was never held",
    "the tip was never at the bend",
    "the tip was never in the urethra",
    "the trace has no coverage",
    "the trace has no data of a tube",
    "the trace has no force band",
    "the trace has no forces",
    "the trace has no insertion data",
    "the trace has no lumps and search area",
    "the trace has no objects and target",
    "the trace has no prediction",
    "the trace has no procedure",
    "the trace has no reports",
    "the trace has no squeeze",
    "the trace has no squeeze limit",
    "the trace has no torques",
    "the trace lost reports",
    "the trial was not finished",
});

} // namespace

class TestUndefinedReason : public QObject {
    Q_OBJECT
private slots:
    void whatIsStoredKeepsItsMeaning() {
        std::set<std::string_view> seen;
        for (const char* text : kStoredBefore) {
            const auto undefined = undefinedOf(text);
            QVERIFY2(undefined, text);
            QCOMPARE(storedText(*undefined), std::string(text));
            QVERIFY2(seen.insert(undefined->reason.stored).second, text);
            QCOMPARE(countsOf(undefined->reason), std::size_t{0});
        }
        QCOMPARE(seen.size(), undefinedReasons().size() - 1); // but for the one with counts
    }

    void everyReasonIsReadBack() {
        for (const UndefinedReason& reason : undefinedReasons()) {
            Undefined undefined{reason, {}};
            if (countsOf(undefined.reason) == 3)
                undefined.counts = {7, 140, 20};
            QCOMPARE(undefinedOf(storedText(undefined)), std::optional(undefined));
        }
        QCOMPARE(storedText({reasons::kTooFewRegions, {7, 140, 20}}),
                 std::string("only 7 regions with a lump and 140 without: 20 of each are needed"));
    }

    void whatIsNoneOfOursIsNone() {
        for (const char* text : {"", "no", "no trials ", " no trials", "No trials", "no contact\n",
                                 "only regions with a lump and 4 without: 20 of each are needed",
                                 "only 7 regions with a lump and -4 without: 20 of each are needed",
                                 "only 7 regions with a lump and 4 without: 20 of each are needed.",
                                 "only 99999999999 regions with a lump and 4 without: 20 of each are needed",
                                 "only # regions with a lump and # without: # of each are needed"})
            QVERIFY2(!undefinedOf(text), text);
    }
};

QTEST_GUILESS_MAIN(TestUndefinedReason)
#include "test_undefined_reason.moc"
