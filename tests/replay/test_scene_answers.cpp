// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a scene answers, not its forces alone (test_models_id), along the sweep's paths over every
// level: energy, stiffness, damping and load that the supervisor books with, places that tools are drawn at,
// contact, events, what is recorded and what the screen is told. Against what was stored. A change that is
// meant: CHIRON_STORE_SCENE_ANSWERS=1 build/release/tests/replay/test_scene_answers, and say why.
#include "core/fp_environment.h"
#include "support/answer_numbers.h"
#include "sweep/level_sweep.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <array>
#include <cmath>

using namespace chiron;

namespace {

const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/replay/scene_answers.json");
constexpr std::uint64_t kSeed = 20261127;
constexpr int kBlock_ticks = 1000;
constexpr std::array<int, 2> kScenes{0, 10}; ///< as test_models_id: begun in the air, and anywhere
constexpr int kPaths = 2;
constexpr double kPath_s = 4.0;
constexpr double kSame = 1e-6; ///< of a mean; libraries of mathematics round differently

/// Of each block what is not zero: its place and its mean, with when in the block.
QJsonArray answersOf(const catalogue::ExerciseLevel& level) {
    QJsonArray array;
    for (const int first : kScenes) {
        tests::AnswerBlocks blocks(kBlock_ticks);
        tests::SweepSettings settings;
        settings.seed = kSeed;
        settings.paths = kPaths;
        settings.firstPath = first;
        settings.path_s = kPath_s;
        settings.witness = [&](std::uint64_t, std::uint64_t, const simulation::SceneOutput& out) {
            if (!blocks.add(out))
                return;
            for (std::size_t i = 0; i < blocks.sums().size(); ++i)
                if (blocks.sums()[i] != 0.0) {
                    array.append(static_cast<double>(i));
                    array.append(QString::number(blocks.sums()[i], 'g', 9).toDouble());
                }
            array.append(-1.0);
        };
        tests::sweepLevel(level, settings);
    }
    return array;
}

} // namespace

class TestSceneAnswers : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void answersAreTheStoredOnes_data();
    void answersAreTheStoredOnes();
    void cleanupTestCase();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QJsonObject m_now;
};

void TestSceneAnswers::answersAreTheStoredOnes_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    for (const catalogue::Exercise& exercise : m_catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            QTest::addRow("%s %d", exercise.id.c_str(), level.number)
                << QString::fromStdString(exercise.id) << level.number;
}

void TestSceneAnswers::answersAreTheStoredOnes() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    const QString key = QStringLiteral("%1/%2").arg(exercise).arg(level);
    const QJsonArray now = answersOf(*m_catalogue.find(exercise.toStdString(), level));
    m_now[key] = now;
    if (qEnvironmentVariableIsSet("CHIRON_STORE_SCENE_ANSWERS"))
        return;
    QFile file(kFile);
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(kFile));
    const QJsonArray stored = QJsonDocument::fromJson(file.readAll()).object()[key].toArray();
    QVERIFY2(!stored.isEmpty(), "nothing is stored of this level");
    QCOMPARE(now.size(), stored.size());
    qsizetype block = 0, entry = 0;
    for (qsizetype i = 0; i < now.size(); ++i) {
        const double is = now[i].toDouble(), was = stored[i].toDouble();
        block += was == -1.0 && entry % 2 == 0 ? 1 : 0;
        entry = was == -1.0 && entry % 2 == 0 ? 0 : entry + 1;
        QVERIFY2(
            std::abs(is - was) <= kSame * std::max(std::abs(is), std::abs(was)) + 1e-9,
            qPrintable(QStringLiteral(
                           "block %1, number %2 of answerNumbers(): was %3, is %4: see the head of this file")
                           .arg(block)
                           .arg(entry % 2 == 0 ? now[i - 1].toDouble() : is)
                           .arg(was, 0, 'g', 9)
                           .arg(is, 0, 'g', 9)));
    }
}

void TestSceneAnswers::cleanupTestCase() {
    if (!qEnvironmentVariableIsSet("CHIRON_STORE_SCENE_ANSWERS"))
        return;
    QFile file(kFile);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QByteArray text = QJsonDocument(m_now).toJson(QJsonDocument::Compact);
    file.write(text.replace("],\"", "],\n\"") + '\n');
}

QTEST_GUILESS_MAIN(TestSceneAnswers)
#include "test_scene_answers.moc"
