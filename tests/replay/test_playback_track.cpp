// SPDX-License-Identifier: GPL-3.0-or-later
// What playback shows is what was recorded: poses, forces, events and spans on the device's time.
#include "app/exercises/sphere_apex/session/apex_marks.h"
#include "database/repositories/session_reader.h"
#include "session/playback_ghost.h"
#include "session/worst_moment.h"
#include "support/looked_back.h"
#include "support/made_session.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <sqlite3.h>

using namespace chiron;
namespace mark_kinds = session::mark_kinds;
using session::PlaybackTrack;
using tests::OpenStored;
using tests::SessionFixture;
using tests::shortLevel;

namespace {

PlaybackTrack trackOf(database::Database& database, database::SessionId id) {
    OpenStored stored(database, id);
    auto track = tests::trackOf(*stored.session);
    if (!track)
        qFatal("%s", track.error().message.c_str());
    return std::move(*track);
}

int count(const PlaybackTrack& track, const session::PlaybackMarkKind& kind) {
    return static_cast<int>(
        std::count_if(track.marks.begin(), track.marks.end(),
                      [kind](const session::PlaybackMark& mark) { return mark.kind == kind; }));
}

double tissueOf(const core::HapticFrame& frame) {
    const auto& f = frame.tool[0].tissue;
    return std::hypot(f[0], f[1], f[2]);
}

int eventsOf(database::Database& database, database::SessionId id, const std::string& kind) {
    auto connection = database.openReader();
    auto events = database::SessionReader(**connection, database::Actor::simulated()).events(id);
    return static_cast<int>(
        std::count_if(events->begin(), events->end(),
                      [&](const database::EventRecord& event) { return event.kind == kind; }));
}

} // namespace

class TestPlaybackTrack : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void samplesAreTheFrames();
    void oneReadingForAll();
    void eventsAreThoseThatTheEndStored();
    void proxyIsTheFeltSurface();
    void nothingHoldsAToolThatIsThrough();
    void tissueThatGaveWayIsPlaced();
    void lookUpByTime();
    void trialsAndMarks();
    void completedTrials();
    void pausesAreSpans();
    void stoppedAndInterrupted();
    void emptySession();
    void damagedChunkIsNamed();
    void canBeStopped();
    void ghostStartsWithTheTrial();
    void worstMoment();

private:
    SessionFixture m_site;
    database::SessionId m_expert = 0;
    database::SessionId m_unsafe = 0;
};

void TestPlaybackTrack::initTestCase() {
    const auto level = shortLevel(2, 2, 20.0);
    auto expert = m_site.run(m_site.request(level, "expert", 5));
    auto unsafe = m_site.run(m_site.request(level, "unsafe", 6));
    QVERIFY(expert && unsafe);
    m_expert = expert->session;
    m_unsafe = unsafe->session;
}

void TestPlaybackTrack::samplesAreTheFrames() {
    OpenStored stored(*m_site.database, m_expert);
    auto frames = stored.session->reader().allFrames();
    auto track = tests::trackOf(*stored.session);
    QVERIFY(frames && track);
    const std::uint64_t origin_us = frames->front().tool[0].deviceTime_us;
    double largest_N = 0.0;
    double largestShown_N = 0.0;
    for (const core::HapticFrame& frame : *frames)
        largest_N = std::max(largest_N, tissueOf(frame));
    std::size_t f = 0;
    for (std::size_t i = 0; i < track->moments.size(); ++i) {
        const session::PlaybackMoment& moment = track->moments[i];
        double bin_N = 0.0;
        while (f < frames->size() && (*frames)[f].header.index <= moment.tick)
            bin_N = std::max(bin_N, tissueOf((*frames)[f++]));
        const core::HapticFrame& frame = (*frames)[f - 1];
        QCOMPARE(moment.tick, frame.header.index);
        QCOMPARE(moment.t_s, static_cast<double>(frame.tool[0].deviceTime_us - origin_us) * 1e-6);
        QCOMPARE(moment.phase, frame.header.phase);
        const core::ToolState pose = stored.session->positions().pose(0, frame.tool[0]);
        QVERIFY(track->tool(i, 0).p_WT == pose.p_WT);
        QCOMPARE(track->tool(i, 0).tissue_N.norm(), bin_N);
        largestShown_N = std::max(largestShown_N, track->tool(i, 0).tissue_N.norm());
    }
    QCOMPARE(f, frames->size());
    QVERIFY(largest_N > 0.1);
    QCOMPARE(largestShown_N, largest_N);
}

