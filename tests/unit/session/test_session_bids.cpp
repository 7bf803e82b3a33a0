// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded session as a BIDS dataset: as many samples as ticks, trials from their first tick to their last.
#include "core/contact_bits.h"
#include "session/bids_motion.h"
#include "support/made_session.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <filesystem>

using namespace chiron;

namespace {

QList<QByteArray> linesOf(const QString& folder, const QString& ending) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.toStdString())) {
        const QString name = QString::fromStdString(entry.path().string());
        QFile file(name);
        if (name.endsWith(ending) && file.open(QIODevice::ReadOnly))
            return file.readAll().trimmed().split('\n');
    }
    return {};
}

struct Span {
    std::uint64_t first = 0, last = 0;
};

/// Of each trial in the frames, by its number.
std::map<int, Span> trialsOf(const std::vector<core::HapticFrame>& frames) {
    std::map<int, Span> spans;
    for (const core::HapticFrame& frame : frames) {
        auto& span = spans.try_emplace(frame.header.trial, Span{frame.header.index, 0}).first->second;
        span.last = frame.header.index;
    }
    return spans;
}

} // namespace

class TestSessionBids : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void lengthIsThatOfItsFrames();
    void trialsLastToTheirLastTick();
    void eventsAtASingleTick();
    void tissueThatGaveWayHasItsLoadAndPlace();

private:
    tests::SessionFixture m_fixture;
    database::SessionId m_id = 0;
    tests::MadeSession m_made;
    const database::Actor m_actor = database::Actor::simulated();
};

void TestSessionBids::initTestCase() {
    const auto run = session::runTraining(*m_fixture.database, m_actor,
                                          m_fixture.request(tests::shortLevel(2, 2, 1.0), "expert", 3));
    QVERIFY2(run, run ? "" : run.error().message.c_str());
    m_made = tests::copyOf(*m_fixture.database, run->session);
    tests::cutFrames(m_made.frames, m_made.frames.size() - 137, core::CommandKind::end);
    m_id = tests::store(*m_fixture.database, m_actor, m_made);
}

void TestSessionBids::lengthIsThatOfItsFrames() {
    const tests::OpenStored stored(*m_fixture.database, m_id);
    const auto& summary = stored.session->record().summary;
    QCOMPARE(summary.ticks, static_cast<std::uint64_t>(m_made.frames.back().header.index + 1));
    QCOMPARE(m_made.frames.front().header.index,
             std::uint64_t{0}); // so the last one's number is one less than they are
    QCOMPARE(summary.ticks, static_cast<std::uint64_t>(m_made.frames.size()));
}

void TestSessionBids::trialsLastToTheirLastTick() {
    const tests::OpenStored stored(*m_fixture.database, m_id);
    const QString folder = QString::fromStdString(m_fixture.folder()) + "/whole";
    const auto done = session::exportSessionBids(*stored.session, folder.toStdString());
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    QCOMPARE(stored.session->decodings(), 1); // samples and trials come from one reading
    QCOMPARE(static_cast<std::size_t>(linesOf(folder, "_motion.tsv").size()), m_made.frames.size());
    const auto spans = trialsOf(m_made.frames);
    QVERIFY(spans.size() >= 2);
    QList<QByteArray> events = linesOf(folder, "_events.tsv");
    QCOMPARE(events.takeFirst(), QByteArray("onset\tduration\ttrial_type\tordinal"));
    QCOMPARE(static_cast<std::size_t>(events.size()), spans.size());
    for (const auto& [trial, span] : spans) {
        const QList<QByteArray> cells = events.takeFirst().split('\t');
        QCOMPARE(cells[3].toInt(), trial);
        QVERIFY(std::abs(cells[0].toDouble() - 1e-3 * double(span.first)) < 1e-9);
        QVERIFY2(std::abs(cells[1].toDouble() - 1e-3 * double(span.last - span.first)) < 1e-9,
                 cells[1].constData());
    }
}

