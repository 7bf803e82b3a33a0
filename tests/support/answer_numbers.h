// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/scene.h"
#include "support/cue_numbers.h"

#include <QString>

#include <cmath>

namespace chiron::tests {

/// Everything that a scene answers at a tick, one number after the other, always as many; what is no number
/// is 0.
inline std::vector<double> answerNumbers(const simulation::SceneOutput& out) {
    std::vector<double> numbers{static_cast<double>(out.trial),       static_cast<double>(out.phase),
                                static_cast<double>(out.events),      out.storedEnergy_J,
                                out.contactStiffness_N_per_m,         out.energyByBody ? 1.0 : 0.0,
                                static_cast<double>(out.tissue.count)};
    const auto all = [&numbers](const auto& values) {
        for (const auto& value : values)
            numbers.push_back(static_cast<double>(value));
    };
    for (const core::Wrench& w : out.tissue.tools)
        all(std::array<double, 6>{w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(),
                                  w.torque.z()});
    all(out.damping_Ns_per_m);
    all(out.load_N);
    for (const core::DisplayPose& display : out.display)
        all(std::array<double, 3>{display.normalForce_N, display.pitch_rad, display.roll_rad});
    for (const core::Vec3& place : out.p_WProxy)
        all(std::array<double, 3>{place.x(), place.y(), place.z()});
    all(out.body);
    all(out.bodyEnergy_J);
    all(out.bodyStiffness_N_per_m);
    all(out.contact);
    all(out.quantities);
    addCueNumbers(numbers, out.cues);
    for (double& number : numbers)
        number = std::isfinite(number) ? number : 0.0;
    return numbers;
}

/// Means over blocks of ticks of all that, each tick weighed by when it was in its block, so that it matters
/// when something happened.
class AnswerBlocks {
public:
    explicit AnswerBlocks(int block_ticks) : m_block_ticks(block_ticks) {}
    /// True where a block is full: its means are in sums() until the next tick.
    bool add(const simulation::SceneOutput& out) {
        if (m_ticks % m_block_ticks == 0)
            m_sums.clear();
        const std::vector<double> numbers = answerNumbers(out);
        m_sums.resize(numbers.size(), 0.0);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            m_sums[i] += numbers[i] * (1.0 + static_cast<double>(m_ticks % m_block_ticks) / m_block_ticks) /
                         m_block_ticks;
        return ++m_ticks % m_block_ticks == 0;
    }
    const std::vector<double>& sums() const { return m_sums; }
    long long ticks() const { return m_ticks; }
    /// For people and kept texts: what is not zero, each after its place in answerNumbers().
    QString line() const {
        QString line = QStringLiteral("after %1:").arg(m_ticks);
        for (std::size_t i = 0; i < m_sums.size(); ++i)
            if (std::abs(m_sums[i]) > 1e-13)
                line += QStringLiteral(" %1 %2").arg(i).arg(m_sums[i], 0, 'g', 10);
        return line;
    }

private:
    int m_block_ticks;
    long long m_ticks = 0;
    std::vector<double> m_sums;
};

} // namespace chiron::tests