void TestPlaybackTrack::proxyIsTheFeltSurface() {
    const PlaybackTrack track = trackOf(*m_site.database, m_expert); // tissue stays whole under this hand
    int touching = 0;
    for (std::size_t i = 0; i < track.moments.size(); ++i) {
        const session::PlaybackTool& tool = track.tool(i, 0);
        const auto* trial = track.trial(track.moments[i].trial);
        if (track.moments[i].phase != core::TrialPhase::running || !trial)
            continue;
        const core::Vec3 fromCentre = tool.p_WProxy - trial->object->p_WObject;
        if ((tool.p_WProxy - tool.p_WT).norm() > 1e-4 && fromCentre.z() > 1e-3) {
            QVERIFY(std::abs(fromCentre.norm() - trial->object->radius_m) < 1e-9);
            ++touching;
        }
    }
    QVERIFY2(touching > 50, qPrintable(QString::number(touching)));
}

// Where tissue has given way no surface holds the tool: the track draws the one where the other is.
void TestPlaybackTrack::nothingHoldsAToolThatIsThrough() {
    OpenStored stored(*m_site.database, m_unsafe);
    auto frames = stored.session->reader().allFrames();
    auto track = tests::trackOf(*stored.session);
    QVERIFY(frames && track);
    std::size_t f = 0;
    int through = 0;
    for (std::size_t i = 0; i < track->moments.size(); ++i) {
        while (f < frames->size() && (*frames)[f].header.index < track->moments[i].tick)
            ++f;
        if ((core::contactOfStatus((*frames)[f].tool[0].status) & core::contact_bits::kThrough) == 0)
            continue;
        ++through;
        QVERIFY(track->tool(i, 0).p_WProxy == track->tool(i, 0).p_WT);
    }
    QVERIFY(through > 50);
}

// The mark, the stored event and the recording agree on where the tip was.
void TestPlaybackTrack::tissueThatGaveWayIsPlaced() {
    OpenStored stored(*m_site.database, m_unsafe);
    auto frames = stored.session->reader().allFrames();
    auto track = tests::trackOf(*stored.session);
    auto connection = m_site.database->openReader();
    auto events = database::SessionReader(**connection, database::Actor::simulated()).events(m_unsafe);
    QVERIFY(frames && track && events);
    QVERIFY(count(*track, mark_kinds::kYielded) > 0);
    QCOMPARE(count(*track, mark_kinds::kYielded), eventsOf(*m_site.database, m_unsafe, "tissue_yielded"));
    for (const session::PlaybackMark& mark : track->marks) {
        if (mark.kind != mark_kinds::kYielded)
            continue;
        const auto frame = std::find_if(frames->begin(), frames->end(), [&](const core::HapticFrame& each) {
            return each.header.index == mark.tick;
        });
        QVERIFY(frame != frames->end() && mark.p_W);
        QVERIFY(*mark.p_W == stored.session->positions().p_WT_m(mark.tool, frame->tool[0]));
        const auto event = std::find_if(events->begin(), events->end(), [&](const auto& each) {
            return each.kind == "tissue_yielded" && each.tick == mark.tick && each.tool == mark.tool;
        });
        QVERIFY(event != events->end());
        const QJsonArray told = QJsonDocument::fromJson(QByteArray::fromStdString(event->detailJson))
                                    .object()["position_m"]
                                    .toArray();
        QCOMPARE(told.size(), qsizetype{3});
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(told[axis].toDouble() - (*mark.p_W)[axis]) <= 0.5e-6 + 1e-12);
    }
}

