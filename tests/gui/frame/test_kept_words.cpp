// SPDX-License-Identifier: GPL-3.0-or-later
// What the desktop says, at the edges of what it says it of: every state, refusal and finding, every step of
// an exercise, numbers on both sides of where their words change; against what was read and kept. A change
// that is meant is kept anew, and the difference is read in review: CHIRON_STORE_OUTLINES=1
// QT_QPA_PLATFORM=offscreen build/release/tests/gui/frame/test_kept_words
#include "app/exercises/elastic_tube/desktop/tube_grasping.h"
#include "app/exercises/object_handling/desktop/handling_grasping.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "app/exercises/palpation/session/palpation_marks.h"
#include "app/exercises/sphere_apex/session/apex_marks.h"
#include "app/exercises/urethra_insertion/desktop/stage_words.h"
#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "database/accounts/account_service.h"
#include "database/upkeep/upkeep.h"
#include "desktop/accounts/account_words.h"
#include "desktop/debrief/verdict.h"
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/exercise_setup/level_facts.h"
#include "desktop/frame/messages.h"
#include "desktop/home/exercise_card.h"
#include "desktop/playback/mark_look.h"
#include "desktop/plots/session_token_words.h"
#include "desktop/sessions/session_words.h"
#include "desktop/station/platform_check.h"
#include "desktop/station/platform_words.h"
#include "desktop/station/station_words.h"
#include "desktop/storage/storage_words.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/freeze_checks.h"
#include "desktop/studies/new_study_dialog.h"
#include "desktop/studies/number_list.h"
#include "desktop/studies/participant_card.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_words.h"
#include "desktop/training/force_words.h"
#include "desktop/training/grasping.h"
#include "desktop/training/scene_feed.h"
#include "desktop/training/sound_cue_player.h"
#include "desktop/training/training_plan.h"
#include "desktop/training/training_words.h"
#include "devices/driver_catalogue.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "support/kept_text.h"
#include "support/languages.h"

#include <QtTest>
#include <set>
#include <tuple>

using namespace chiron;
using namespace chiron::desktop;
using database::SessionState;

