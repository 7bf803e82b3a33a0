// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base_mounting.h"
#include "core/clock.h"
#include "core/contact_bits.h"
#include "core/exercise_cues.h"
#include "core/exercise_parameters.h"
#include "core/fp_environment.h"
#include "core/haptic_frame.h"
#include "core/least_squares.h"
#include "core/normal_distribution.h"
#include "core/presentation_word.h"
#include "core/random.h"
#include "core/units.h"
#include "core/visible_cues.h"
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/palpation/cues/findings_book.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "modules/exercises/urethra_insertion/cues/procedure_stage.h"
#include "support/cue_numbers.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>
#include <any>
#include <bit>
#include <chrono>
#include <cmath>

using namespace chiron::core;
using chiron::simulation::Finding;
using chiron::simulation::FindingsBook;
using chiron::simulation::kMaxFindings;
using chiron::simulation::kMaxShownLumps;
using chiron::simulation::ReportField;
using chiron::simulation::reportField;
using chiron::simulation::reportValue;
using chiron::simulation::reportWord;

class TestCore : public QObject {
    Q_OBJECT
private slots:
    void xoshiroMatchesPublishedVector();
    void streamsDiffer();
    void everyPurposeHasOneOwner();
    void normalHasUnitMoments();
    void belowIsUnbiased();
    void denormalsAreFlushed();
    void utcHasIsoForm();
    void seedsMeanTheSameForEver();
    void clocksAreTheSystems();
    void quantilesInvertToTheLastDigits();
    void numbersOfTheRecording();
    void nothingIsShownUnlessSaid();
    void unitsAreThoseOfSi();
    void namesOfABuild();
    void parametersAreReadByWhoKnowsThem();
    void cuesAreOneTypeAtATime();
    void whatSaysNothingTakesTheUsual();
    void findingsAreBooked();
    void leastSquaresFindTheSlopes();
};

// Reference: xoshiro256++ seeded with the state {1,2,3,4} yields 41943041 first (published in the authors'
// and in other implementations' tests); through SplitMix64 from seed 0 the state words are
// 0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4 ...
void TestCore::xoshiroMatchesPublishedVector() {
    Random r(0);
    const std::uint64_t s0 = 0xe220a8397b1dcdafULL;
    const std::uint64_t s3 = 0xf88bb8a8724c81ecULL;
    QCOMPARE(r.next(), std::rotl(s0 + s3, 23) + s0);
}

void TestCore::streamsDiffer() {
    Random a = Random::stream(7, "hand");
    Random b = Random::stream(7, "scene");
    Random c = Random::stream(7, "hand");
    const auto first = a.next();
    QVERIFY(first != b.next());
    QCOMPARE(first, c.next());
}

/// Two sources of noise that share a purpose draw the same numbers where they get the same seed.
void TestCore::everyPurposeHasOneOwner() {
    const QRegularExpression stream(QStringLiteral("Random::stream\\([^;]*?\"([^\"]+)\""));
    const QDir root(QStringLiteral(CHIRON_SOURCE_DIR));
    QMap<QString, QSet<QString>> owners; // files without their extension
    for (const char* floor : {"app", "curriculum", "database", "modules"}) {
        QDirIterator files(root.filePath(QLatin1String(floor)), {"*.h", "*.cpp"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            const QString path = root.relativeFilePath(file.fileName());
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(path));
            auto found = stream.globalMatch(QString::fromUtf8(file.readAll()));
            while (found.hasNext())
                owners[found.next().captured(1)].insert(path.section(u'.', 0, -2));
        }
    }
    QVERIFY(owners.contains(QStringLiteral("hand/tremor")) && owners.size() > 30);
    for (auto purpose = owners.cbegin(); purpose != owners.cend(); ++purpose)
        QVERIFY2(purpose->size() == 1, qPrintable(purpose.key() + ": " +
                                                  QStringList(purpose->values()).join(QStringLiteral(", "))));
}