void TestPlaybackTrack::lookUpByTime() {
    const PlaybackTrack track = trackOf(*m_site.database, m_expert);
    const std::size_t i = track.moments.size() / 2;
    const double a_s = track.moments[i].t_s;
    const double b_s = track.moments[i + 1].t_s;
    QCOMPARE(track.indexAt(a_s), i);
    QCOMPARE(track.indexAt(0.5 * (a_s + b_s)), i);
    QCOMPARE(track.indexAt(-1.0), std::size_t{0});
    QCOMPARE(track.indexAt(1e9), track.moments.size() - 1);
    const session::PlaybackView view = track.at(0.25 * a_s + 0.75 * b_s);
    const core::Vec3 expected = 0.25 * track.tool(i, 0).p_WT + 0.75 * track.tool(i + 1, 0).p_WT;
    QVERIFY((view.tools.at(0).p_WT - expected).norm() < 1e-12);
    QCOMPARE(view.tools.at(0).tissue_N.norm(), track.tool(i, 0).tissue_N.norm());
    QCOMPARE(track.at(1e9).moment.t_s, track.moments.back().t_s);
    QCOMPARE(track.timeOfTick(track.moments[i].tick), a_s);
    QCOMPARE(track.tickAt(a_s), track.moments[i].tick);
}

void TestPlaybackTrack::trialsAndMarks() {
    const PlaybackTrack track = trackOf(*m_site.database, m_unsafe);
    OpenStored stored(*m_site.database, m_unsafe);
    auto trace = tests::traceOf(*stored.session);
    QVERIFY(trace);
    QCOMPARE(track.trials.size(), trace->trials.size());
    for (std::size_t i = 0; i < track.trials.size(); ++i) {
        const session::PlaybackTrial& trial = track.trials[i];
        const scoring::TrialTrace& truth = trace->trials[i];
        QCOMPARE(trial.marked, truth.marked);
        QCOMPARE(trial.endedInContact, truth.markInContact);
        QVERIFY((trial.p_WEnd - truth.p_WMark_m).norm() < 2e-9);
        QCOMPARE(trial.object->p_WObject.x(), truth.target->x_m);
        QCOMPARE(trial.object->radius_m, truth.target->radius_m);
        QVERIFY(std::abs(trial.end_s - truth.tools[0].t_s.back()) < 1e-9);
        QVERIFY(std::abs(trial.start_s - truth.tools[0].t_s.front()) < 1e-9);
    }
    QCOMPARE(count(track, mark_kinds::kTrialStarted), eventsOf(*m_site.database, m_unsafe, "trial_started"));
    QCOMPARE(count(track, mark_kinds::kMarked), eventsOf(*m_site.database, m_unsafe, "marked"));
    QVERIFY(count(track, mark_kinds::kMissed) > 0); // a hand that marks beside the sphere
    QCOMPARE(count(track, mark_kinds::kMissed), eventsOf(*m_site.database, m_unsafe, "missed"));
    QCOMPARE(count(track, mark_kinds::kOverLimit), eventsOf(*m_site.database, m_unsafe, "force_over_limit"));
    QVERIFY(count(track, mark_kinds::kOverLimit) > 0);
    QVERIFY(count(track, mark_kinds::kContact) > 0);
    for (const session::PlaybackMark& mark : track.marks) {
        QVERIFY(mark.end_s >= mark.t_s && mark.end_s <= track.duration_s);
        if (mark.kind == mark_kinds::kOverLimit)
            QVERIFY(*mark.value > track.forceLimit_N);
    }
    QVERIFY(std::is_sorted(track.marks.begin(), track.marks.end(),
                           [](const auto& a, const auto& b) { return a.t_s < b.t_s; }));
}

