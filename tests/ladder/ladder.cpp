// SPDX-License-Identifier: GPL-3.0-or-later
#include "ladder/ladder.h"

#include "damping/with_budget.h"
#include "ladder/fast_force.h"
#include "ladder/ladder_store.h"
#include "scoring/metric_catalogue.h"
#include "session/replayer.h"
#include "support/named_hands.h"
#include "support/session_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

namespace chiron::tests {

namespace {

constexpr double kZ95 = 1.959963984540054;
const std::vector<std::string> kOperators = LadderSettings().operators; ///< in the order of the table
/// What the controller allows a body that it renders softer to hold beyond the work that was put in: 1 mJ, 1
/// mJ that is forgiven in each contact, and half a millijoule that is made while the share falls
/// (test_two_hands).
constexpr double kSoftened_J = 0.0025;

/// Speed and path: a rough hand is fast and goes straight on. They never decide alone, so they may favour it.
const std::set<std::string_view> kSpeedAndPath{
    "time", "path_length",    "path_inefficiency", "sparc",
    "ldlj", "searching_time", "pressing_time",     "inspection_travel"};

class Witness final : public core::IFrameSink {
public:
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        fast.add(frame);
        acted += (frame.header.guards & core::guard_bits::kPassivity) ? 1 : 0;
        heldBeyond_J = std::max(heldBeyond_J, frame.header.energyStored_J - frame.header.energySupplied_J);
        for (std::uint32_t i = 0; i < frame.tools; ++i) {
            tissue_N = std::max(tissue_N, normOf(frame.tool[i].tissue));
            commanded_N = std::max(commanded_N, normOf(frame.tool[i].commanded));
        }
        return true;
    }
    FastForce fast;
    std::uint64_t acted = 0;
    double heldBeyond_J = 0.0;
    double tissue_N = 0.0, commanded_N = 0.0;

private:
    static double normOf(const core::Array6& wrench) { return std::hypot(wrench[0], wrench[1], wrench[2]); }
};

bool same(const scoring::ScoreCard& a, const scoring::ScoreCard& b) {
    if (a.passed != b.passed || a.metrics.size() != b.metrics.size())
        return false;
    for (std::size_t i = 0; i < a.metrics.size(); ++i)
        if (a.metrics[i].id != b.metrics[i].id || a.metrics[i].value != b.metrics[i].value ||
            a.metrics[i].passed != b.metrics[i].passed)
            return false;
    return true;
}

LadderSession runOne(SessionFixture& site, const catalogue::ExerciseLevel& level, const std::string& name,
                     std::uint64_t seed, bool check, const LadderSettings& settings) {
    LadderSession session;
    session.seed = seed;
    Witness witness;
    std::optional<mechanisms::HandParameters> hand;
    if (!settings.hand.empty() && !(hand = handNamed(settings.hand)))
        qFatal("%s: no hand of that name", settings.hand.c_str());
    session::TrainingRequest request =
        site.request(level, name, seed, settings.mechanism, hand ? &*hand : nullptr);
    request.witness = &witness;
    if (settings.budget_Ns_per_m > 0.0)
        for (auto& tool : request.station.tools)
            tool.device = std::make_unique<WithBudget>(std::move(tool.device), settings.budget_Ns_per_m);
    auto result = site.run(std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    session.card = result->scores;
    session.ticks = result->loop.ticks;
    session.acted = witness.acted;
    session.kept_J = result->loop.passivity_J.value_or(0.0);
    session.withheld_J = result->loop.passivityWithheld_J.value_or(0.0);
    session.heldBeyond_J = witness.heldBeyond_J;
    session.tissue_N = witness.tissue_N;
    session.commanded_N = witness.commanded_N;
    session.fast_N = witness.fast.worst_N();
    session.fastEnds_s = static_cast<double>(witness.fast.worstTick()) * 1e-3;
    session.windows = witness.fast.windows();
    OpenStored stored(*site.database, result->session);
    session.completed = stored.session->record().summary.state == database::SessionState::completed;
    if (check) {
        session.checked = true;
        const auto replay = session::replaySession(*stored.session);
        session.replaysIdentically = replay && replay->identical;
        const auto card = stored.session->computeScores();
        session.scoresIdentically = card && same(*card, session.card);
    }
    return session;
}

/// The operators of the ladder that the exercise has.
std::vector<std::string> operatorsOf(const session::ExerciseKind& kind, const LadderSettings& settings) {
    const std::vector<std::string> names = kind.operatorNames();
    std::vector<std::string> found;
    for (const std::string& name : settings.operators)
        if (std::find(names.begin(), names.end(), name) != names.end())
            found.push_back(name);
    return found;
}

const session::ExerciseKind& kindOf(const catalogue::ExerciseLevel& level) {
    const auto kind = session::exerciseKind(level.exercise);
    if (!kind)
        qFatal("%s", kind.error().message.c_str());
    return **kind;
}

const LadderSession* findSession(const LadderLevel& level, const std::string& name, std::uint64_t seed) {
    const auto sessions = level.byOperator.find(name);
    if (sessions == level.byOperator.end())
        return nullptr;
    const auto found = std::find_if(sessions->second.begin(), sessions->second.end(),
                                    [seed](const LadderSession& session) { return session.seed == seed; });
    return found == sessions->second.end() ? nullptr : &*found;
}

/// Seeds that some operator has done already come first, so that all do the same ones.
std::vector<std::uint64_t> seedsOf(const LadderLevel& stored, const LadderSettings& settings) {
    std::vector<std::uint64_t> seeds;
    const auto add = [&seeds, &settings](std::uint64_t seed) {
        if (seeds.size() < static_cast<std::size_t>(std::max(settings.seeds, 0)) &&
            std::find(seeds.begin(), seeds.end(), seed) == seeds.end())
            seeds.push_back(seed);
    };
    for (const auto& [name, sessions] : stored.byOperator)
        for (const LadderSession& session : sessions)
            add(session.seed);
    for (int i = 0; i < settings.seeds; ++i)
        add(settings.first + static_cast<std::uint64_t>(i));
    return seeds;
}

struct Spread {
    int n = 0;
    double mean = 0.0, variance = 0.0;
};

/// Of the sessions that have the metric.
Spread spreadOf(const std::vector<LadderSession>& sessions, const std::string& id) {
    std::vector<double> values;
    for (const LadderSession& session : sessions)
        for (const scoring::MetricValue& metric : session.card.metrics)
            if (metric.id == id && metric.value)
                values.push_back(*metric.value);
    Spread s;
    s.n = static_cast<int>(values.size());
    for (const double v : values)
        s.mean += v / s.n;
    for (const double v : values)
        s.variance += s.n > 1 ? (v - s.mean) * (v - s.mean) / (s.n - 1) : 0.0;
    return s;
}

Rate gateRate(const std::vector<LadderSession>& sessions, const std::string& id) {
    Rate rate;
    for (const LadderSession& session : sessions)
        for (const scoring::MetricValue& metric : session.card.metrics)
            if (metric.id == id && metric.passed) {
                ++rate.n;
                rate.of += *metric.passed ? 1 : 0;
            }
    return rate;
}

double logChoose(int n, int k) {
    return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
}

/// P(as many or more of b's hits in b), Fisher's exact test of two rates, one-sided.
double fisherTail(const Rate& a, const Rate& b) {
    const int hits = a.of + b.of;
    double p = 0.0;
    for (int k = b.of; k <= std::min(hits, b.n); ++k)
        if (hits - k <= a.n)
            p += std::exp(logChoose(b.n, k) + logChoose(a.n, hits - k) - logChoose(a.n + b.n, hits));
    return p;
}

double wilson(const Rate& r, double sign) {
    if (r.n == 0)
        return sign > 0.0 ? 1.0 : 0.0;
    const double n = r.n, p = r.share(), z = kZ95;
    const double centre = p + z * z / (2.0 * n),
                 half = z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    return std::clamp((centre + sign * half) / (1.0 + z * z / n), 0.0, 1.0);
}

std::string print(const char* format, auto... values) {
    char text[300];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

} // namespace

double Rate::low() const {
    return wilson(*this, -1.0);
}
double Rate::high() const {
    return wilson(*this, 1.0);
}

double riseAtLeast(const Rate& before, const Rate& after) {
    if (before.n == 0 || after.n == 0)
        return -1.0;
    return after.share() - before.share() -
           std::hypot(after.share() - after.low(), before.high() - before.share());
}

Rate passRate(const std::vector<LadderSession>& sessions) {
    Rate rate;
    rate.n = static_cast<int>(sessions.size());
    for (const LadderSession& session : sessions)
        rate.of += session.card.passed ? 1 : 0;
    return rate;
}

std::string nameOf(const catalogue::ExerciseLevel& level) {
    return level.exercise + "/" + std::to_string(level.number) + " " + level.id;
}

LadderLaw lawOf(const catalogue::ExerciseLevel& level) {
    const session::ExerciseKind& kind = kindOf(level);
    const auto station = session::scriptedStation(kind, level, kind.operatorNames().front(), 1);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    session::SessionSetup setup;
    setup.level = level;
    setup.seed = 1;
    setup.mappings = station->mappings();
    for (const session::StationTool& tool : station->tools)
        setup.devices.push_back(tool.device->descriptor());
    const auto scene = kind.makeScene(setup);
    realtime::TickSource ticks;
    simulation::SceneOutput out;
    scene->respond(ticks.next(0), simulation::SceneInput(), out);
    return {scene->conservative(), out.energyByBody};
}

LadderLevel recalled(const catalogue::ExerciseLevel& level, const LadderSettings& settings) {
    LadderLevel found;
    found.level = nameOf(level);
    found.law = lawOf(level);
    for (const std::string& name : operatorsOf(kindOf(level), settings))
        if (settings.store != nullptr)
            if (auto sessions = settings.store->sessions(level, name, settings); !sessions.empty())
                found.byOperator[name] = std::move(sessions);
    return found;
}

LadderLevel climb(const catalogue::ExerciseLevel& level, const LadderSettings& settings) {
    const LadderLevel stored = recalled(level, settings);
    const std::vector<std::uint64_t> seeds = seedsOf(stored, settings);
    LadderLevel climbed;
    climbed.level = stored.level;
    climbed.law = stored.law;
    for (const std::string& name : operatorsOf(kindOf(level), settings)) {
        SessionFixture site; // one a hand, so that the file stays small
        std::vector<LadderSession>& sessions = climbed.byOperator[name];
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            const bool check = settings.checkEvery > 0 && static_cast<int>(i) % settings.checkEvery == 0;
            if (const LadderSession* before = findSession(stored, name, seeds[i]);
                before != nullptr && (before->checked || !check)) {
                sessions.push_back(*before);
                continue;
            }
            sessions.push_back(runOne(site, level, name, seeds[i], check, settings));
            if (settings.store != nullptr)
                settings.store->add(level, name, settings, sessions.back());
        }
    }
    return climbed;
}

std::vector<std::string> inverted(const LadderLevel& level) {
    std::vector<std::string> found;
    if (!level.byOperator.contains("expert") || !level.byOperator.contains("unsafe"))
        return found;
    const auto& expert = level.byOperator.at("expert");
    const auto& unsafe = level.byOperator.at("unsafe");
    for (const scoring::MetricValue& metric : expert.front().card.metrics) {
        const scoring::MetricDefinition* definition = scoring::findMetric(metric.id, metric.version);
        if (!definition || kSpeedAndPath.contains(definition->id))
            continue;
        const Spread e = spreadOf(expert, metric.id), u = spreadOf(unsafe, metric.id);
        if (definition->direction != scoring::Direction::neutral && e.n > 1 && u.n > 1) {
            const double better = definition->direction == scoring::Direction::lowerIsBetter
                                      ? e.mean - u.mean
                                      : u.mean - e.mean;
            if (better > kZ95 * std::sqrt(e.variance / e.n + u.variance / u.n) && better > 1e-12)
                found.push_back(print("%s: expert %.4g ± %.2g (%d), unsafe %.4g ± %.2g (%d)",
                                      metric.id.c_str(), e.mean, std::sqrt(e.variance), e.n, u.mean,
                                      std::sqrt(u.variance), u.n));
        }
        const Rate eg = gateRate(expert, metric.id), ug = gateRate(unsafe, metric.id);
        if (eg.n > 0 && ug.n > 0 && ug.share() > eg.share() && fisherTail(eg, ug) < 0.025)
            found.push_back(print("gate %s: expert %d of %d, unsafe %d of %d", metric.id.c_str(), eg.of, eg.n,
                                  ug.of, ug.n));
    }
    return found;
}

std::vector<std::string> unfounded(const LadderLevel& level) {
    std::vector<std::string> found;
    if (!level.law.conservative)
        return found;
    for (const auto& [name, sessions] : level.byOperator)
        for (const LadderSession& session : sessions) {
            const auto seed = static_cast<unsigned long long>(session.seed);
            if (!level.law.softens && session.acted > 0)
                found.push_back(print("%s, seed %llu: damped in %llu ticks though the law has a potential",
                                      name.c_str(), seed, static_cast<unsigned long long>(session.acted)));
            if (level.law.softens && session.heldBeyond_J > kSoftened_J)
                found.push_back(
                    print("%s, seed %llu: %.2f mJ held beyond the work put in, though the law has a "
                          "potential",
                          name.c_str(), seed, 1e3 * session.heldBeyond_J));
        }
    return found;
}

std::string heading() {
    return "| level | operator | passed | 95 % | completed | tissue max., N | felt max., N | above 20 Hz, N "
           "rms | law | damped ticks | softer ticks | withheld, mJ | spared, mJ | held beyond the work, mJ | "
           "replay and score identical |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string lines(const LadderLevel& level) {
    std::string text;
    for (const std::string& name : kOperators) {
        if (!level.byOperator.contains(name))
            continue;
        const auto& sessions = level.byOperator.at(name);
        const Rate rate = passRate(sessions);
        int completed = 0, checked = 0, same = 0;
        double kept_J = 0.0, withheld_J = 0.0, beyond_J = 0.0, tissue = 0.0, felt = 0.0, fast = 0.0;
        std::uint64_t acted = 0;
        for (const LadderSession& s : sessions) {
            completed += s.completed ? 1 : 0;
            checked += s.checked ? 1 : 0;
            same += s.checked && s.replaysIdentically && s.scoresIdentically ? 1 : 0;
            tissue = std::max(tissue, s.tissue_N);
            felt = std::max(felt, s.commanded_N);
            fast = std::max(fast, s.fast_N);
            acted += s.acted;
            kept_J += s.kept_J;
            withheld_J += s.withheld_J;
            beyond_J = std::max(beyond_J, s.heldBeyond_J);
        }
        const auto damped = static_cast<unsigned long long>(level.law.softens ? 0 : acted);
        const auto softer = static_cast<unsigned long long>(level.law.softens ? acted : 0);
        text +=
            print("| %s | %s | %d of %d | %.0f–%.0f %% | %d | %.2f | %.2f | %.3f | %s | %llu | %llu | %.3f "
                  "| %.3f | %.3f | %d of %d |\n",
                  level.level.c_str(), name.c_str(), rate.of, rate.n, 100.0 * rate.low(), 100.0 * rate.high(),
                  completed, tissue, felt, fast, level.law.conservative ? "−∇U" : "no potential", damped,
                  softer, 1e3 * withheld_J, 1e3 * (withheld_J - kept_J), 1e3 * beyond_J, same, checked);
    }
    return text;
}

std::string metricLines(const LadderLevel& level) {
    std::string text;
    for (const scoring::MetricValue& metric : level.byOperator.begin()->second.front().card.metrics) {
        text += print("%-26s", metric.id.c_str());
        for (const std::string& name : kOperators) {
            if (!level.byOperator.contains(name))
                continue;
            const Spread s = spreadOf(level.byOperator.at(name), metric.id);
            const Rate gate = gateRate(level.byOperator.at(name), metric.id);
            text += s.n > 0 ? print("  %9.4g ±%8.3g", s.mean, std::sqrt(s.variance)) : print("  %19s", "–");
            if (s.n > 0 &&
                s.n < static_cast<int>(level.byOperator.at(name).size())) // undefined in some sessions
                text += print(" (n = %d)", s.n);
            text += gate.n > 0 ? print(" [%2d/%2d]", gate.of, gate.n) : print("        ");
        }
        text += "\n";
    }
    for (const auto& [name, sessions] : level.byOperator) {
        const auto worst = std::max_element(sessions.begin(), sessions.end(),
                                            [](const auto& a, const auto& b) { return a.fast_N < b.fast_N; });
        text += print("above 20 Hz: %s %.3f N, seed %llu, before %.1f s\n", name.c_str(), worst->fast_N,
                      static_cast<unsigned long long>(worst->seed), worst->fastEnds_s);
    }
    return text;
}

} // namespace chiron::tests
