// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/deformable/spring_network.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr std::size_t kContacts = core::kMaxTools;
/// Number of Gauss-Seidel sweeps, always the same; over at most four contacts they converge to rounding.
constexpr int kSweeps = 64;

core::Vec3 three(const std::vector<double>& field, std::size_t unknown) noexcept {
    return {field[3 * unknown], field[3 * unknown + 1], field[3 * unknown + 2]};
}

} // namespace

void SpringNetwork::reset() noexcept {
    std::fill(m_u.begin(), m_u.end(), 0.0);
    std::fill(m_v.begin(), m_v.end(), 0.0);
}

core::Vec3 SpringNetwork::displacement(std::uint32_t vertex) const noexcept {
    const std::int32_t unknown = m_unknownOf[vertex];
    return unknown < 0 ? core::Vec3(core::Vec3::Zero()) : three(m_u, static_cast<std::size_t>(unknown));
}

/// x ← A⁻¹ x for interleaved columns, by substitution with L D Lᵀ.
template <std::size_t Columns> void SpringNetwork::solve(double* x) const noexcept {
    const std::size_t n = m_mass.size();
    for (std::size_t j = 0; j < n; ++j)
        for (std::uint32_t k = m_columnBegin[j]; k < m_columnBegin[j + 1]; ++k)
            for (std::size_t c = 0; c < Columns; ++c)
                x[Columns * m_row[k] + c] -= m_lower[k] * x[Columns * j + c];
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t c = 0; c < Columns; ++c)
            x[Columns * j + c] *= m_inverseDiagonal[j];
    for (std::size_t j = n; j-- > 0;)
        for (std::uint32_t k = m_columnBegin[j]; k < m_columnBegin[j + 1]; ++k)
            for (std::size_t c = 0; c < Columns; ++c)
                x[Columns * j + c] -= m_lower[k] * x[Columns * m_row[k] + c];
}

void SpringNetwork::solveVolume() noexcept {
    solve<3>(m_volumeResponse.data());
}

void SpringNetwork::stiffnessTimes(const double* u, double* result) const noexcept {
    for (std::size_t i = 0; i < m_ground.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            result[3 * i + c] = m_ground[i] * u[3 * i + c];
    for (const Edge& edge : m_edges)
        for (std::size_t c = 0; c < 3; ++c) {
            const double pull = m_edgeStiffness * (u[3 * edge.a + c] - u[3 * edge.b + c]);
            result[3 * edge.a + c] += pull;
            result[3 * edge.b + c] -= pull;
        }
}

bool SpringNetwork::admit(const NetworkPush& push, Contact& contact) const noexcept {
    if (push.triangle >= m_triangles.size() || !push.p_Tool.allFinite() || !push.normal.allFinite() ||
        !(push.stiffness_N_per_m > 0.0) || !std::isfinite(push.stiffness_N_per_m))
        return false;
    bool free = false;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (!(push.weights[corner] >= 0.0 && push.weights[corner] <= 1.0))
            return false;
        contact.unknowns[corner] = m_unknownOf[m_triangles[push.triangle][corner]];
        free = free || contact.unknowns[corner] >= 0;
    }
    contact.weights = push.weights;
    contact.normal = push.normal;
    contact.compliance = 1.0 / push.stiffness_N_per_m;
    core::Vec3 place = core::Vec3::Zero();
    for (std::size_t corner = 0; corner < 3; ++corner)
        place += push.weights[corner] * m_rest[m_triangles[push.triangle][corner]];
    contact.depth_m = push.normal.dot(place + at(contact, m_u) - push.p_Tool);
    return free;
}

core::Vec3 SpringNetwork::at(const Contact& contact, const std::vector<double>& field) const noexcept {
    core::Vec3 sum = core::Vec3::Zero();
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (contact.unknowns[corner] >= 0)
            sum += contact.weights[corner] * three(field, static_cast<std::size_t>(contact.unknowns[corner]));
    return sum;
}

/// Computes δ without contacts and volume spring.
void SpringNetwork::freeStep() noexcept {
    const double h = m_parameters.step_s;
    stiffnessTimes(m_u.data(), m_delta.data());
    m_volumeRest = 0.0;
    for (std::size_t i = 0; i < m_delta.size(); ++i)
        m_delta[i] = m_mass[i / 3] * m_v[i] / h - m_delta[i];
    solve<3>(m_delta.data());
    for (std::size_t i = 0; i < m_delta.size(); ++i)
        m_volumeRest += m_volumeGradient[i] * (m_u[i] + m_delta[i]);
}