void TestPlaybackTrack::completedTrials() {
    tests::MadeSession made = tests::copyOf(*m_site.database, m_expert);
    for (core::HapticFrame& frame :
         made.frames) // as if its trials ended with their procedure done instead of a mark
        if (frame.header.events & core::event_bits::kMarked)
            frame.header.events ^= core::event_bits::kMarked | core::event_bits::kCompleted;
    const database::SessionId id = tests::store(*m_site.database, database::Actor::simulated(), made);
    const PlaybackTrack track = trackOf(*m_site.database, id);
    QCOMPARE(count(track, mark_kinds::kCompleted), 2);
    QCOMPARE(count(track, mark_kinds::kMarked), 0);
    QCOMPARE(eventsOf(*m_site.database, id, "completed"), 2);
    for (const session::PlaybackTrial& trial : track.trials)
        QVERIFY(trial.completed && !trial.marked && !trial.timedOut);
    auto connection = m_site.database->openReader();
    const auto trials = database::SessionReader(**connection, database::Actor::simulated()).trials(id);
    QVERIFY(trials);
    for (const database::TrialRecord& trial : *trials)
        QVERIFY(trial.marked &&
                trial.state == database::SessionState::completed); // ended as the exercise asks
}

void TestPlaybackTrack::pausesAreSpans() {
    tests::MadeSession made = tests::copyOf(*m_site.database, m_expert);
    tests::pauseFrames(made.frames, 4000, 5200);
    tests::pauseFrames(made.frames, 6000, 6100);
    const auto id = tests::store(*m_site.database, database::Actor::simulated(), made);
    const PlaybackTrack track = trackOf(*m_site.database, id);
    QCOMPARE(track.paused.size(), std::size_t{2});
    QCOMPARE(track.paused[0].begin_s, 4.0);
    QCOMPARE(track.paused[0].end_s, 5.2);
    QCOMPARE(count(track, mark_kinds::kPaused), 2);
    QVERIFY(track.pausedAt(4.5) && !track.pausedAt(5.5) && track.pausedAt(6.05));
    QVERIFY(track.at(4.5).moment.paused && !track.at(5.5).moment.paused);
}

void TestPlaybackTrack::stoppedAndInterrupted() {
    tests::MadeSession made = tests::copyOf(*m_site.database, m_expert);
    tests::cutFrames(made.frames, 4000, core::CommandKind::end);
    const auto stopped = tests::store(*m_site.database, database::Actor::simulated(), made);
    const PlaybackTrack track = trackOf(*m_site.database, stopped);
    QCOMPARE(track.duration_s, 3.999);
    QCOMPARE(count(track, mark_kinds::kEnded), 1);
    QCOMPARE(track.trials.size(), std::size_t{1});
    QVERIFY(!track.trials[0].marked && !track.trials[0].timedOut);
    QCOMPARE(track.trials[0].end_s, track.duration_s);

    made.frames.back().header.commands = {};
    made.ending.interrupted = true;
    const auto interrupted = tests::store(*m_site.database, database::Actor::simulated(), made);
    const PlaybackTrack cut = trackOf(*m_site.database, interrupted);
    QCOMPARE(cut.duration_s, 3.999);
    QCOMPARE(count(cut, mark_kinds::kEnded), 0);
    OpenStored stored(*m_site.database, interrupted);
    QCOMPARE(stored.session->record().summary.state, database::SessionState::interrupted);
}

void TestPlaybackTrack::emptySession() {
    tests::MadeSession made = tests::copyOf(*m_site.database, m_expert);
    made.frames.clear();
    const auto id = tests::store(*m_site.database, database::Actor::simulated(), made);
    const PlaybackTrack track = trackOf(*m_site.database, id);
    QVERIFY(track.empty());
    QVERIFY(track.at(1.0).tools.empty());
    QVERIFY(!session::worstMoment(track, {}, {}));
}