void TestSessionBids::eventsAtASingleTick() {
    const tests::OpenStored stored(*m_fixture.database, m_id);
    const std::uint64_t last = m_made.frames.back().header.index;
    const QString folder = QString::fromStdString(m_fixture.folder()) + "/events";
    auto made = session::NewFolder::begin(folder.toStdString());
    QVERIFY(made);
    const std::vector<session::BidsEvent> events{{0, 0, "trial", "1"},
                                                 {500, 500, "trial", "2"},
                                                 {500, 501, "trial", "3"},
                                                 {last, last, "trial", "4"},
                                                 {last + 1, last + 9, "trial", "5"}};
    QVERIFY(session::writeBidsMotion(*made, *stored.session, {"x", "y", {}, 1, "y", {}}, events));
    QVERIFY(made->commit());
    const auto lines = linesOf(folder, "_events.tsv");
    QCOMPARE(lines.size(), 5); // the heading, and what lies beyond the end is none
    const auto at = [&](int line, int column) { return lines[line].split('\t')[column].toDouble(); };
    const double expected[4][2] = {{0.0, 0.0}, {0.5, 0.0}, {0.5, 0.001}, {1e-3 * double(last), 0.0}};
    for (int i = 0; i < 4; ++i)
        QVERIFY2(std::abs(at(i + 1, 0) - expected[i][0]) < 1e-9 &&
                     std::abs(at(i + 1, 1) - expected[i][1]) < 1e-9,
                 lines[i + 1].constData());
}

/// An event of its own, with the tool, the load and the tip's place; the sidecar says what its columns mean,
/// and the README that there are such events. Without such an event there are no such columns
/// (trialsLastToTheirLastTick).
void TestSessionBids::tissueThatGaveWayHasItsLoadAndPlace() {
    tests::MadeSession made = m_made;
    constexpr std::size_t kAt = 700;
    made.frames[kAt - 1].tool[0].tissue = {0.0, 0.0, 2.5, 0.0, 0.004, 0.0}; // what it bore last
    made.frames[kAt].tool[0].tissue = {0.0, 0.0, 1.5, 0.0, 0.003, 0.0};
    made.frames[kAt].tool[0].status |= core::contactStatus(core::contact_bits::kYielded);
    const auto id = tests::store(*m_fixture.database, m_actor, made);
    const tests::OpenStored stored(*m_fixture.database, id);
    const QString folder = QString::fromStdString(m_fixture.folder()) + "/yielded";
    const auto done = session::exportSessionBids(*stored.session, folder.toStdString());
    QVERIFY2(done, done ? "" : done.error().message.c_str());
    const QList<QByteArray> lines = linesOf(folder, "_events.tsv");
    const QList<QByteArray> columns = lines.front().split('\t');
    QCOMPARE(columns, QList<QByteArray>({"onset", "duration", "trial_type", "ordinal", "tool", "force",
                                         "torque", "position_x", "position_y", "position_z"}));
    const core::Vec3 place = stored.session->positions().p_WT_m(0, made.frames[kAt].tool[0]);
    int found = 0;
    for (const QByteArray& line : lines.mid(1)) {
        const QList<QByteArray> cells = line.split('\t');
        QCOMPARE(cells.size(), columns.size());
        if (cells[2] != session::kTissueYielded) {
            for (const QByteArray& cell : cells.mid(4))
                QCOMPARE(cell, QByteArray("n/a"));
            continue;
        }
        ++found;
        QVERIFY(std::abs(cells[0].toDouble() - 1e-3 * double(made.frames[kAt].header.index)) < 1e-9);
        QCOMPARE(cells[4], QByteArray("0"));
        QVERIFY(std::abs(cells[5].toDouble() - 2.5) < 1e-3);
        QVERIFY(std::abs(cells[6].toDouble() - 0.004) < 1e-5);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(cells[7 + axis].toDouble() - place[axis]) < 1e-12);
    }
    QCOMPARE(found, 1);
    const QJsonObject sidecar = QJsonDocument::fromJson(linesOf(folder, "_events.json").join('\n')).object();
    for (const QByteArray& column : columns)
        QVERIFY2(!sidecar[QLatin1String(column)]["Description"].toString().isEmpty(), column.constData());
    QCOMPARE(sidecar["force"]["Units"].toString(), QStringLiteral("N"));
    const QJsonObject types = sidecar["trial_type"]["Levels"].toObject();
    QCOMPARE(types.keys(), QStringList({QLatin1String(session::kTissueYielded), QStringLiteral("trial")}));
    const QByteArray readme = linesOf(folder, "/README").join('\n');
    for (const char* word : {session::kTissueYielded, "perforation", "force and torque", "where"})
        QVERIFY2(readme.contains(word), readme.constData());
}

QTEST_GUILESS_MAIN(TestSessionBids)
#include "test_session_bids.moc"
