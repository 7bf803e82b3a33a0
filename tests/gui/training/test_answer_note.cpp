// SPDX-License-Identifier: GPL-3.0-or-later
// What the scene says once a trial has its answer or its end, and over a scene that stands still.
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "catalogue/catalogue.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/scene_note_painter.h"
#include "desktop/training/answer_note.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "session/exercise_kind.h"
#include "support/painted_shapes.h"

#include <QPainter>
#include <QtTest>

using namespace chiron;
using desktop::AnswerNote;
using scene3d::SceneNote;
using tests::PaintedShape;
namespace bits = core::event_bits;

namespace {

session::LiveSample sampleOf(std::uint32_t events, float x_m = 0.0F, float y_m = 0.0F) {
    session::LiveSample sample;
    sample.events = events;
    sample.p_WT_m = {x_m, y_m, 0.0F};
    sample.tissueNorm_N = 0.3F;
    return sample;
}

/// As on a level that hides its object: where it lies is not told.
haptics::DisplayState stateAt(double t_s, int trial, core::TrialPhase phase) {
    haptics::DisplayState state;
    state.now_ns = static_cast<std::int64_t>(1e9 * t_s);
    state.trial = static_cast<std::uint16_t>(trial);
    state.phase = phase;
    return state;
}

constexpr std::uint64_t kSeed = 20'261'128;

AnswerNote noteOf(const catalogue::ExerciseLevel& level, const char* language = "en") {
    return AnswerNote(level, QLocale(QLatin1String(language)),
                      (*session::exerciseKind(level.exercise))->makeSurfaces(level, kSeed));
}

/// Where the top of this trial's ball is, as scoring has it.
core::Vec2 topOf(const catalogue::ExerciseLevel& level, int trial) {
    scoring::TrialTrace truth;
    truth.trial = trial;
    (*session::exerciseKind(level.exercise))->addTruth(level, kSeed, truth);
    return {truth.target->x_m, truth.target->y_m};
}

/// What is said after this tick of a trial; the state that comes with it is of the time between trials.
QString said(const catalogue::ExerciseLevel& level, int trial, const session::LiveSample& sample,
             const char* language = "en") {
    AnswerNote note = noteOf(level, language);
    note.take(stateAt(1.0, trial, core::TrialPhase::running), {});
    note.take(stateAt(1.1, trial, core::TrialPhase::between), std::array{sample});
    return note.note(1'100'000'000).title;
}
QString saidBeside(const catalogue::ExerciseLevel& level, int trial, double x_m, double y_m,
                   const char* language = "en") {
    const core::Vec2 top = topOf(level, trial);
    return said(level, trial,
                sampleOf(bits::kMarked, static_cast<float>(top.x() + x_m), static_cast<float>(top.y() + y_m)),
                language);
}

constexpr QSize kScene(640, 360);

std::vector<PaintedShape> painted(const SceneNote& note, double scale = 1.0, QSize room = kScene) {
    scene3d::SceneSetup setup;
    setup.scale = scale;
    tests::PaintedShapes scene(room);
    QPainter painter(&scene);
    scene3d::SceneNotePainter(setup).paint(painter, QRectF(QPointF(), room), 1.0, note);
    painter.end();
    return scene.shapes();
}

} // namespace

class TestAnswerNote : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        auto loaded = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(loaded.has_value());
        m_catalogue.emplace(std::move(*loaded));
    }

    /// Measured as it is scored: across, from the ball of this trial, seen or hidden.
    void aTrainingLevelTellsHowFar() {
        int training = 0;
        for (const catalogue::ExerciseLevel& level : m_catalogue->find("sphere_apex")->levels) {
            if (!level.feedback)
                continue;
            ++training;
            QVERIFY(topOf(level, 0) != topOf(level, 7) &&
                    topOf(level, 0).norm() > 1e-3); // or the test would take any ball for the right one
            for (const int trial : {0, 7}) {
                QCOMPARE(saidBeside(level, trial, 0.003, 0.004), QStringLiteral("5.0 mm from the top"));
                QCOMPARE(saidBeside(level, trial, 0.0, 0.0), QStringLiteral("0.0 mm from the top"));
                QVERIFY(saidBeside(level, trial, -0.040, 0.0)
                            .startsWith(QStringLiteral("40.0 mm from the top: not on")));
                QCOMPARE(saidBeside(level, trial, 0.003, 0.004, "de").left(3), QStringLiteral("5,0"));
                // In the air over the very top: a miss, as it is scored.
                session::LiveSample inTheAir =
                    sampleOf(bits::kMarked, static_cast<float>(topOf(level, trial).x()),
                             static_cast<float>(topOf(level, trial).y()));
                inTheAir.tissueNorm_N = 0.02F;
                QVERIFY(said(level, trial, inTheAir).startsWith(QStringLiteral("Not counted: mark while")));
            }
        }
        QVERIFY(training >= 2); // one that hides its ball among them
    }

    /// By the same rule as the score: within reach of the place above the lump, and each lump once.
    void aTrainingLevelTellsWhatWasFound() {
        int training = 0;
        for (const catalogue::ExerciseLevel& level : m_catalogue->find("palpation")->levels) {
            if (!level.feedback)
                continue;
            ++training;
            const auto truth = (*session::exerciseKind("palpation"))->makeSurfaces(level, kSeed);
            bool without = false;
            for (int trial = 0; truth->object(trial); ++trial) {
                const auto lumps = truth->object(trial)->lumps;
                without = without || lumps.empty();
                QVERIFY(trial > 0 || lumps.size() == 1); // the introduction
                const auto after = [&](std::vector<core::Vec3> places) {
                    AnswerNote note = noteOf(level);
                    haptics::DisplayState state = stateAt(1.0, trial, core::TrialPhase::running);
                    state.exercise.own<simulation::PalpationCues>().present = true;
                    for (std::size_t i = 0; i < places.size(); ++i)
                        state.exercise.own<simulation::PalpationCues>().finding[i] = {
                            true, {places[i].x(), places[i].y(), places[i].z()}, 0.0, 0, 0};
                    note.take(state, {});
                    note.take(stateAt(1.1, trial, core::TrialPhase::between),
                              std::array{sampleOf(bits::kCompleted)});
                    return note.note(1'100'000'000).title;
                };
                if (lumps.empty()) {
                    QCOMPARE(after({}), QStringLiteral("Trial completed. Right: there was no lump"));
                    QVERIFY(
                        after({core::Vec3::Zero()})
                            .startsWith(QStringLiteral("Trial completed. There was no lump, 1 false alarm")));
                    continue;
                }
                const core::Vec3 above = lumps.front().p_WAbove;
                const double reach = lumps.front().reach_m;
                const core::Vec3 inward = core::Vec3((above.x() > 0.0 ? -1.0 : 1.0) * core::Vec3::UnitX());
                QCOMPARE(after({above + 0.004 * inward}),
                         QStringLiteral("Trial completed. Lump found, 4.0 mm off"));
                QVERIFY(after({above + (reach - 1e-6) * inward}).contains(QStringLiteral("found")));
                QVERIFY(
                    after({above + (reach + 1e-4) * inward})
                        .startsWith(QStringLiteral("Trial completed. The lump was missed, 1 false alarm")));
                QCOMPARE(after({}), QStringLiteral("Trial completed. The lump was missed"));
                QVERIFY(after({above, above + 0.001 * inward})
                            .contains(QStringLiteral("1 false alarm"))); // one lump is found once
            }
            QVERIFY(without); // a level without an empty pad would hide a mistake here
        }
        QCOMPARE(training, 2);
    }

    /// Beside the mark the true top is drawn, hidden ball or not; after time ran out without a mark. As long
    /// as it is spoken of, and no longer.
    void aTrainingLevelShowsWhereTheTopIs() {
        for (const catalogue::ExerciseLevel& level : m_catalogue->find("sphere_apex")->levels) {
            if (!level.feedback)
                continue;
            AnswerNote note = noteOf(level);
            note.take(stateAt(1.0, 3, core::TrialPhase::running), {});
            scene3d::SceneState before;
            note.show(1'000'000'000, before);
            QVERIFY(!before.answered && !before.marked && !before.objectShown &&
                    !note.holdsNext(1'000'000'000)); // nothing while the trial runs
            note.take(stateAt(1.1, 3, core::TrialPhase::between),
                      std::array{sampleOf(bits::kMarked, 0.012F, -0.008F)});
            scene3d::SceneState drawn;
            note.show(1'100'000'000, drawn);
            QVERIFY(drawn.answered && drawn.marked && drawn.objectShown);
            const core::Vec2 top = topOf(level, 3);
            QVERIFY((drawn.p_WAnswer.head<2>() - top).norm() < 1e-9 &&
                    (drawn.p_WObject.head<2>() - top).norm() < 1e-9);
            QVERIFY(drawn.p_WAnswer.z() - drawn.p_WObject.z() > 0.01); // upon the ball
            QVERIFY((drawn.p_WMark - core::Vec3(0.012, -0.008, 0.0)).norm() < 1e-6);
            QVERIFY(note.holdsNext(1'100'000'000 + AnswerNote::kHeld_ns - 1) &&
                    !note.holdsNext(1'100'000'000 + AnswerNote::kHeld_ns));
            scene3d::SceneState after;
            note.show(1'100'000'001 + AnswerNote::kSaid_ns, after);
            QVERIFY(!after.answered && !after.marked && !after.objectShown);
            note.take(stateAt(9.0, 4, core::TrialPhase::between), std::array{sampleOf(bits::kTimedOut)});
            note.show(9'000'000'000, after);
            QVERIFY(after.answered && !after.marked);
            note.take(stateAt(9.5, 5, core::TrialPhase::running), std::array{sampleOf(bits::kTrialStarted)});
            scene3d::SceneState next;
            note.show(9'500'000'000, next);
            QVERIFY(!next.answered && !next.objectShown && !note.holdsNext(9'500'000'000));
        }
    }

    /// A level whose trials end in what was done with the object, and not in a mark, has no answer to draw.
    void aDoneTaskHasNoAnswerInThePicture() {
        int levels = 0;
        for (const char* exercise : {"elastic_tube", "object_handling"})
            for (const catalogue::ExerciseLevel& level : m_catalogue->find(exercise)->levels)
                for (const std::uint32_t end : {bits::kMarked, bits::kTimedOut, bits::kCompleted}) {
                    if (!level.feedback)
                        continue;
                    AnswerNote note = noteOf(level);
                    note.take(stateAt(1.0, 0, core::TrialPhase::running), {});
                    note.take(stateAt(1.1, 0, core::TrialPhase::between), std::array{sampleOf(end)});
                    scene3d::SceneState drawn;
                    note.show(1'100'000'000, drawn);
                    QVERIFY2(!drawn.answered && !drawn.marked && !drawn.objectShown &&
                                 !note.holdsNext(1'100'000'000),
                             level.id.c_str());
                    QVERIFY(note.note(1'100'000'000).kind == scene3d::SceneNote::Kind::said); // it is told
                    ++levels;
                }
        QVERIFY(levels >= 6);
    }

    /// As it is scored: the object that was held last, across, from the middle of the ring of this trial.
    void howFarTheObjectLiesFromTheRingIsTold() {
        int told = 0;
        for (const catalogue::ExerciseLevel& level : m_catalogue->find("object_handling")->levels) {
            const auto target =
                (*session::exerciseKind("object_handling"))->makeSurfaces(level, kSeed)->object(1);
            QVERIFY(target);
            AnswerNote note = noteOf(level);
            const auto frame = [&](core::TrialPhase phase, int heldBy, double beside_m) {
                haptics::DisplayState state = stateAt(1.0, 1, phase);
                auto& cues = state.exercise.own<core::LaparoscopyCues>();
                cues.present = true;
                cues.bodies = 2;
                cues.body[0].p_W = {target->p_WObject.x(), target->p_WObject.y(),
                                    0.01}; // another one, nearer
                cues.body[1].heldBy = static_cast<std::uint8_t>(heldBy);
                cues.body[1].p_W = {target->p_WObject.x() + 0.6 * beside_m,
                                    target->p_WObject.y() - 0.8 * beside_m, 0.02};
                note.take(state, {});
            };
            const auto ended = [&](std::uint32_t how) {
                note.take(stateAt(1.1, 1, core::TrialPhase::between), std::array{sampleOf(how)});
                return note.note(1'100'000'000).title;
            };
            frame(core::TrialPhase::running, 0, 0.050);
            QCOMPARE(ended(bits::kTimedOut), QStringLiteral("Time is up")); // nothing was held
            frame(core::TrialPhase::running, 1, 0.030);
            frame(core::TrialPhase::running, 0, 0.0034);
            QCOMPARE(ended(bits::kCompleted),
                     level.feedback ? QStringLiteral("Trial completed. 3.4 mm from the middle of the ring")
                                    : QStringLiteral("Trial completed"));
            frame(core::TrialPhase::ready, 0, 0.0034); // the next trial forgets it
            QCOMPARE(ended(bits::kTimedOut), QStringLiteral("Time is up"));
            told += level.feedback ? 1 : 0;
        }
        QVERIFY(told > 0);
    }

    /// Every lump where it is, told whether it was found, and each mark whether it was right.
    void aTrainingLevelShowsItsLumps() {
        int hidden = 0;
        for (const catalogue::ExerciseLevel& level : m_catalogue->find("palpation")->levels) {
            if (!level.feedback)
                continue;
            const auto truth = (*session::exerciseKind("palpation"))->makeSurfaces(level, kSeed);
            const session::TrialLump lump = truth->object(0)->lumps.front();
            for (const bool found : {true, false}) {
                AnswerNote note = noteOf(level);
                haptics::DisplayState state = stateAt(1.0, 0, core::TrialPhase::running);
                state.exercise.own<simulation::PalpationCues>().present = true;
                const core::Vec3 at =
                    found ? lump.p_WAbove
                          : core::Vec3(lump.p_WAbove +
                                       core::Vec3(lump.p_WAbove.x() > 0.0 ? -0.030 : 0.030, 0.0, 0.0));
                state.exercise.own<simulation::PalpationCues>().finding[2] = {
                    true, {at.x(), at.y(), at.z()}, 0.0, 0, 0};
                note.take(state, std::array{sampleOf(
                                     bits::kMarked)}); // a finding is marked, and nothing is told of it yet
                scene3d::SceneState drawn;
                note.show(1'000'000'000, drawn);
                QCOMPARE(drawn.exercise.of<simulation::PalpationCues>().lumps, 0);
                note.take(stateAt(1.1, 0, core::TrialPhase::between), std::array{sampleOf(bits::kCompleted)});
                note.show(1'100'000'000, drawn);
                QCOMPARE(drawn.exercise.of<simulation::PalpationCues>().lumps, 1);
                QVERIFY((core::Vec3(drawn.exercise.of<simulation::PalpationCues>().lump[0].p_W[0],
                                    drawn.exercise.of<simulation::PalpationCues>().lump[0].p_W[1],
                                    drawn.exercise.of<simulation::PalpationCues>().lump[0].p_W[2]) -
                         lump.p_WCentre)
                            .norm() < 1e-9);
                QCOMPARE(drawn.exercise.of<simulation::PalpationCues>().lump[0].radius_m, lump.radius_m);
                QCOMPARE(int(drawn.overlay.of<scene3d::PalpationOverlay>().lumpsMissed), found ? 0 : 1);
                QVERIFY(drawn.overlay.of<scene3d::PalpationOverlay>().outcome[2] ==
                        (found ? simulation::FindingOutcome::hit : simulation::FindingOutcome::falseAlarm));
                QVERIFY(drawn.exercise.of<simulation::PalpationCues>().finding[2].present && !drawn.answered);
                ++hidden;
            }
        }
        QVERIFY(hidden >= 4);
    }

    /// Where nothing is taught, nothing of the truth comes into the picture, and no time is given to look at
    /// it.
    void anAssessmentShowsNothing() {
        for (const catalogue::Exercise& exercise : m_catalogue->exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels)
                for (const std::uint32_t end : {bits::kMarked, bits::kTimedOut, bits::kCompleted}) {
                    if (level.feedback)
                        continue;
                    AnswerNote note = noteOf(level);
                    haptics::DisplayState state = stateAt(1.0, 0, core::TrialPhase::running);
                    state.exercise.own<simulation::PalpationCues>().present = exercise.id == "palpation";
                    note.take(state, {});
                    note.take(stateAt(1.1, 0, core::TrialPhase::between), std::array{sampleOf(end)});
                    scene3d::SceneState drawn;
                    note.show(1'100'000'000, drawn);
                    QVERIFY2(!drawn.answered && !drawn.marked && !drawn.objectShown &&
                                 drawn.exercise.of<simulation::PalpationCues>().lumps == 0 &&
                                 !note.holdsNext(1'100'000'000),
                             level.id.c_str());
                }
    }

    /// What went wrong with a grip is said where somebody learns, and nowhere else.
    void aSlipIsToldWhereSomebodyLearns() {
        for (const char* exercise : {"elastic_tube", "object_handling"}) {
            bool told = false, silent = false;
            for (const catalogue::ExerciseLevel& level : m_catalogue->find(exercise)->levels) {
                const QString slipped = said(level, 0, sampleOf(bits::kSlipped)),
                              damaged = said(level, 0, sampleOf(bits::kSlipped | bits::kDamaged));
                QCOMPARE(slipped.contains(QStringLiteral("slipped")), level.feedback);
                QCOMPARE(damaged.contains(QStringLiteral("damaged")), level.feedback); // the worse of the two
                (level.feedback ? told : silent) = true;
            }
            QVERIFY(told && silent);
        }
    }

    /// In every exercise, at once: with what to do about it where somebody learns, and neutrally elsewhere.
    /// What does not count as an error is not told; that the trial is over is said with it.
    void tissueThatGaveWayIsTold() {
        bool learnt = false, assessed = false, jaws = false;
        for (const catalogue::Exercise& exercise : m_catalogue->exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels) {
                session::LiveSample sample = sampleOf(bits::kDamaged);
                sample.phase = core::TrialPhase::running;
                sample.yielded = true;
                const QString words = said(level, 0, sample);
                QVERIFY2(words.contains(QStringLiteral("the tissue gave way"), Qt::CaseInsensitive),
                         level.id.c_str());
                QCOMPARE(words.contains(QStringLiteral("Draw back")), level.feedback);
                // Jaws may have squeezed it, and only where they can.
                const auto* palpation = level.parameters.find<simulation::PalpationParameters>();
                QCOMPARE(words.contains(QStringLiteral("open the jaws")),
                         level.feedback && palpation && palpation->pinch);
                jaws = jaws || words.contains(QStringLiteral("open the jaws"));
                (level.feedback ? learnt : assessed) = true;
                sample.events |= bits::kFailed;
                sample.phase = core::TrialPhase::between; // the trial is over at the same tick
                const QString ended = said(level, 0, sample);
                QVERIFY2(ended.contains(QStringLiteral("no longer")), qPrintable(ended));
                const bool tube = exercise.id == "elastic_tube";
                QVERIFY2(
                    ended.contains(tube ? QStringLiteral("The tube tore") : QStringLiteral("gave way")) &&
                        ended.contains(QStringLiteral("more gently")) == (tube && level.feedback),
                    qPrintable(ended));
                sample.events = 0;
                sample.phase = core::TrialPhase::running;
                sample.paused = true;
                QVERIFY(said(level, 0, sample).isEmpty());
                sample.paused = false;
                sample.phase = core::TrialPhase::ready;
                QVERIFY(said(level, 0, sample).isEmpty());
            }
        QVERIFY(learnt && assessed && jaws);
    }

    void anAssessmentTellsThatItWasTaken() {
        const catalogue::ExerciseLevel& level = *m_catalogue->find("sphere_apex", 5);
        QVERIFY(!level.feedback);
        QCOMPARE(saidBeside(level, 0, 0.003, 0.004), QStringLiteral("Marked"));
        QCOMPARE(saidBeside(level, 0, 0.050, 0.0), QStringLiteral("Marked")); // a miss looks no different
    }

    void everyEndIsSaid() {
        for (const catalogue::Exercise& exercise : m_catalogue->exercises()) {
            const catalogue::ExerciseLevel& level = exercise.levels.back();
            QCOMPARE(said(level, 0, sampleOf(bits::kTimedOut)), QStringLiteral("Time is up"));
            QCOMPARE(said(level, 0, sampleOf(bits::kCompleted)), QStringLiteral("Trial completed"));
            QVERIFY(said(level, 0, sampleOf(bits::kFailed)).contains(QStringLiteral("no longer")));
            QVERIFY(said(level, 0, sampleOf(bits::kContactBegan)).isEmpty());
        }
    }

    /// Three seconds, or until the next trial runs.
    void itIsGoneAgain() {
        AnswerNote note = noteOf(*m_catalogue->find("sphere_apex", 1));
        note.take(stateAt(5.0, 0, core::TrialPhase::between), std::array{sampleOf(bits::kTimedOut)});
        QCOMPARE(note.note(5'000'000'000 + AnswerNote::kSaid_ns).title, QStringLiteral("Time is up"));
        QVERIFY(note.note(5'000'000'001 + AnswerNote::kSaid_ns).kind == SceneNote::Kind::none);
        note.take(stateAt(6.0, 1, core::TrialPhase::running), std::array{sampleOf(bits::kTrialStarted)});
        QVERIFY(note.note(6'000'000'000).kind == SceneNote::Kind::none);
    }

    /// In the small scene that is left at 200 % (and in smaller ones) the sign gives way, then the size of
    /// the title: no line is cut, and none lies on another.
    void aVeilIsReadInASmallScene() {
        using Kind = PaintedShape::Kind;
        const SceneNote stopped{
            SceneNote::Kind::stopped, QStringLiteral("Kraft ist gestoppt"),
            QStringLiteral("Die Uhr steht. Drücken Sie „Freigeben“ oder R, um fortzufahren, oder beenden Sie "
                           "die Sitzung mit der Schaltfläche daneben.")};
        for (const QSize room : {QSize(640, 323), QSize(640, 288), QSize(520, 240), QSize(400, 200)}) {
            const std::vector<PaintedShape> shapes = painted(stopped, 2.0, room);
            QCOMPARE(tests::wordsIn(shapes).join(QLatin1Char(' ')).simplified(),
                     stopped.title + QLatin1Char(' ') + stopped.words);
            std::vector<QRectF> before;
            for (const PaintedShape& shape : shapes) {
                if (shape.kind != Kind::words)
                    continue;
                QVERIFY2(QRectF(QPointF(), room).contains(shape.bounds), qPrintable(shape.text));
                for (const QRectF& other : before) {
                    const QRectF both = shape.bounds.intersected(other);
                    QVERIFY2(both.width() < 2.0 || both.height() < 0.5 * other.height(),
                             qPrintable(shape.text));
                }
                before.push_back(shape.bounds);
            }
        }
    }

    /// A scene that stands still is dark all over, and a pause does not look like a stop; what is said leaves
    /// the scene as it is.
    void aVeilIsUnmistakable() {
        using Kind = PaintedShape::Kind;
        const SceneNote paused{SceneNote::Kind::paused, QStringLiteral("Paused"),
                               QStringLiteral("Press Space.")};
        const SceneNote stopped{SceneNote::Kind::stopped, QStringLiteral("Force is stopped"),
                                QStringLiteral("Press R.")};
        const auto inSign =
            [](const std::vector<PaintedShape>& shapes) { // all that is neither veil nor words
                std::vector<PaintedShape> sign;
                for (std::size_t i = 1; i < shapes.size(); ++i)
                    if (shapes[i].kind != Kind::words)
                        sign.push_back(shapes[i]);
                return sign;
            };
        for (const double scale : {1.0, 2.0})
            for (const SceneNote& note : {paused, stopped}) {
                const std::vector<PaintedShape> shapes = painted(note, scale);
                QVERIFY(!shapes.empty());
                const PaintedShape& veil = shapes.front(); // under all the rest, over all the scene
                QVERIFY(veil.kind == Kind::rect && veil.bounds == QRectF(QPointF(), kScene));
                QVERIFY(veil.brush.style() == Qt::SolidPattern && veil.brush.color().lightness() == 0 &&
                        veil.brush.color().alphaF() > 0.5F && veil.brush.color().alpha() < 255);
                const QStringList words = tests::wordsIn(shapes);
                QCOMPARE(words.join(QLatin1Char(' ')).simplified(),
                         note.title + QLatin1Char(' ') + note.words);
                const std::vector<PaintedShape> sign = inSign(shapes);
                QVERIFY(!sign.empty());
                double white_px = 0.0; // of the sign's insides
                for (const PaintedShape& shape : sign)
                    if (shape.filled() && shape.brush.color() == Qt::white)
                        white_px += shape.bounds.width() * shape.bounds.height();
                QVERIFY2(white_px > 400.0, qPrintable(QString::number(white_px)));
                for (const PaintedShape& shape : shapes) {
                    QVERIFY(QRectF(QPointF(), kScene).contains(shape.bounds));
                    if (shape.kind == Kind::words)
                        QVERIFY(shape.pen.color().lightness() > 200);
                }
            }
        // A pause is two bars, a stop an octagon of its colour: they differ in form as well.
        const std::vector<PaintedShape> bars = inSign(painted(paused)), stop = inSign(painted(stopped));
        QCOMPARE(bars.size(), std::size_t(2));
        for (const PaintedShape& bar : bars)
            QVERIFY(bar.kind == Kind::rect && bar.bounds.height() > 2.0 * bar.bounds.width());
        QVERIFY(stop.front().kind == Kind::polygon && stop.front().corners.size() == 8);
        QCOMPARE(stop.front().brush.color(), scene3d::SceneSetup{}.colours.stop);
        QVERIFY(stop.front().bounds.width() * stop.front().bounds.height() > 1000.0);
        const QColor red = scene3d::SceneSetup{}.colours.stop;
        QVERIFY(red.red() > 140 && red.green() < 70 && red.blue() < 80);
        for (const PaintedShape& bar : bars)
            QVERIFY(bar.brush.color() != red);
        const std::vector<PaintedShape> plate =
            painted({SceneNote::Kind::said, QStringLiteral("1.1 mm from the top"), {}});
        QCOMPARE(tests::wordsIn(plate), QStringList{QStringLiteral("1.1 mm from the top")});
        for (const PaintedShape& shape : plate) // the scene's lower half is left alone
            QVERIFY(shape.bounds.bottom() < kScene.height() / 2.0);
        QVERIFY(painted({}).empty());
    }

private:
    std::optional<catalogue::Catalogue> m_catalogue;
};

QTEST_MAIN(TestAnswerNote)
#include "test_answer_note.moc"