void TestPlaybackTrack::damagedChunkIsNamed() {
    SessionFixture site;
    auto result = site.run(site.request(shortLevel(1, 1, 10.0), "expert", 3));
    QVERIFY(result);
    sqlite3* raw = nullptr; // past everything that keeps a database whole
    QCOMPARE(sqlite3_open(site.file().c_str(), &raw), SQLITE_OK);
    const char* flip = "UPDATE chunk SET payload = zeroblob(length(payload)) "
                       "WHERE sequence = 3";
    char* why = nullptr;
    QVERIFY2(sqlite3_exec(raw, flip, nullptr, nullptr, &why) == SQLITE_OK, why ? why : "");
    QCOMPARE(sqlite3_changes(raw), 1);
    sqlite3_close(raw);
    OpenStored stored(*site.database, result->session);
    const auto track = tests::trackOf(*stored.session);
    QVERIFY(!track);
    QCOMPARE(track.error().code, core::ErrorCode::doesNotHold);
    QVERIFY2(QString::fromStdString(track.error().message).contains("chunk 3"),
             track.error().message.c_str());
}

/// Scores, trace and track of one pass are those of passes of their own, and nothing is read twice.
void TestPlaybackTrack::oneReadingForAll() {
    OpenStored together(*m_site.database, m_unsafe);
    QVERIFY(together.session->decode());
    const auto trace = together.session->trace();
    const auto track = together.session->track();
    const auto scores = together.session->computeScores();
    QVERIFY(trace && track && scores);
    QCOMPARE(together.session->decodings(), 1);
    QVERIFY(trace->get() == together.session->trace()->get() &&
            track->get() == together.session->track()->get());

    OpenStored apart(*m_site.database, m_unsafe);
    const auto ownTrack = apart.session->track();
    QVERIFY(ownTrack);
    QCOMPARE(apart.session->decodings(), 1); // an apex is marked from the track alone
    const auto ownScores = apart.session->computeScores();
    QVERIFY(ownScores && session::sameScores(*scores, *ownScores));
    QCOMPARE(apart.session->decodings(), 2);
    QCOMPARE((*ownTrack)->moments.size(), (*track)->moments.size());
    QCOMPARE((*ownTrack)->marks.size(), (*track)->marks.size());
    QCOMPARE((*ownTrack)->duration_s, (*track)->duration_s);
    std::size_t frames = 0;
    QVERIFY(
        together.session->eachChunk([&frames](std::span<const core::HapticFrame> seen) -> core::Result<void> {
            frames += seen.size();
            return {};
        }));
    QCOMPARE(frames,
             static_cast<std::size_t>(
                 together.session->record().summary.frames)); // who wants to see frames sees all of them
}

/// What a session's end stored is what its recording says: events with the outcomes of answers, and trials.
void TestPlaybackTrack::eventsAreThoseThatTheEndStored() {
    for (const database::SessionId id : {m_expert, m_unsafe}) {
        OpenStored stored(*m_site.database, id);
        const auto events = stored.session->events();
        QVERIFY(events);
        QVERIFY(stored.session->trace()); // answers were judged by it, so it came along
        QCOMPARE(stored.session->decodings(), 1);
        QVERIFY(events->get() == stored.session->events()->get());
        auto reader = m_site.database->openReader();
        QVERIFY(reader);
        database::SessionReader rows(**reader, database::Actor::simulated());
        const auto storedEvents = rows.events(id);
        const auto storedTrials = rows.trials(id);
        QVERIFY(storedEvents && storedTrials && !storedEvents->empty());
        QCOMPARE((*events)->events.size(), storedEvents->size());
        for (std::size_t i = 0; i < storedEvents->size(); ++i) {
            const database::EventRecord& derived = (*events)->events[i];
            QCOMPARE(derived.tick, (*storedEvents)[i].tick);
            QCOMPARE(derived.kind, (*storedEvents)[i].kind);
            QCOMPARE(derived.tool, (*storedEvents)[i].tool);
            QCOMPARE(derived.detailJson, (*storedEvents)[i].detailJson);
        }
        QCOMPARE((*events)->trials.size(), storedTrials->size());
        QCOMPARE((*events)->frames, stored.session->record().summary.frames);
        QCOMPARE((*events)->finished,
                 stored.session->record().summary.state == database::SessionState::completed);
    }
}