/// Computes how the contacts move each other. The volume's multiplier is eliminated, because it is linear in
/// theirs.
void SpringNetwork::coupleContacts(std::span<Contact> contacts) noexcept {
    std::fill(m_columns.begin(), m_columns.end(), 0.0);
    for (std::size_t c = 0; c < contacts.size(); ++c)
        for (std::size_t corner = 0; corner < 3; ++corner)
            if (contacts[c].unknowns[corner] >= 0)
                m_columns[kContacts * static_cast<std::size_t>(contacts[c].unknowns[corner]) + c] +=
                    contacts[c].weights[corner];
    solve<kContacts>(m_columns.data());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        contacts[c].volume = contacts[c].normal.dot(at(contacts[c], m_volumeResponse));
        contacts[c].depth_m += contacts[c].normal.dot(at(contacts[c], m_delta)) -
                               contacts[c].volume * m_volumeRest / m_volumeDiagonal;
    }
    for (std::size_t c = 0; c < contacts.size(); ++c)
        for (std::size_t r = 0; r < contacts.size(); ++r) {
            double moved = 0.0;
            for (std::size_t corner = 0; corner < 3; ++corner)
                if (contacts[c].unknowns[corner] >= 0)
                    moved +=
                        contacts[c].weights[corner] *
                        m_columns[kContacts * static_cast<std::size_t>(contacts[c].unknowns[corner]) + r];
            m_coupling[kContacts * c + r] = contacts[c].normal.dot(contacts[r].normal) * moved -
                                            contacts[c].volume * contacts[r].volume / m_volumeDiagonal;
        }
}

/// Finds λ in [0, largest] so that compliance λ_c + Σ coupling λ_r = depth_c where λ_c is inside that range.
/// Projected Gauss-Seidel converges, because the system is symmetric positive definite.
void SpringNetwork::solveContacts(std::span<const Contact> contacts,
                                  std::array<double, core::kMaxTools>& pushes) const noexcept {
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (std::size_t c = 0; c < contacts.size(); ++c) {
            double rest = contacts[c].depth_m;
            for (std::size_t r = 0; r < contacts.size(); ++r)
                rest -= r == c ? 0.0 : m_coupling[kContacts * c + r] * pushes[r];
            pushes[c] =
                std::clamp(rest / (contacts[c].compliance + std::max(0.0, m_coupling[kContacts * c + c])),
                           0.0, m_largestPush_N);
        }
}

void SpringNetwork::finishStep(std::span<const Contact> contacts,
                               const std::array<double, core::kMaxTools>& pushes) noexcept {
    double volume = -m_volumeRest;
    for (std::size_t c = 0; c < contacts.size(); ++c)
        volume += contacts[c].volume * pushes[c];
    volume /= m_volumeDiagonal; // λ_v
    for (std::size_t i = 0; i < m_mass.size(); ++i) {
        core::Vec3 delta = three(m_delta, i) + volume * three(m_volumeResponse, i);
        for (std::size_t c = 0; c < contacts.size(); ++c)
            delta -= m_columns[kContacts * i + c] * pushes[c] * contacts[c].normal;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            m_u[3 * i + axis] += delta[static_cast<Eigen::Index>(axis)];
            m_v[3 * i + axis] = delta[static_cast<Eigen::Index>(axis)] / m_parameters.step_s;
        }
    }
}

std::array<double, core::kMaxTools> SpringNetwork::step(std::span<const NetworkPush> pushes) noexcept {
    std::array<Contact, kContacts> contacts;
    std::array<std::size_t, kContacts> from{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(pushes.size(), kContacts); ++i)
        if (admit(pushes[i], contacts[count]))
            from[count++] = i;
    freeStep();
    const std::span<Contact> touching(contacts.data(), count);
    std::array<double, kContacts> solved{};
    if (count > 0) {
        coupleContacts(touching);
        solveContacts(touching, solved);
    }
    finishStep(touching, solved);
    std::array<double, kContacts> answer{};
    for (std::size_t c = 0; c < count; ++c)
        answer[from[c]] = solved[c];
    return answer;
}

double SpringNetwork::elasticEnergy_J() const noexcept {
    double twice = 0.0;
    for (std::size_t i = 0; i < m_ground.size(); ++i)
        twice += m_ground[i] * three(m_u, i).squaredNorm();
    for (const Edge& edge : m_edges)
        twice += m_edgeStiffness * (three(m_u, edge.a) - three(m_u, edge.b)).squaredNorm();
    const double volume = volumePressedIn_m3();
    return 0.5 * (twice + (m_volumeCompliance > 0.0 ? volume * volume / m_volumeCompliance : 0.0));
}

double SpringNetwork::kineticEnergy_J() const noexcept {
    double twice = 0.0;
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        twice += m_mass[i] * three(m_v, i).squaredNorm();
    return 0.5 * twice;
}

double SpringNetwork::volumePressedIn_m3() const noexcept {
    double volume = 0.0;
    for (std::size_t i = 0; i < m_u.size(); ++i)
        volume -= m_volumeGradient[i] * m_u[i];
    return volume;
}

} // namespace chiron::simulation