void TestCore::normalHasUnitMoments() {
    Random r(11);
    double sum = 0.0;
    double squares = 0.0;
    const int n = 200000;
    for (int i = 0; i < n; ++i) {
        const double x = r.normal();
        sum += x;
        squares += x * x;
    }
    QVERIFY(std::abs(sum / n) < 0.01);           // 4.5 standard errors
    QVERIFY(std::abs(squares / n - 1.0) < 0.02); // 6 standard errors
}

void TestCore::belowIsUnbiased() {
    Random r(3);
    std::array<int, 3> seen{};
    for (int i = 0; i < 30000; ++i)
        ++seen[r.below(3)];
    for (const int count : seen)
        QVERIFY(std::abs(count - 10000) < 400); // 4.9 standard deviations
}

void TestCore::denormalsAreFlushed() {
    setModelFloatingPointEnvironment();
    volatile double tiny = 1e-300;
    volatile double tinier = tiny * 1e-15;
    QCOMPARE(static_cast<double>(tinier), 0.0);
}

void TestCore::utcHasIsoForm() {
    const QString text = QString::fromStdString(utcNowIso8601());
    QVERIFY(QDateTime::fromString(text, Qt::ISODateWithMs).isValid());
}

/// Every draw that a stored session may have made, by an implementation of its own (xoshiro256++, SplitMix64,
/// FNV-1a, Lemire's bound and Marsaglia's polar method written down in another language).
void TestCore::seedsMeanTheSameForEver() {
    Random words(42);
    for (const std::uint64_t expected :
         {0xd0764d4f4476689fULL, 0x519e4174576f3791ULL, 0xfbe07cfb0c24ed8cULL, 0xb37d9f600cd835b8ULL,
          0xcb231c3874846a73ULL, 0x968d9f004e50de7dULL, 0x201718ff221a3556ULL, 0x9ae94e070ed8cb46ULL})
        QCOMPARE(words.next(), expected);
    Random shares(42);
    for (const double expected : {0.8143051451229099, 0.3188210400616611, 0.9838941681774888})
        QCOMPARE(shares.uniform(), expected);
    Random between(42);
    QCOMPARE(between.uniform(-2.0, 6.0), -2.0 + 8.0 * 0.8143051451229099);
    Random bounded(42);
    const std::uint64_t half =
        (std::uint64_t{1} << 63) + 1; // of every second draw there is too much: it is drawn again
    const std::pair<std::uint64_t, std::uint64_t> draws[] = {{1, 0},
                                                             {2, 0},
                                                             {10, 9},
                                                             {1000, 701},
                                                             {1'000'000'000'000, 793504489691},
                                                             {half, 5581269471817655715ULL},
                                                             {half, 1915852752325109347ULL},
                                                             {half, 8608607705564336234ULL}};
    for (const auto& [bound, expected] : draws)
        QCOMPARE(bounded.below(bound), expected);
    Random normal(42);
    for (const double expected : {0.9813983900724986, -0.565720104673956, 1.3403256427520227,
                                  0.4023128702992608, -0.9642205062941384})
        QVERIFY(std::abs(normal.normal() - expected) < 1e-15);
    QCOMPARE(Random::mix(7, "hand"), std::uint64_t{0x4af6a450784c5974});
    QCOMPARE(Random::mix(0, ""), std::uint64_t{0xc3817c016ba4ff30});
    QCOMPARE(Random::stream(7, "hand").next(), std::uint64_t{0xf6aeb9f86b4f9e2b});
}

