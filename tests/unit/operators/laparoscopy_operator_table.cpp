// SPDX-License-Identifier: GPL-3.0-or-later
// Prints how each scripted laparoscopist does, as Markdown: laparoscopy_operator_table EXERCISE LEVEL [SEEDS]
// [FIRST] [TRIALS] [OPERATOR]; TRIALS 0: as many as the level has; with SEEDS 0, what happens in the session
// of seed FIRST every quarter of a second. Not a test: it asserts nothing.
#include "support/laparoscopy_session.h"

#include <cstdio>
#include <cstdlib>
#include <map>

using namespace chiron;
using support::LaparoscopyOutcome;

namespace {

struct Spread {
    double sum = 0.0, squares = 0.0;
    int n = 0;
    void add(double x) {
        if (!std::isfinite(x))
            return;
        sum += x;
        squares += x * x;
        ++n;
    }
    double mean() const { return n > 0 ? sum / n : 0.0; }
    double sd() const { return n > 1 ? std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1))) : 0.0; }
};

/// Tells of a tick now and then.
class Story final : public core::IFrameSink {
public:
    explicit Story(std::size_t quantities) : m_quantities(quantities) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        m_events |= frame.header.events;
        if (frame.header.index % 250 != 0)
            return true;
        std::printf("%7.2f trial %d phase %d force %d ev %05x jaw %4d |",
                    1e-3 * static_cast<double>(frame.header.index), frame.header.trial,
                    static_cast<int>(frame.header.phase), static_cast<int>(frame.header.force), m_events,
                    frame.tool[0].jawCounts);
        for (std::size_t i = 0; i < m_quantities; ++i)
            std::printf(" %7.4f", frame.header.quantities[i]);
        for (std::uint32_t tool = 0; tool < frame.tools; ++tool)
            std::printf(" | f %6.2f %6.2f %6.2f", frame.tool[tool].tissue[0], frame.tool[tool].tissue[1],
                        frame.tool[tool].tissue[2]);
        std::printf("\n");
        m_events = 0;
        return true;
    }

private:
    std::size_t m_quantities;
    std::uint32_t m_events = 0;
};

void tell(const catalogue::ExerciseLevel& level, const std::string& name, std::uint64_t seed) {
    const auto kind = session::exerciseKind(level.exercise);
    for (const auto& quantity : (*kind)->quantities(level))
        std::printf("%s ", quantity.id.c_str());
    std::printf("\n");
    Story story((*kind)->quantities(level).size());
    const LaparoscopyOutcome outcome = support::runLaparoscopy({level, name, seed, {}}, &story);
    for (const auto& value : outcome.card.metrics)
        std::printf("%s %g\n", value.id.c_str(), value.value.value_or(std::nan("")));
}

void printRow(const catalogue::ExerciseLevel& level, const std::string& name, std::uint64_t first,
              int seeds) {
    std::map<std::string, Spread> values;
    int trials = 0, completed = 0, failed = 0;
    for (int i = 0; i < seeds; ++i) {
        const LaparoscopyOutcome outcome =
            support::runLaparoscopy({level, name, first + static_cast<std::uint64_t>(i), {}});
        trials += outcome.trials();
        completed += outcome.completed();
        failed += outcome.failed();
        for (const auto& metric : level.metrics)
            values[metric.id].add(outcome.metric(metric.id));
    }
    std::printf("| %s | %d of %d | %d |", name.c_str(), completed, trials, failed);
    for (const auto& metric : level.metrics)
        std::printf(" %.3g ± %.2g |", values[metric.id].mean(), values[metric.id].sd());
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr,
                     "laparoscopy_operator_table EXERCISE LEVEL [SEEDS] [FIRST] [TRIALS] [OPERATOR]\n");
        return 2;
    }
    const catalogue::ExerciseLevel level =
        support::contentLevel(argv[1], std::atoi(argv[2]), argc > 5 ? std::atoi(argv[5]) : 0);
    const int seeds = argc > 3 ? std::atoi(argv[3]) : 20;
    const auto first = static_cast<std::uint64_t>(argc > 4 ? std::atoi(argv[4]) : 1);
    const std::string only = argc > 6 ? argv[6] : "";
    if (seeds == 0) {
        tell(level, only.empty() ? "expert" : only, first);
        return 0;
    }
    std::printf("| operator | completed | torn |");
    for (const auto& metric : level.metrics)
        std::printf(" %s |", metric.id.c_str());
    std::printf("\n|---|---|---|");
    for (std::size_t i = 0; i < level.metrics.size(); ++i)
        std::printf("---|");
    std::printf("\n");
    const auto kind = session::exerciseKind(level.exercise);
    for (const std::string& name : (*kind)->operatorNames())
        if (only.empty() || only == name)
            printRow(level, name, first, seeds);
    return 0;
}