void TestPlaybackTrack::canBeStopped() {
    OpenStored stored(*m_site.database, m_expert);
    double heard = -1.0;
    const auto track = tests::trackOf(*stored.session, [&heard](double part) {
        heard = part;
        return part < 0.5;
    });
    QVERIFY(!track);
    QCOMPARE(track.error().code, core::ErrorCode::cancelled);
    QVERIFY(heard >= 0.5 && heard < 1.0);
    QVERIFY(tests::trackOf(*stored.session)); // nothing half-read was kept
}

void TestPlaybackTrack::ghostStartsWithTheTrial() {
    const PlaybackTrack track = trackOf(*m_site.database, m_unsafe);
    const PlaybackTrack ghost = trackOf(*m_site.database, m_expert);
    QVERIFY(!session::ghostAt(track, ghost, track.trials[0].start_s - 0.01));
    for (std::size_t k = 0; k < 2; ++k) {
        const auto found = session::ghostAt(track, ghost, track.trials[k].start_s + 0.5);
        QVERIFY(found.has_value());
        QCOMPARE(found->ownTime_s, ghost.trials[k].start_s + 0.5);
        const core::Vec3 own = ghost.at(found->ownTime_s).tools[0].p_WT - ghost.trials[k].object->p_WObject;
        const core::Vec3 seen = found->tool.p_WT - track.trials[k].object->p_WObject;
        QVERIFY((own - seen).norm() < 1e-12);
    }
    const session::GhostSeries series = session::ghostSeries(track, ghost);
    QVERIFY(series.t_s.size() > 100);
    QVERIFY(std::is_sorted(series.t_s.begin(), series.t_s.end()));
    QCOMPARE(static_cast<int>(std::count_if(series.tissue_N.begin(), series.tissue_N.end(),
                                            [](double f) { return std::isnan(f); })),
             2);
}

void TestPlaybackTrack::worstMoment() {
    const PlaybackTrack track = trackOf(*m_site.database, m_unsafe);
    double largest_N = 0.0;
    for (std::size_t i = 0; i < track.moments.size(); ++i) {
        const auto* trial = track.trialAt(track.moments[i].t_s);
        if (trial && track.moments[i].t_s <= trial->end_s)
            largest_N = std::max(largest_N, track.tool(i, 0).tissue_N.norm());
    }
    const auto force = session::worstMoment(track, {}, {});
    QVERIFY(force && !force->gateFailed);
    QCOMPARE(force->reason, std::string("force_max"));
    QCOMPARE(force->value, largest_N);
    QCOMPARE(track.at(force->t_s).tools[0].tissue_N.norm(), largest_N);

    scoring::ScoreCard card;
    card.metrics = {{"apex_error_mean", 1, "%", 40.0, "", false}, {"time", 1, "s", 9.0, "", true}};
    const std::vector<scoring::Gate> gates{{"time", {}, 60.0}, {"apex_error_mean", {}, 25.0}};
    const auto apex = session::worstMoment(track, card, gates);
    QVERIFY(apex && apex->gateFailed);
    QCOMPARE(apex->reason, std::string("apex_error_mean"));
    QCOMPARE(apex->t_s, track.trial(apex->trial)->end_s);
    for (const session::PlaybackTrial& trial : track.trials) {
        const core::Vec3 d = trial.p_WEnd - trial.object->p_WObject;
        QVERIFY(100.0 * std::hypot(d.x(), d.y()) / trial.object->radius_m <= apex->value + 1e-9);
    }
    card.metrics[0].passed = true;
    card.metrics[1].passed = false;
    card.trials = {{{"time", 1, "s", 3.0, "", {}}}, {{"time", 1, "s", 6.0, "", {}}}};
    const auto slow = session::worstMoment(track, card, gates);
    QVERIFY(slow && slow->reason == "time");
    QCOMPARE(slow->trial, 1);
    QCOMPARE(slow->value, 6.0);
}

QTEST_GUILESS_MAIN(TestPlaybackTrack)
#include "test_playback_track.moc"