/// Between two looks at the same clocks by another way.
void TestCore::clocksAreTheSystems() {
    const auto monotonic = [] {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(
                   std::chrono::steady_clock::now().time_since_epoch())
            .count();
    };
    const auto before = monotonic();
    const std::int64_t now_ns = monotonicNow_ns();
    QVERIFY(before <= now_ns && now_ns <= monotonic());
    const QDateTime from = QDateTime::currentDateTimeUtc();
    const QString text = QString::fromStdString(utcNowIso8601());
    const QDateTime to = QDateTime::currentDateTimeUtc();
    const QDateTime said = QDateTime::fromString(text, Qt::ISODateWithMs);
    QVERIFY2(from <= said && said <= to, qPrintable(text));
    QVERIFY2(QRegularExpression(QStringLiteral("^\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{3}Z$"))
                 .match(text)
                 .hasMatch(),
             qPrintable(text));
}

/// From the farthest tail that a double holds to the middle: to some last digits, which two steps give only
/// from a good first guess.
void TestCore::quantilesInvertToTheLastDigits() {
    for (double x = -37.0; x < -0.01; x += 0.0625)
        QVERIFY2(std::abs(normalQuantile(normalCumulative(x)) / x - 1.0) < 3e-14,
                 qPrintable(QString::number(x)));
    for (const double p : {0.1, 0.25, 0.4999, 0.5, 0.75})
        QVERIFY(std::abs(normalCumulative(normalQuantile(p)) - p) < 1e-15);
    QVERIFY(std::abs(normalDensity(0.0) - 0.3989422804014327) < 1e-16 &&
            std::abs(normalDensity(-2.0) - 0.05399096651318806) < 1e-16);
}