class TestKeptWords : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("TZ", "UTC"); }
    void init() { m_lines.clear(); }

    void sessions() {
        for (int s = 0; s <= static_cast<int>(SessionState::voided); ++s) {
            const auto state = static_cast<SessionState>(s);
            say({SessionWords::state(state), QLatin1String(SessionWords::sign(state).icon), stateTitle(state),
                 stateIcon(state)});
            for (const auto passed : {std::optional<bool>(), std::optional(true), std::optional(false)})
                for (const bool practice : {false, true}) {
                    database::SessionSummary session;
                    session.state = state;
                    session.passed = passed;
                    session.familiarisation = practice;
                    const Outcome outcome = SessionWords::outcomeOf(session);
                    say({QStringLiteral("%1%2")
                             .arg(passed ? int(*passed) : -1)
                             .arg(practice ? QStringLiteral(" practice") : QString()),
                         SessionWords::outcome(outcome), QLatin1String(SessionWords::sign(outcome).icon),
                         QString::number(static_cast<int>(SessionWords::sign(outcome).ink)),
                         outcomeText(session), outcomeIcon(session)});
                }
        }
        for (const bool felt : {false, true})
            for (const char* of : {"", "expert", "somebody"}) {
                database::SessionSummary session;
                session.felt = felt;
                session.operatorName = of;
                session.personName = "Tina";
                say({SessionWords::device(felt), feltText(felt), forceText(session), whoText(session)});
            }
        for (const auto& [driver, kinematics] : {std::pair{"simulated", "fingertip_arm"},
                                                 {"simulated", "five_bar_spherical"},
                                                 {"simulated", "gimbal_hprd"},
                                                 {"keyboard_mouse", ""},
                                                 {"replay", ""},
                                                 {"other", ""}}) {
            devices::DeviceDescriptor device;
            device.driver = driver;
            device.kinematics = kinematics;
            device.model = "A model";
            say({deviceText(device)});
        }
        for (const std::uint64_t ticks :
             {0ULL, 999ULL, 59'999ULL, 60'000ULL, 61'000ULL, 600'000ULL, 3'725'999ULL})
            say({QStringLiteral("%1 ticks").arg(ticks), SessionWords::length(ticks, m_locale)});
        for (const double t_s : {-1.0, 0.0, 0.05, 0.1, 9.94, 9.95, 10.0, 59.99, 60.0, 119.9999999, 3600.0})
            say({QStringLiteral("%1 s").arg(t_s, 0, 'g', 12), clockText(t_s, m_locale),
                 clockText(t_s, QLocale(QLocale::German))});
        const QDateTime now(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);
        for (const qint64 seconds : {-5LL, 0LL, 59LL, 60LL, 119LL, 3599LL, 3600LL, 7200LL, 172'799LL,
                                     172'800LL, 259'200LL, 2'678'400LL, 2'764'799LL, 2'764'800LL})
            say({QStringLiteral("%1 s ago").arg(seconds),
                 SessionWords::ago(now.addSecs(-seconds), now, m_locale)});
        for (const std::uint64_t bytes : {0ULL, 999ULL, 1'000ULL, 1'550'000ULL, 7'000'000'000ULL})
            say({SessionWords::bytes(bytes, m_locale)});
        for (const char* started : {"2026-11-19T23:30:00.000Z", "not a time"})
            for (const int offset : {0, 60, -90}) {
                database::SessionSummary session;
                session.startedUtc = started;
                session.utcOffset_min = offset;
                say({SessionWords::started(session, m_locale), whenText(session, m_locale)});
            }
        hold("sessions");
    }

    void marks() {
        using namespace session::mark_kinds;
        std::set<std::string_view> ids;
        for (const session::PlaybackMarkKind& kind :
             {kTrialStarted, kMarked,     kTimedOut,  kTraceEnded, kContact,    kOverLimit, kPaused,
              kForceStopped, kRearmed,    kGuard,     kFault,      kEnded,      kCompleted, kStageChanged,
              kLandmarkSeen, kTrauma,     kReversal,  kOffCentre,  kOverTorque, kGrasped,   kReleased,
              kSlipped,      kDamaged,    kFound,     kTakenBack,  kYielded,    kFailed,    kLimited,
              kMissed,       kFalseAlarm, kLumpMissed}) {
            QVERIFY(ids.insert(kind.id).second);
            session::PlaybackMark mark;
            mark.kind = kind;
            const QString plain = markIcon(mark);
            mark.critical = true;
            say({QString::fromUtf8(kind.id.data(), qsizetype(kind.id.size())), plain, markIcon(mark),
                 QString::number(static_cast<int>(markColour(mark.kind)))});
        }
        hold("marks");
    }

    void accountsAndErrors() {
        for (const database::Role role : database::kAllRoles)
            say({roleName(role)});
        for (const auto kind : {database::Refusal::Kind::wrong, database::Refusal::Kind::mustWait,
                                database::Refusal::Kind::disabled, database::Refusal::Kind::failed}) {
            database::Refusal refusal;
            refusal.kind = kind;
            refusal.error = {core::ErrorCode::storage, "no room"};
            say({refusalWords(refusal), recoveryRefusalWords(refusal)});
        }
        for (const int seconds : {1, 2, 61})
            say({waitWords(seconds)});
        for (const core::ErrorCode code :
             {core::ErrorCode::notAllowed, core::ErrorCode::notFound, core::ErrorCode::storage,
              core::ErrorCode::locked, core::ErrorCode::device, core::ErrorCode::cancelled,
              core::ErrorCode::doesNotHold, core::ErrorCode::wrongUse, core::ErrorCode::badInput})
            say({inWords({code, "details"}), inWords({code, "details"}, Tried::reading),
                 inWords({code, "details"}, Tried::opening)});
        Messages messages;
        connect(&messages, &Messages::told, this, [this](const Message& message) {
            say({QString::number(static_cast<int>(message.kind)), message.text, message.actionText,
                 message.action ? QStringLiteral("acts") : QString()});
        });
        messages.done(QStringLiteral("done"));
        messages.information(QStringLiteral("information"));
        messages.warning(QStringLiteral("warning"));
        messages.error(QStringLiteral("It was not done."), {core::ErrorCode::locked, "by another"});
        hold("accounts and errors");
    }

    void station() {
        for (const devices::Driver* driver : devices::driverCatalogue())
            say({StationWords::driver(*driver), StationWords::needs(*driver)});
        say({StationWords::forceClass(devices::DeviceClass::felt),
             StationWords::forceClass(devices::DeviceClass::shown)});
        for (const bool yes : {false, true})
            say({StationWords::priority(yes), StationWords::memory(yes)});
        for (const auto& [ticks, late, skipped] : {std::tuple{0ULL, 0ULL, 0ULL},
                                                   {100'000ULL, 0ULL, 0ULL},
                                                   {100'000ULL, 4ULL, 0ULL},
                                                   {100'000ULL, 100ULL, 0ULL},
                                                   {100'000ULL, 300ULL, 0ULL},
                                                   {100'000ULL, 301ULL, 0ULL},
                                                   {100'000ULL, 0ULL, 1ULL},
                                                   {100'000ULL, 0ULL, 5'000'000'000ULL}}) {
            session::LoopReport loop;
            loop.ticks = ticks;
            loop.late = late;
            loop.skipped = skipped;
            loop.p50_us = 12.34;
            loop.max_us = 210.0;
            say({QLatin1String(StationWords::verdictKind(loop)), StationWords::verdict(loop, m_locale),
                 StationWords::punctuality(loop, m_locale)});
        }
        hold("station");
    }

    void platform() {
        PlatformCheck check;
        check.verified.rmse_N = {0.0123, 0.0234, 0.0345};
        check.verified.rmseTrue_N = {0.0124, 0.0235, 0.0346};
        check.verified.meanRmse_N = 0.0234;
        check.verified.meanRmseTrue_N = 0.0235;
        check.verified.meanError_deg = 0.51;
        check.verified.meanErrorTrue_deg = 0.52;
        check.verified.sdError_deg = 0.11;
        check.verified.sdErrorTrue_deg = 0.12;
        check.verified.overshoot = 0.031;
        check.verified.overshootOfForce = 0.021;
        check.verified.oneNewton_N = 1.04;
        check.verified.largest_N = 4.12;
        check.verified.latency_s = 0.0123;
        check.verified.gain = 0.987;
        check.verified.phase_deg = -12.3;
        check.friction.coulomb_N = 0.123;
        check.friction.viscous_Ns_per_m = 1.23;
        check.stiffnessCap_N_per_m = 2345.0;
        for (const char* finger :
             {"half", "double", "thick", "thin", "relaxing", "softest", "stiffest", "other"}) {
            mechanisms::FingertipOnFinger on;
            on.finger = finger;
            on.verified = check.verified;
            on.verified.meanRmseTrue_N *= 1.0 + 0.1 * double(check.fingers.size());
            on.verified.largest_N += 0.1;
            check.fingers.push_back(on);
        }
        for (const char* what : {"force_noise", "adc", "delay", "friction", "backlash", "imu", "other"})
            for (const double factor : {0.0, 2.5}) {
                mechanisms::FingertipDegradation row;
                row.what = what;
                row.factor = factor;
                row.rmse_N = 0.03;
                row.meanError_deg = 0.6;
                row.holds = factor == 0.0;
                check.worse.push_back(row);
            }
        say({platformVerdict(check, m_locale)});
        say(platformFacts(check, m_locale));
        for (const report::CheckTable& table :
             {platformFigures(check, m_locale), platformFingers(check, m_locale),
              platformDegradation(check, m_locale)}) {
            say({table.title});
            for (const QStringList& line : table.lines)
                say(line);
        }
        hold("platform");
    }

    void storage() {
        session::StorageRoom room{0, 50ULL << 30, 100ULL << 30, 1ULL << 30, 4ULL << 20};
        const auto told = [&] {
            const StorageNotice notice = StorageWords::room(room, m_locale);
            say({QLatin1String(notice.kind), notice.text});
        };
        told();
        for (const std::uint64_t free :
             {session::kLowDisk_bytes, session::kLowDisk_bytes - 1, std::uint64_t{1}}) {
            room.diskFree_bytes = free;
            told();
        }
        for (const std::uint64_t free :
             {2 * room.ringNeeded_bytes, room.ringNeeded_bytes, room.ringNeeded_bytes - 1}) {
            room.ringFree_bytes = free;
            for (const std::uint64_t disk : {std::uint64_t{50ULL << 30}, session::kLowDisk_bytes - 1}) {
                room.diskFree_bytes = disk;
                told();
            }
        }
        const QDateTime now(QDate(2026, 11, 20), QTime(12, 0), Qt::UTC);
        for (const char* made :
             {"", "2026-11-20T11:59:30.000Z", "2026-11-13T12:00:00.000Z", "2026-11-12T12:00:00.000Z"}) {
            const StorageNotice notice = StorageWords::backup(made, now, m_locale);
            say({QLatin1String(notice.kind), notice.text});
        }
        for (const char* kind : {"file", "database", "integrity", "foreign_key", "digest", "payload",
                                 "missing", "unreadable", "seal", "audit", "score", "other"})
            say({StorageWords::findingKind(kind)});
        database::VerifyReport report;
        report.rowsChecked = 12'345;
        for (const int wrong : {0, 1, 3}) {
            report.findings.resize(static_cast<std::size_t>(wrong));
            for (const bool cancelled : {false, true}) {
                report.cancelled = cancelled;
                const StorageNotice notice = StorageWords::verified(report, m_locale);
                say({QLatin1String(notice.kind), notice.text});
            }
        }
        hold("storage");
    }

    void studies() {
        using namespace study_words;
        using psychophysics::Attribute;
        for (int a = 0; a <= static_cast<int>(Attribute::apex); ++a) {
            const auto attribute = static_cast<Attribute>(a);
            say({study_words::attribute(attribute), value(0.0123, attribute, m_locale),
                 value(312.4, attribute, m_locale)});
        }
        for (int t = 0; t < psychophysics::kTasks; ++t)
            say({task(static_cast<psychophysics::Task>(t)), taskInWords(static_cast<psychophysics::Task>(t)),
                 question(static_cast<psychophysics::Task>(t), Attribute::mass)});
        for (const char* id :
             {"staircase@1", "pest", "constant", "descending", "quest", "quest_plus@3", "rank3_quest_plus",
              "rank3_quest_plus_ties", "limit", "of_another", "staircase@1,limit@2"})
            say({procedure(id), procedureInWords(id)});
        for (const char* token : {"force_error", "stopped", "withheld", "of_another"})
            say({spoiled(token), parameter(token)});
        for (const char* name : {"threshold", "slope", "lapse", "tie"})
            say({parameter(name)});
        for (const double x : {0.0, -0.0, 1e-5, 0.01234, 1.0, 12.345, 1234.5, -3.75, 1e7, std::nan(""),
                               std::numeric_limits<double>::infinity()})
            say({number(x, m_locale), number(x, m_locale, 1), plainNumber(x, m_locale), percent(x, m_locale),
                 interval(x, 2.0 * x, m_locale), intervalPercent(x, 2.0 * x, m_locale)});
        for (const char* utc : {"2026-11-19T23:30:00.000Z", "not a time", ""})
            say({moment(utc, m_locale)});
        say({shortSha("0123456789abcdef0123456789abcdef"), shortSha("01")});
        for (const char* language : tests::languageIds())
            say({text({{"en", "a stone"}, {"de", "ein Stein"}}, QLatin1String(language)),
                 text({}, QLatin1String(language))});
        say({listText({0.5, 2.0, 0.125}, m_locale), listText({}, m_locale),
             listText(readNumbers(QStringLiteral(" 1; 2"), m_locale).values, m_locale),
             unreadWords(readNumbers(QStringLiteral(" 1; ;x;2"), m_locale))});
        hold("studies");
    }

    /// What participants meet in a study, as its researcher and they themselves are told.
    void participants() {
        using psychophysics::StudyDesign;
        using When = psychophysics::Questionnaire::When;
        const auto told = [this](const StudyDesign& design, const QString& what) {
            say({QStringLiteral("## %1").arg(what)});
            for (const auto& [name, words] : participantFacts(design, m_locale, QStringLiteral("en")))
                say({name, words});
            for (const QString& sentence : participantSentences(design, QStringLiteral("en")))
                say({sentence});
        };
        for (int t = 0; t < psychophysics::kTasks; ++t) {
            StudyDesign design = plainStudy(static_cast<psychophysics::Task>(t));
            told(design, QStringLiteral("task %1").arg(t));
            design.trial.mustTouchAll = true;
            design.conditions.push_back(design.conditions.front());
            design.conditions.back().id = "another";
            told(design, QStringLiteral("twice"));
        }
        using Change = std::function<void(StudyDesign&)>;
        const auto asks = [](When when, int questions) {
            psychophysics::Questionnaire asked;
            asked.id = "questions";
            asked.when = when;
            asked.items.resize(static_cast<std::size_t>(questions));
            return asked;
        };
        for (const auto& [what, change] :
             {std::pair<const char*, Change>{"no practice, no end, no breaks",
                                             [](StudyDesign& d) {
                                                 d.trial.practiceTrials = d.trial.breakEvery = 0;
                                                 d.trial.exploreLimit_s = 0.0;
                                             }},
              {"one to practise on, feedback, no end of answering",
               [](StudyDesign& d) {
                   d.trial.practiceTrials = 1;
                   d.trial.feedback = true;
                   d.trial.exploreLimit_s = 12.5;
                   d.trial.answerLimit_s = 0.0;
               }},
              {"short breaks",
               [](StudyDesign& d) {
                   d.trial.breakEvery = 1;
                   d.trial.breakAtLeast_s = 1.0;
               }},
              {"nothing seen or heard",
               [](StudyDesign& d) { d.trial.visibleObjects = d.trial.maskingSound = false; }},
              {"not all have to be touched", [](StudyDesign& d) { d.trial.mustTouchAll = false; }},
              {"any graze counts", [](StudyDesign& d) { d.trial.probeAtLeast_N = 0.0; }},
              {"asked before and after",
               [&](StudyDesign& d) {
                   d.questionnaires = {asks(When::before, 2), asks(When::after, 2)};
               }},
              {"asked after", [&](StudyDesign& d) { d.questionnaires = {asks(When::after, 1)}; }},
              {"asked about each", [&](StudyDesign& d) {
                   d.questionnaires = {asks(When::before, 1), asks(When::afterCondition, 2),
                                       asks(When::after, 3), asks(When::enrolment, 5)};
               }}}) {
            StudyDesign design = plainStudy();
            change(design);
            told(design, QLatin1String(what));
        }
        StudyDesign apex = plainStudy();
        psychophysics::Condition& sphere = apex.conditions.front();
        sphere.stimulus = {psychophysics::Attribute::apex, 0.02, {0.0}, {{"stiffness_N_per_m", 500.0}}};
        sphere.task = psychophysics::Task::adjustment;
        sphere.procedures = {psychophysics::ConstantSpec{{0.0}, 10, true}};
        told(apex, QStringLiteral("apex"));
        hold("participants");
    }

    /// What is looked at before a design is frozen, at the edges of each finding.
    void freezing() {
        using psychophysics::OrderDesign;
        psychophysics::StudyDesign design = plainStudy();
        FreezeFacts facts;
        const auto told = [&](const QString& what, const char* only = nullptr) {
            say({QStringLiteral("## %1").arg(what)});
            for (const FreezeCheck& check : freezeChecks(design, facts, m_locale))
                if (!only || check.name == QLatin1String(only))
                    say({check.name, QString::number(static_cast<int>(check.state)), check.title, check.words,
                         QString::number(check.tab), QString::number(check.condition), check.field});
        };
        told(QStringLiteral("a plain study"));
        for (const int letters : {0, 119, 120}) {
            design.consent["en"] = std::string(static_cast<std::size_t>(letters), 'x');
            told(QStringLiteral("%1 letters").arg(letters), "consent");
        }
        design.ethics = "Approved.";
        told(QStringLiteral("approved"), "ethics");
        for (const int conditions : {1, 2, 3, 4}) {
            design.conditions.resize(static_cast<std::size_t>(conditions), design.conditions.front());
            QStringList by;
            for (const OrderDesign order :
                 {OrderDesign::fixed, OrderDesign::random, OrderDesign::latinSquare, OrderDesign::williams}) {
                design.order = order;
                by << QString::number(balancedBy(design));
            }
            say({QStringLiteral("%1 conditions are balanced by").arg(conditions), by.join(QLatin1Char(' '))});
        }
        for (const int planned : {0, 1, 2, 4, 6}) { // of four conditions in a Williams design
            design.participantsPlanned = planned;
            told(QStringLiteral("%1 planned").arg(planned), "participants");
        }
        for (const int practice : {0, 1}) {
            design.trial.practiceTrials = practice;
            told(QStringLiteral("%1 to practise on").arg(practice), "practice");
        }
        for (const int pilots : {0, 1}) {
            facts.pilots = pilots;
            told(QStringLiteral("tried %1 times").arg(pilots), "pilot");
        }
        for (const int conditions : {1, 2}) {
            design.conditions.resize(static_cast<std::size_t>(conditions));
            for (const auto& [minutes, sdLog10] : {std::pair{0.0, std::nan("")},
                                                   {20.5, 0.02},
                                                   {60.0 / conditions, 0.08},
                                                   {60.1 / conditions, 0.3},
                                                   {90.0, 1.0}}) {
                psychophysics::ConditionPlan plan;
                plan.minutes = minutes;
                plan.sdLog10 = sdLog10;
                plan.sdError = 0.1 * sdLog10;
                facts.plans.emplace(static_cast<std::size_t>(conditions), plan);
                if (conditions > 1)
                    facts.plans->front().sdLog10 *= 0.5; // the worst counts
                const QString what =
                    QStringLiteral("%1 x %2 min, %3").arg(conditions).arg(minutes).arg(sdLog10);
                told(what, "duration");
                told(what, "precision");
            }
        }
        hold("freezing");
    }

    void force() {
        haptics::DisplayState state;
        const auto told = [&](const QString& what, const AskedFor& asked) {
            const ForceWords words = forceWords(state, asked, m_locale);
            say({what, QLatin1String(words.kind), words.title, words.text});
        };
        told(QStringLiteral("not begun"), {});
        told(QStringLiteral("not begun, an endoscope"), {.endoscope = true});
        state.started = true;
        state.tools = 2;
        state.gain = 0.37;
        for (int f = 0; f <= static_cast<int>(core::ForceState::fault); ++f) {
            state.force = static_cast<core::ForceState>(f);
            const QString name = QString::number(f);
            told(name, {});
            told(name + QStringLiteral(" watched"), {.ownHand = false});
            told(name + QStringLiteral(" watched, shown"), {.felt = false, .ownHand = false});
            told(name + QStringLiteral(" paused"), {.paused = true});
            told(name + QStringLiteral(" stopped"), {.paused = true, .stopped = true});
            told(name + QStringLiteral(" shown"), {.felt = false});
        }
        for (std::uint32_t bit = 0; bit < 16; ++bit) {
            state.guards = 1U << bit;
            told(QStringLiteral("guard %1").arg(bit), {});
        }
        state.force = core::ForceState::arming;
        for (int w = 0; w <= static_cast<int>(haptics::ArmingWait::window) + 2; ++w) {
            state.waitsFor = static_cast<haptics::ArmingWait>(w);
            told(QStringLiteral("waits %1").arg(w), {});
        }
        state.force = core::ForceState::on;
        for (const int still : {0, 1, 2}) {
            for (int i = 0; i < 2; ++i)
                state.tool[std::size_t(i)].noMovement = i < still;
            told(QStringLiteral("%1 still").arg(still), {.felt = false});
            told(QStringLiteral("%1 still, an endoscope").arg(still), {.felt = false, .endoscope = true});
            told(QStringLiteral("%1 still, graspers").arg(still), {.felt = false, .grasper = true});
        }
        hold("force");
    }

    void stages() {
        simulation::EndoscopeCues cues;
        cues.landmarks = 5;
        for (int s = 0; s <= static_cast<int>(simulation::ProcedureStage::completed); ++s)
            for (const double depth_m : {-0.01, 0.0, 0.0324, 0.097, 0.12})
                for (const bool numbers : {false, true}) {
                    cues.stage = static_cast<simulation::ProcedureStage>(s);
                    cues.depth_m = depth_m;
                    cues.dwell = numbers ? 0.4 : 0.0;
                    cues.landmarksSeen = numbers ? 0b1011 : 0;
                    const StageTelling telling{numbers, numbers, 0.097};
                    say({stageTitle(cues.stage), stageText(cues, telling, m_locale),
                         QString::number(stageProgress(cues, telling)), QString::number(landmarksSeen(cues)),
                         QString::number(stageProgress(cues, {true, true, 0.0}))});
                }
        hold("stages");
    }

    void grasps() {
        simulation::ElasticTubeParameters tube;
        simulation::ObjectHandlingParameters handling;
        core::LaparoscopyCues cues;
        for (int s = 0; s <= core::kLastLaparoscopyStep; ++s) {
            cues.step = static_cast<core::LaparoscopyStep>(s);
            for (const auto task : {simulation::TubeTask::hold, simulation::TubeTask::stretch,
                                    simulation::TubeTask::transfer, simulation::TubeTask::twoHanded}) {
                tube.task = task;
                say({desktop::tubeGrasping(tube, {}).step(cues, m_locale)});
            }
            for (const auto task : {simulation::HandlingTask::weigh, simulation::HandlingTask{}}) {
                handling.task = task;
                say({desktop::handlingGrasping(handling, {}).step(cues, m_locale)});
            }
        }
        cues.torn = true;
        say({desktop::tubeGrasping(tube, {}).step(cues, m_locale),
             desktop::handlingGrasping(handling, {}).step(cues, m_locale)});
        cues = {};
        cues.grips = 2;
        for (const auto& [first, second, third, fold] : {std::tuple{0, 0, 0, 0},
                                                         {1, 0, 0, 0},
                                                         {1, 2, 0, 0},
                                                         {0, 0, 4, 0},
                                                         {0, 0, 0, 4},
                                                         {1, 0, 0, 4},
                                                         {1, 2, 0, 4}}) {
            cues.gripHeldBy = {std::uint8_t(first), std::uint8_t(second),
                               std::uint8_t(third)}; // the third grip is none of this tube
            cues.foldHeldBy = static_cast<std::uint8_t>(fold);
            say({desktop::tubeGrasping(tube, {}).held(cues, m_locale),
                 desktop::handlingGrasping(handling, {}).held(cues, m_locale)});
        }
        for (const int bodies : {1, 3, 9})
            for (const std::size_t held : {0U, 2U}) {
                cues = {};
                cues.bodies = bodies;
                cues.body[held].heldBy = 1;
                say({desktop::handlingGrasping(handling, {}).held(cues, m_locale)});
            }
        hold("grasps");
    }

    void palpations() {
        for (int rating = -1; rating <= 6; ++rating)
            say({hardnessWord(rating), confidenceWord(rating)});
        for (const double radius_m : {0.0, 0.0002, 0.00749, 0.0075})
            say({sizeText(radius_m, m_locale)});
        for (int asks = 0; asks < 8; ++asks) {
            simulation::PalpationCues cues;
            cues.asksSize = (asks & 1) != 0;
            cues.asksHardness = (asks & 2) != 0;
            cues.asksConfidence = (asks & 4) != 0;
            cues.finding[1] = {true, {}, 0.006, 4, 0};
            cues.finding[4] = {true, {}, 0.0, 0, 2};
            cues.finding[5].hardness = 3; // none
            say({findingText(1, cues, m_locale), findingText(4, cues, m_locale),
                 missingRatings(cues, m_locale).join(QLatin1Char('/')), QString::number(findingCount(cues))});
        }
        hold("palpations");
    }

    void training() {
        for (const char* name : {"expert", "intermediate", "novice", "hesitant", "unsafe", "somebody"})
            say({operatorTitle(name)});
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(catalogue);
        QStringList exercises;
        for (const catalogue::Exercise& exercise : catalogue->exercises())
            exercises << QString::fromStdString(exercise.id);
        exercises << QStringLiteral("of_another");
        for (const QString& exercise : exercises)
            for (const devices::MovedBy mover : {devices::MovedBy::person, devices::MovedBy::scriptedOperator,
                                                 devices::MovedBy::recording}) {
                TrainingPlan plan;
                plan.exercise = exercise;
                plan.driver = &devices::usualDriver(mover);
                plan.operatorName = QStringLiteral("novice");
                plan.traceFile = QStringLiteral("/a/folder/hand.csv");
                say({deviceTitle(plan), deviceIcon(mover)});
            }
        for (const bool own : {false, true}) {
            for (const auto tool : {session::PointerTool::point, session::PointerTool::endoscope,
                                    session::PointerTool::grasper})
                for (const int tools : {1, 2, 3})
                    say({keysInWords(own, tool, tools)});
            for (const int hands : {1, 2})
                for (const bool rates : {false, true})
                    for (const bool pinches : {false, true})
                        say({palpationKeysInWords(own, hands, rates, pinches)});
        }
        say({activeHandInWords(0), activeHandInWords(1)});
        for (const int tools : {2, 3})
            for (int tool = 0; tool < tools; ++tool)
                say({activeToolInWords(tool, tools)});
        for (const int attempts : {0, 1, 4})
            for (int passed = 0; passed < 4; ++passed) {
                session::LevelStanding standing;
                standing.attempts = attempts;
                standing.passedFelt = (passed & 1) != 0;
                standing.passedShown = (passed & 2) != 0;
                say({standingWords(standing)});
            }
        hold("training");
    }

    /// A plan goes through a map and back, whatever it is; of a map that says nothing the usual one comes.
    void plans() {
        TrainingPlan plan;
        plan.exercise = QStringLiteral("palpation");
        plan.level = 4;
        plan.operatorName = QStringLiteral("expert");
        plan.forceMap = QStringLiteral("as-published");
        plan.traceFile = QStringLiteral("/a/hand.csv");
        plan.workspace.scale = 0.75;
        plan.workspace.origin_m = {0.01, 0.02, 0.03};
        plan.workspace.leftHanded = true;
        plan.workspace.turn_rad = {0.1, 0.2, 0.3};
        plan.familiarisation = true;
        const auto told = [this](const QVariantMap& map) {
            for (auto it = map.begin(); it != map.end(); ++it)
                say({it.key(), it.value().toString()});
        };
        for (const devices::MovedBy mover :
             {devices::MovedBy::person, devices::MovedBy::scriptedOperator, devices::MovedBy::recording})
            for (const auto depth : {std::optional<bool>(), std::optional(false), std::optional(true)}) {
                plan.driver = &devices::usualDriver(mover);
                plan.depthOfField = depth;
                const TrainingPlan back = TrainingPlan::fromMap(plan.toMap());
                QCOMPARE(back.toMap(), plan.toMap());
                QVERIFY(back.driver == plan.driver && back.depthOfField == depth &&
                        back.workspace.turn_rad == plan.workspace.turn_rad && back.forceMap == plan.forceMap);
                const database::Actor tina = actorOf(plan, database::Actor::anonymous());
                say({QString::number(static_cast<int>(mover)), QString::number(static_cast<int>(tina.kind())),
                     plan.ownHand() ? QStringLiteral("own hand") : QStringLiteral("watched")});
            }
        told(plan.toMap());
        told(TrainingPlan::fromMap({}).toMap());
        hold("plans");
    }

    /// Beyond the levels that are shipped.
    void facts() {
        catalogue::ExerciseLevel level;
        const auto told = [&] { say({levelFacts(level, m_locale).join(QStringLiteral(" | "))}); };
        simulation::PalpationParameters palpation;
        level.exercise = "palpation";
        for (const int hands : {1, 2})
            for (const int fingers : {1, 2}) {
                palpation.hands = hands;
                palpation.fingers = fingers;
                palpation.asksSize = hands > 1;
                palpation.asksHardness = fingers > 1;
                palpation.asksConfidence = hands == fingers;
                level.parameters = palpation;
                told();
            }
        for (const auto& [low, high, empty] :
             {std::tuple{1, 1, 0}, {1, 1, 2}, {0, 1, 0}, {0, 3, 0}, {2, 3, 0}, {2, 3, 1}, {0, 0, 0}}) {
            palpation.lumpsLow = low;
            palpation.lumpsHigh = high;
            palpation.catchTrials = empty;
            level.parameters = palpation;
            told();
        }
        simulation::ElasticTubeParameters tube;
        level.exercise = "elastic_tube";
        for (const auto task : {simulation::TubeTask::hold, simulation::TubeTask::stretch,
                                simulation::TubeTask::transfer, simulation::TubeTask::twoHanded})
            for (const double stiffening : {0.0, 2.0}) {
                tube.task = task;
                tube.tube.stiffening_per_m = stiffening;
                level.parameters = tube;
                told();
            }
        tube.foldStiffness_N_per_m = 25.0;
        tube.retractionLow_N = 0.6;
        tube.retractionHigh_N = 1.0;
        level.parameters = tube;
        told();
        simulation::ObjectHandlingParameters handling;
        level.exercise = "object_handling";
        for (const auto task : {simulation::HandlingTask{}, simulation::HandlingTask::weigh})
            for (const bool organ : {false, true}) {
                handling.task = task;
                handling.organBed = organ;
                level.parameters = handling;
                told();
            }
        simulation::UrethraInsertionParameters canal;
        level.exercise = "urethra_insertion";
        for (const char* tissue : {"normal", "tight", "stricture", "leather"})
            for (const bool on : {false, true}) {
                canal.tissue = tissue;
                canal.depthOfField = on;
                canal.depthOfFieldFixed = canal.tissue != "normal";
                canal.withdraws = canal.tissue == "tight" || on;
                level.cues = on ? std::vector<std::string>{"overview"} : std::vector<std::string>{};
                if (canal.tissue == "tight")
                    level.cues.push_back("guidance");
                level.parameters = canal;
                told();
            }
        for (const auto& [metric, least, most] :
             {std::tuple{"force_max", std::optional<double>(), std::optional(4.0)},
              {"force_max", std::optional(0.5), std::optional(4.0)},
              {"palpation_misses", std::optional(1.0), std::optional<double>()},
              {"apex_error", std::optional<double>(), std::optional(12.5)},
              {"of_another", std::optional<double>(), std::optional<double>()}}) {
            scoring::Gate gate;
            gate.metric = metric;
            gate.minimum = least;
            gate.maximum = most;
            say({gateInWords(gate, m_locale)});
        }
        hold("facts");
    }

    void verdicts() {
        DebriefHead head;
        head.record.setup.plannedTrials = 5;
        head.report.trialsDone = 3;
        head.record.summary.dropped = 2;
        report::MetricRow below;
        below.id = QStringLiteral("force_max");
        below.unit = QStringLiteral("N");
        below.value = 1.5;
        below.gateMinimum = 2.0;
        below.passed = false;
        report::MetricRow above = below;
        above.value = 6.0;
        above.gateMaximum = 4.0;
        report::MetricRow none = below;
        none.value.reset();
        report::MetricRow good = below;
        good.passed = true;
        head.report.metrics = {below, above, none, good};
        for (int s = 0; s <= static_cast<int>(SessionState::voided); ++s)
            for (const auto passed : {std::optional<bool>(), std::optional(true), std::optional(false)})
                for (const bool practice : {false, true}) {
                    head.record.summary.state = static_cast<SessionState>(s);
                    head.report.passed = passed;
                    head.record.summary.familiarisation = practice;
                    head.record.voidReason = practice ? "wrong hand" : "";
                    head.record.setup.plannedTrials = passed ? 5 : 1;
                    const Verdict verdict = verdictOf(head, m_locale);
                    say({QLatin1String(verdict.kind), verdict.icon, verdict.title, verdict.text,
                         verdict.reasons.join(QStringLiteral(" / "))});
                }
        hold("verdicts");
    }

    /// What the scene is told to show of a moment of training, by what a level lets be seen.
    void scenes() {
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(catalogue);
        const Theme theme = Theme::load(ThemeName::highContrast, 1.5).value();
        haptics::DisplayState shown;
        shown.tools = 2;
        shown.now_ns = 5'250'000'000;
        for (std::size_t i = 0; i < 3; ++i) {
            const double k = 1.0 + double(i);
            shown.tool[i].p_WT_m = {0.01 * k, -0.02 * k, 0.03 * k};
            shown.tool[i].p_WProxy_m = {0.011 * k, -0.021 * k, 0.031 * k};
            shown.tool[i].q_WT = {std::cos(0.2 * k), std::sin(0.2 * k), 0.0, 0.0};
            shown.tool[i].tissue = {0.1 * k, -0.2 * k, 0.9 * k, 0.01, 0.02, 0.03};
            shown.tool[i].commanded = shown.tool[i].measured = shown.tool[i].tissue;
            shown.tool[i].jaw_rad = 0.3 * k;
            shown.tool[i].rendersForce = i == 1;
        }
        shown.p_WObject_m = {0.004, 0.005, 0.006};
        const auto vector = [](const auto& v) {
            return QStringLiteral("%1,%2,%3").arg(v[0]).arg(v[1]).arg(v[2]);
        };
        for (const catalogue::Exercise& exercise : catalogue->exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels)
                for (const bool felt : {false, true}) {
                    const session::LevelCues cues = session::cuesOf(level, felt);
                    const scene3d::SceneSetup setup =
                        sceneSetupOf(level, cues, theme, felt, felt ? std::optional(true) : std::nullopt);
                    shown.objectShown = felt;
                    const scene3d::SceneState state = sceneStateOf(shown, cues, 1'000'000'000);
                    say({QString::fromStdString(setup.exercise), QString::number(level.number),
                         QStringLiteral("limit %1").arg(setup.forceLimit_N),
                         QStringLiteral("cues %1%2%3%4%5")
                             .arg(setup.cues.tool)
                             .arg(setup.cues.arrow)
                             .arg(setup.cues.object)
                             .arg(setup.cues.overview)
                             .arg(setup.cues.guidance),
                         QStringLiteral("depth of field %1 left %2 contrast %3 scale %4")
                             .arg(setup.depthOfField)
                             .arg(setup.leftHanded)
                             .arg(setup.colours.highContrast)
                             .arg(setup.scale),
                         QStringLiteral("object %1 at %2, %3 s")
                             .arg(state.objectShown)
                             .arg(vector(state.p_WObject))
                             .arg(state.time_s)});
                    if (level.number > 1)
                        continue;
                    for (const scene3d::ToolView& tool : state.tool)
                        say({QStringLiteral(
                                 "tool %1 at %2 drawn %3 turned %4,%5 force %6 jaw %7 at the surface %8")
                                 .arg(tool.present)
                                 .arg(vector(tool.p_WT), vector(tool.p_WProxy))
                                 .arg(tool.q_WT.w(), 0, 'g', 4)
                                 .arg(tool.q_WT.x(), 0, 'g', 4)
                                 .arg(vector(tool.force_N))
                                 .arg(tool.jaw_rad)
                                 .arg(tool.drawnAtSurface)});
                    for (const QColor& colour :
                         {setup.colours.background, setup.colours.field, setup.colours.ink,
                          setup.colours.arrow, setup.colours.over, setup.colours.ghost})
                        say({colour.name()});
                }
        const haptics::DisplayState none = withoutForce(shown);
        for (const haptics::ToolDisplay& tool : none.tool)
            QVERIFY(tool.tissue == core::Array6{} && tool.commanded == core::Array6{} &&
                    tool.measured == core::Array6{});
        QVERIFY(none.tool[1].p_WT_m == shown.tool[1].p_WT_m);
        const auto leans = [](const haptics::DisplayState&, std::size_t tool) {
            return std::array{0.2, 0.9, 3.0, 0.0}[tool];
        };
        SoundCues sound; // of the tools that are there the one with the largest force
        for (const int tools : {0, 1, 2, 3}) {
            shown.tools = tools;
            takeStrongest(shown, leans, sound);
            say({QStringLiteral("%1 tools").arg(tools), QString::number(sound.force_N, 'g', 5),
                 QString::number(sound.lean, 'g', 5)});
        }
        hold("scenes");
    }

    void nothingElseIsKept() {
        if (m_held > 1)
            QCOMPARE(m_kept.unseen(), QStringList());
    }

private:
    void say(const QStringList& words) {
        const QString line = words.join(QStringLiteral(" · ")).replace(QLatin1Char('\n'), QLatin1Char('|'));
        m_lines << (line.isEmpty() ? QStringLiteral("nothing") : line);
    }
    void hold(const char* name) {
        const QString differs = m_kept.differs(QLatin1String(name), m_lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        ++m_held;
    }

    const QLocale m_locale{QLocale::English, QLocale::UnitedKingdom};
    QStringList m_lines;
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/frame/kept_words.txt")};
    int m_held = 0;
};

QTEST_MAIN(TestKeptWords)
#include "test_kept_words.moc"
