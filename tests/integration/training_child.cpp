// SPDX-License-Identifier: GPL-3.0-or-later
#include "training_child.h"

#include "session/recovery.h"
#include "support/session_fixture.h"
#include "witness_file.h"

#include <cstdio>

using namespace chiron;

namespace {

/// Counts what the recording has taken; on the haptic thread.
class CountingWitness final : public core::IFrameSink {
public:
    explicit CountingWitness(Witness& witness) : m_witness(witness) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        if (frame.header.index != m_next)
            m_witness.gaps.fetch_add(1);
        m_next = frame.header.index + 1;
        m_witness.frames.fetch_add(1);
        if (frame.header.phase == core::TrialPhase::finished)
            m_witness.stage.store(Stage::finishing);
        return true;
    }

private:
    Witness& m_witness;
    std::uint64_t m_next = 0;
};

int failed(const core::Error& error) {
    std::fprintf(stderr, "child: %s\n", error.message.c_str());
    return 1;
}

int train(database::Database& database, const std::string& rings, Witness& witness, std::uint64_t seed,
          double limit_s) {
    const catalogue::ExerciseLevel level = tests::shortLevel(2, 1, limit_s);
    const auto kind = session::exerciseKind(level.exercise);
    auto station = session::scriptedStation(**kind, level, "intermediate", seed);
    if (!station)
        return failed(station.error());
    CountingWitness counter(witness);
    session::TrainingRequest request;
    request.level = level;
    request.seed = seed;
    request.station = std::move(*station);
    request.realtime = true;
    request.ringFolder = rings;
    request.witness = &counter;
    auto result = session::runTraining(database, database::Actor::simulated(), std::move(request));
    return result ? 0 : failed(result.error());
}

} // namespace

std::optional<int> runAsChild(const QStringList& arguments) {
    if (arguments.value(1) != QLatin1String("--child") || arguments.size() != 8)
        return std::nullopt;
    const std::string rings = arguments[4].toStdString();
    const auto witness = WitnessFile::open(arguments[5].toStdString());
    (*witness)->stage.store(Stage::recovering);
    auto database = database::Database::openForWriting(arguments[3].toStdString());
    if (!database)
        return failed(database.error());
    if (auto recovered = session::recoverSessions(**database, rings); !recovered)
        return failed(recovered.error());
    (*witness)->stage.store(Stage::recovered);
    int status = 0;
    if (arguments[2] == QLatin1String("train"))
        status = train(**database, rings, **witness, arguments[6].toULongLong(), arguments[7].toDouble());
    (*witness)->stage.store(Stage::returned);
    return status;
}