/// What recordings hold as numbers keeps its meaning: data.md, Samples.
void TestCore::numbersOfTheRecording() {
    const auto numbers = [](std::initializer_list<int> is, int from = 0) {
        int expected = from;
        for (const int number : is)
            QCOMPARE(number, expected++);
    };
    const auto bits = [](std::initializer_list<std::uint32_t> is) {
        std::uint32_t expected = 1;
        for (const std::uint32_t bit : is) {
            QCOMPARE(bit, expected);
            expected <<= 1;
        }
    };
    const auto of = [](auto value) { return static_cast<int>(value); };
    using P = TrialPhase;
    numbers({of(P::idle), of(P::ready), of(P::running), of(P::between), of(P::finished)});
    using F = ForceState;
    numbers({of(F::off), of(F::arming), of(F::ramping), of(F::on), of(F::pausing), of(F::paused),
             of(F::stopped), of(F::fault), of(F::heldByWatchdog), of(F::heldByHeartbeat)});
    using C = CommandKind;
    numbers({of(C::none), of(C::start), of(C::pause), of(C::resume), of(C::confirmHold), of(C::stopForce),
             of(C::rearm), of(C::mark), of(C::end), of(C::report), of(C::present), of(C::answer)});
    using R = ReportField;
    numbers({of(R::found), of(R::size), of(R::hardness), of(R::confidence), of(R::remove), of(R::select),
             of(R::done)});
    using S = chiron::simulation::ProcedureStage;
    numbers({of(S::outside), of(S::insertion), of(S::inspection), of(S::withdrawal), of(S::completed)});
    using L = LaparoscopyStep;
    numbers({of(L::none), of(L::grasp), of(L::stretch), of(L::hold), of(L::handOver), of(L::lift),
             of(L::carry), of(L::place), of(L::done), of(L::retract)});
    QCOMPARE(kLastLaparoscopyStep, of(L::retract));
    {
        using namespace guard_bits;
        bits({kCap, kSlew, kArming, kOverVelocity, kBadSample, kSampleFault, kWatchdog, kWatchdogFault, kStop,
              kHeartbeat, kPassivity, kNotFinite, kDeviceFault, kPause});
    }
    {
        using namespace event_bits;
        bits({kSceneChanged, kTrialStarted, kMarked, kTimedOut, kContactBegan, kContactEnded, kFinished,
              kCompleted, kStageChanged, chiron::simulation::procedure_bits::kLandmarkSeen, kGrasped,
              kReleased, kSlipped, kDamaged, kFailed, kSlowApplied});
    }
    {
        using namespace sample_status;
        bits({kMeasuredForce, kSaturated, kHomed, kDeviceFault, kInvalid});
        QCOMPARE(kRefused, 0x8000'0000U);
    }
    bits({contact_bits::kBeyondChecked, contact_bits::kYielded, contact_bits::kThrough});
    QCOMPARE(kContactStatusShift, 28);
    QCOMPARE(kContactStatusMask, 0x7000'0000U);
    QCOMPARE(contactStatus(0xff), 0x7000'0000U);
    QCOMPARE(contactOfStatus(0xa000'0007U), std::uint8_t{2});
    bits({kButtonMark, kButtonStop, kButtonDeadMan, kButtonReport});
    QCOMPARE(kMaxTools, 4);
    QCOMPARE(kMaxCoordinates, 8);
    QCOMPARE(kMaxQuantities, std::size_t{20});
    QCOMPARE(kMaxCommandsPerTick, 2);
    QCOMPARE(kMaxFindings, std::size_t{8});
    QCOMPARE(kMaxShownLumps, std::size_t{6});
    QCOMPARE(kFrameLayoutVersion, 2U);
    QCOMPARE(HapticFrame{}.layout, 2U);
    QCOMPARE(sizeof(HapticFrame), std::size_t{1152});
    QCOMPARE(reportWord(ReportField::confidence, 0xfff5), std::uint16_t{0x3ff5});
    QVERIFY(reportField(0x5007) == ReportField::select && reportValue(0x5007) == 7U);
    QCOMPARE(reportButtons(0x2003), 0x2003'0008U);
    QCOMPARE(encode({0x1abc, 0x1d}), std::uint16_t{0xdabc});
    QVERIFY((decodePresentation(0xdabc) == PresentationWord{0xabc, 0xd}));
    QCOMPARE(PresentationWord::kCandidates, 4096);
    QCOMPARE(PresentationWord::kArrangements, 16);
    QCOMPARE(Random::kName, std::string_view("chiron-xoshiro256pp-1"));
}

/// What a scene does not say is nothing: no mark, no bar, no place.
void TestCore::nothingIsShownUnlessSaid() {
    std::vector<double> numbers;
    chiron::tests::addCueNumbers(numbers, VisibleCues{});
    for (std::size_t i = 0; i < numbers.size(); ++i)
        QVERIFY2(numbers[i] == 0.0 || numbers[i] == 1.0 || numbers[i] == -1.0,
                 qPrintable(QString::number(i)));
    QCOMPARE(std::count(numbers.begin(), numbers.end(), 1.0),
             static_cast<std::ptrdiff_t>(LaparoscopyCues::kMaxBodies)); // that each is not turned
    for (const BodyCue& body : LaparoscopyCues{}.body)
        QCOMPARE(body.q_W, (std::array<double, 4>{1.0, 0.0, 0.0, 0.0}));
    QCOMPARE(std::count(numbers.begin(), numbers.end(), -1.0), std::ptrdiff_t{1});
    QCOMPARE(chiron::simulation::PalpationCues{}.selected, -1);
    const HapticFrame frame;
    QVERIFY(frame.tools == 0 && frame.header.index == 0 && frame.header.now_ns == 0 &&
            frame.header.events == 0 && frame.header.guards == 0 && frame.header.trial == 0);
    QVERIFY(frame.header.heartbeatAge_ms == 0 && frame.header.phase == TrialPhase::idle &&
            frame.header.force == ForceState::off && frame.header.paused == 0 && frame.header.reserved == 0);
    QVERIFY(frame.header.energySupplied_J == 0.0 && frame.header.energyStored_J == 0.0);
    for (const ToolFrame& tool : frame.tool)
        QVERIFY(tool.jawCounts == 0 && tool.buttons == 0 && tool.packet == 0 && tool.status == 0 &&
                tool.deviceTime_us == 0 && tool.age_us == 0 && tool.reserved == 0);
}

void TestCore::unitsAreThoseOfSi() {
    QCOMPARE(mmFromM(0.25), 250.0);
    QCOMPARE(mFromMm(250.0), 0.25);
    QVERIFY(std::abs(degFromRad(kPi / 3.0) - 60.0) < 1e-13 && std::abs(radFromDeg(60.0) - kPi / 3.0) < 1e-15);
    QCOMPARE(std::sin(kPi / 2.0), 1.0);
    QCOMPARE(kStandardGravity, 9.80665);
    QCOMPARE(kTickSeconds, 0.001);
}

namespace {
struct OwnParameters {
    int trials = 3;
};
struct OtherParameters {};
struct OwnCues {
    double depth_m = -1.0;
    int layer = 7;
};
struct OtherCues {
    int step = 2;
};
} // namespace

void TestCore::parametersAreReadByWhoKnowsThem() {
    QVERIFY(!ExerciseParameters().find<OwnParameters>());
    ExerciseParameters held(OwnParameters{5});
    QCOMPARE(held.as<OwnParameters>().trials, 5);
    QVERIFY(held.find<OwnParameters>() && !held.find<OtherParameters>());
    QVERIFY_EXCEPTION_THROWN((void)held.as<OtherParameters>(), std::bad_any_cast);
    ExerciseParameters copy = held; // a value: what is changed in one stays in it
    copy.as<OwnParameters>().trials = 9;
    QVERIFY(held.as<OwnParameters>().trials == 5 && copy.as<OwnParameters>().trials == 9);
    held = OtherParameters{};
    QVERIFY(held.find<OtherParameters>() && !held.find<OwnParameters>());
}

void TestCore::cuesAreOneTypeAtATime() {
    ExerciseCues cues;
    QVERIFY(!cues.holds<OwnCues>() && cues.of<OwnCues>().depth_m == -1.0 && cues.of<OwnCues>().layer == 7);
    cues.own<OwnCues>().depth_m = 0.02;
    QVERIFY(cues.holds<OwnCues>() && cues.of<OwnCues>().depth_m == 0.02 && cues.own<OwnCues>().layer == 7);
    const ExerciseCues copy = cues;
    cues.own<OtherCues>().step = 4; // begins with that type's own values
    QVERIFY(!cues.holds<OwnCues>() && cues.of<OtherCues>().step == 4 && cues.of<OwnCues>().depth_m == -1.0);
    cues.own<OwnCues>();
    QCOMPARE(cues.of<OwnCues>().depth_m, -1.0);
    QCOMPARE(copy.of<OwnCues>().depth_m, 0.02);
}

void TestCore::namesOfABuild() {
    QCOMPARE(forcesOfBuild("1.2 gcc 12.2 models 3"), std::string("gcc 12.2 models 3"));
    QCOMPARE(forcesOfBuild("a name of its own"), std::string("a name of its own"));
    QCOMPARE(modelsOfBuild("1.2 gcc 12.2 models 3"), std::string("3"));
    QCOMPARE(modelsOfBuild("1.2 models 2 gcc models 41"), std::string("41"));
    QCOMPARE(modelsOfBuild("1.2 gcc 12.2"), std::string());
    QVERIFY(!modelsOfBuild(buildId()).empty() && forcesOfBuild(buildId()).rfind("gcc ", 0) == 0);
    QCOMPARE(cpuClass().rfind("x86-64", 0), std::size_t{0});
    QCOMPARE(cpuClass().find("+fma") != std::string::npos, __builtin_cpu_supports("fma") != 0);
    QCOMPARE(cpuClass().find("+avx2") != std::string::npos, __builtin_cpu_supports("avx2") != 0);
    QCOMPARE(cpuClass().find("+avx512f") != std::string::npos, __builtin_cpu_supports("avx512f") != 0);
}

/// Value by value; a left-handed person's picture is the level's mirrored.
void TestCore::whatSaysNothingTakesTheUsual() {
    BaseMounting usual;
    usual.scale = 2.0;
    usual.origin_m = {0.01, 0.0, -0.02};
    usual.leftHanded = true;
    usual.turn_rad = {0.1, 0.2, 0.0};
    const BaseMounting silent;
    QVERIFY(!silent.turned() && usual.turned());
    const BaseMounting taken = silent.over(usual);
    QVERIFY(taken.scale == 2.0 && taken.origin_m == usual.origin_m && taken.leftHanded &&
            taken.turn_rad == usual.turn_rad);
    BaseMounting own;
    own.scale = 0.5;
    own.origin_m = {0.0, 0.005, 0.0};
    own.leftHanded = true;
    own.turn_rad = {0.0, 0.0, 0.3};
    const BaseMounting kept = own.over(usual);
    QVERIFY(kept.scale == 0.5 && kept.origin_m == own.origin_m && !kept.leftHanded &&
            kept.turn_rad == own.turn_rad);
    BaseMounting straight;
    straight.turnGiven = true;
    QVERIFY(!straight.over(usual).turned() && straight.over(usual).turnGiven);
    QVERIFY(own.over(silent).leftHanded && !silent.over(silent).leftHanded);
    QVERIFY(BaseMounting::kSmallestScale == 0.25 && BaseMounting::kLargestScale == 4.0 &&
            BaseMounting::kLargestShift_m == 0.030);
    QVERIFY(std::abs(BaseMounting::kLargestTurn_rad - 0.25 * kPi) < 1e-15);
}

void TestCore::findingsAreBooked() {
    FindingsBook book;
    QVERIFY(book.selected() == FindingsBook::kNone && !book.done() && !book.has(0) && !book.has(-1));
    QCOMPARE(book.report(ReportField::size, 5), FindingsBook::kNone); // about nothing
    for (int i = 0; i < static_cast<int>(kMaxFindings); ++i) {
        QCOMPARE(book.found({0.1 * i, 0.0, 1.0}), i);
        QCOMPARE(book.selected(), i);
    }
    QCOMPARE(book.found({}), FindingsBook::kNone); // no room
    QCOMPARE(book.selected(), 7);
    QVERIFY(book.has(7) && !book.has(8));
    QCOMPARE(book.report(ReportField::select, 8), FindingsBook::kNone);
    QCOMPARE(book.report(ReportField::select, 2), 2);
    QCOMPARE(book.report(ReportField::size, 75), 2);
    QCOMPARE(book.report(ReportField::hardness, 5), 2);
    QCOMPARE(book.report(ReportField::hardness, 6), FindingsBook::kNone);
    QCOMPARE(book.report(ReportField::confidence, 1), 2);
    QCOMPARE(book.report(ReportField::found, 3), FindingsBook::kNone);
    const Finding& two = book.list()[2];
    QVERIFY(two.present && two.p_W[0] == 0.2 && std::abs(two.radius_m - 0.0075) < 1e-15 &&
            two.hardness == 5 && two.confidence == 1);
    QCOMPARE(book.rate(3, ReportField::size, 9999), 3); // no more than a word holds
    QVERIFY(std::abs(book.list()[3].radius_m - 0.4095) < 1e-12);
    QCOMPARE(book.rate(-1, ReportField::size, 1), FindingsBook::kNone);
    QCOMPARE(book.report(ReportField::remove, 5), 5); // another one stays selected
    QCOMPARE(book.selected(), 2);
    QCOMPARE(book.report(ReportField::remove, 5), FindingsBook::kNone);
    QCOMPARE(book.report(ReportField::remove, 2), 2);
    QCOMPARE(book.selected(), FindingsBook::kNone);
    QVERIFY(!book.list()[2].present && book.list()[2].hardness == 0);
    QCOMPARE(book.found({9.0, 0.0, 0.0}), 2); // the first free place
    book.place(5, {5.0, 5.0, 5.0});
    QVERIFY(book.has(5) && book.selected() == 5 && book.list()[5].p_W[2] == 5.0);
    book.place(8, {});
    book.place(-1, {});
    QCOMPARE(book.selected(), 5);
    QCOMPARE(book.report(ReportField::done, 0), FindingsBook::kNone);
    QVERIFY(book.done());
    book.clear();
    QVERIFY(!book.done() && !book.has(5) && book.selected() == FindingsBook::kNone);
}

/// y = 2 x0 − 3 x1 + 0.5 x2 and a known error: slopes, what is left, and the first slope's standard error by
/// the textbook's formula.
void TestCore::leastSquaresFindTheSlopes() {
    LeastSquares<3> fit;
    double xx[3][3] = {}, rest = 0.0;
    for (int n = 0; n < 80; ++n) {
        QCOMPARE(fit.samples(), n);
        QCOMPARE(fit.solve().good, n >= LeastSquares<3>::kFewest);
        QCOMPARE(fit.solve().n, n);
        const std::array<double, 3> x{std::sin(0.7 * n), 10.0 * std::cos(0.3 * n), 0.01 * (n % 7)};
        fit.add(x, 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2]);
    }
    const auto exact = fit.solve();
    QVERIFY(exact.good && std::abs(exact.slope[0] - 2.0) < 1e-9 && std::abs(exact.slope[1] + 3.0) < 1e-9 &&
            std::abs(exact.slope[2] - 0.5) < 1e-6);
    QVERIFY(exact.residual < 1e-8 && exact.residual >= 0.0);

    // With an error across the regressors: the slopes of the normal equations solved by Cramer's rule.
    fit.reset();
    QCOMPARE(fit.samples(), 0);
    std::vector<std::pair<std::array<double, 3>, double>> rows;
    double xy[3] = {};
    for (int n = 0; n < 100; ++n) {
        const std::array<double, 3> x{std::sin(0.7 * n), std::cos(0.3 * n), 0.3 * (n % 7) - 0.9};
        const double y = 2.0 * x[0] - 3.0 * x[1] + 0.5 * x[2] + (n % 2 == 0 ? 0.2 : -0.15);
        fit.add(x, y);
        rows.emplace_back(x, y);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                xx[i][j] += x[static_cast<std::size_t>(i)] * x[static_cast<std::size_t>(j)];
            xy[i] += x[static_cast<std::size_t>(i)] * y;
        }
    }
    const auto det = [](const double(&m)[3][3]) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    const auto found = fit.solve();
    std::array<double, 3> slope{};
    for (std::size_t i = 0; i < 3; ++i) {
        double with[3][3];
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                with[r][c] = static_cast<std::size_t>(c) == i ? xy[r] : xx[r][c];
        slope[i] = det(with) / det(xx);
        QVERIFY(std::abs(found.slope[i] - slope[i]) < 1e-9);
    }
    for (const auto& [x, y] : rows) {
        const double error = y - slope[0] * x[0] - slope[1] * x[1] - slope[2] * x[2];
        rest += error * error;
    }
    QVERIFY(std::abs(found.residual / rest - 1.0) < 1e-9);
    const double first = (xx[1][1] * xx[2][2] - xx[1][2] * xx[2][1]) / det(xx); // of the inverse
    QVERIFY(std::abs(found.firstSd / std::sqrt(rest / 97.0 * first) - 1.0) < 1e-9);

    LeastSquares<2> idle; // a regressor that never moved gets no weight
    for (int n = 0; n < 60; ++n)
        idle.add({std::sin(1.0 * n), 0.0}, std::sin(1.0 * n));
    QVERIFY(idle.solve().good && idle.solve().slope[1] == 0.0 &&
            std::abs(idle.solve().slope[0] - 1.0) < 1e-9);
    LeastSquares<2> nothing;
    for (int n = 0; n < 60; ++n)
        nothing.add({0.0, 0.0}, 1.0);
    QVERIFY(!nothing.solve().good);
}

QTEST_APPLESS_MAIN(TestCore)
#include "test_core.moc"
