// SPDX-License-Identifier: GPL-3.0-or-later
// Building the network allocates, and therefore stands apart from the stepping.
#include "simulation/deformable/spring_network.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace chiron::simulation {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>>;

tl::unexpected<core::Error> refuse(const std::string& why) {
    return core::fail(core::ErrorCode::badInput, "deformable organ: " + why);
}

core::Result<void> checkRange(const char* key, double value, double low, double high) {
    if (value >= low && value <= high)
        return {};
    return refuse(std::string(key) + " is " + std::to_string(value) + ", expected " + std::to_string(low) +
                  " to " + std::to_string(high));
}

core::Result<void> check(const SpringNetworkParameters& p) {
    const struct {
        const char* key;
        double value, low, high;
    } ranges[] = {{"stiffness_N_per_m", p.stiffness_N_per_m, 20.0, 5000.0},
                  {"spread_m", p.spread_m, 0.001, 0.030},
                  {"mass_kg", p.mass_kg, 0.001, 1.0},
                  {"recoveryTime_s", p.recoveryTime_s, 0.0, 2.0},
                  {"volumeKeeping", p.volumeKeeping, 0.0, 0.95},
                  {"deepest_m", p.deepest_m, 0.001, 0.030},
                  {"step_s", p.step_s, 0.010, 0.050}};
    for (const auto& range : ranges)
        CHIRON_TRY(checkRange(range.key, range.value, range.low, range.high));
    return {};
}

core::Result<void> check(const SurfaceView& surface, const std::vector<bool>& anchored,
                         std::uint32_t reference) {
    const std::size_t n = surface.vertices.size();
    if (n == 0 || n > SpringNetwork::kMostVertices || anchored.size() != n)
        return refuse(std::to_string(n) + " vertices and " + std::to_string(anchored.size()) +
                      " anchors, expected as many of both, 1 to " +
                      std::to_string(SpringNetwork::kMostVertices));
    for (std::size_t i = 0; i < n; ++i)
        if (!surface.vertices[i].allFinite())
            return refuse("vertex " + std::to_string(i) + " is not a number");
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (const std::uint32_t vertex : surface.triangles[t])
            if (vertex >= n)
                return refuse("triangle " + std::to_string(t) + " names vertex " + std::to_string(vertex) +
                              " of " + std::to_string(n));
    if (reference >= n || anchored[reference])
        return refuse("reference vertex " + std::to_string(reference) + " is anchored or none of " +
                      std::to_string(n));
    const auto free = static_cast<std::size_t>(std::count(anchored.begin(), anchored.end(), false));
    if (free > SpringNetwork::kMostFree)
        return refuse(std::to_string(free) + " free vertices, at most " +
                      std::to_string(SpringNetwork::kMostFree));
    return {};
}

} // namespace

/// Builds a network from input that has been checked.
class SpringNetworkBuilder {
public:
    SpringNetworkBuilder(const SurfaceView& surface, const std::vector<bool>& anchored,
                         std::uint32_t reference, const SpringNetworkParameters& parameters)
        : m_surface(surface), m_anchored(anchored), m_reference(reference), m_network(new SpringNetwork) {
        m_network->m_parameters = parameters;
        m_network->m_rest.assign(surface.vertices.begin(), surface.vertices.end());
        m_network->m_triangles.assign(surface.triangles.begin(), surface.triangles.end());
    }

    std::unique_ptr<SpringNetwork> build() {
        number();
        areasAndEdges();
        const Sparse shape = stiffness();
        Solver atRest(shape);
        if (atRest.info() != Eigen::Success)
            return nullptr;
        if (!scale(atRest))
            return nullptr;
        factor(shape);
        return std::move(m_network);
    }

private:
    void number() {
        const std::size_t n = m_surface.vertices.size();
        m_free.assign(n, -1);
        for (std::size_t i = 0; i < n; ++i)
            if (!m_anchored[i]) {
                m_free[i] = static_cast<int>(m_vertexOf.size());
                m_vertexOf.push_back(i);
            }
    }

    void areasAndEdges() {
        m_normalArea.assign(m_surface.vertices.size(), core::Vec3::Zero());
        m_area.assign(m_surface.vertices.size(), 0.0);
        std::set<std::pair<std::uint32_t, std::uint32_t>> edges; // each edge once, in order
        for (const MeshTriangle& t : m_surface.triangles) {
            const core::Vec3& a = m_surface.vertices[t[0]];
            const core::Vec3 third =
                (m_surface.vertices[t[1]] - a).cross(m_surface.vertices[t[2]] - a) / 6.0; // a third of n·area
            for (std::size_t c = 0; c < 3; ++c) {
                m_normalArea[t[c]] += third;
                m_area[t[c]] += third.norm();
                edges.insert(std::minmax(t[c], t[(c + 1) % 3]));
            }
        }
        m_edges.assign(edges.begin(), edges.end());
    }

    /// The matrix K for κ = 1 N/m³, by free vertices.
    Sparse stiffness() {
        const double l = m_network->m_parameters.spread_m;
        m_sigma = l * l / std::sqrt(3.0);
        m_ground.assign(m_vertexOf.size(), 0.0);
        for (std::size_t i = 0; i < m_vertexOf.size(); ++i)
            m_ground[i] = m_area[m_vertexOf[i]];
        std::vector<Eigen::Triplet<double>> entries;
        std::vector<double> diagonal = m_ground;
        for (const auto& [va, vb] : m_edges) {
            const int a = m_free[va];
            const int b = m_free[vb];
            for (const int end : {a, b})
                if (end >= 0) {
                    diagonal[static_cast<std::size_t>(end)] += m_sigma;
                    if (a < 0 || b < 0) // the other end is anchored: a spring to the ground
                        m_ground[static_cast<std::size_t>(end)] += m_sigma;
                }
            if (a >= 0 && b >= 0)
                entries.emplace_back(std::max(a, b), std::min(a, b), -m_sigma);
        }
        for (std::size_t i = 0; i < diagonal.size(); ++i)
            entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i]);
        const auto n = static_cast<Eigen::Index>(m_vertexOf.size());
        Sparse matrix(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
        return matrix;
    }

    /// Determines κ so that a lasting press on the reference vertex feels stiffness_N_per_m, including the
    /// volume spring.
    bool scale(const Solver& atRest) {
        const auto n = static_cast<Eigen::Index>(m_vertexOf.size());
        Eigen::MatrixX3d g(n, 3);
        for (Eigen::Index i = 0; i < n; ++i)
            g.row(i) = m_normalArea[m_vertexOf[static_cast<std::size_t>(i)]];
        const Eigen::MatrixX3d y = atRest.solve(g);
        const double all = (g.array() * y.array()).sum();
        const double keeping = m_network->m_parameters.volumeKeeping;
        const Eigen::Index at = m_free[m_reference];
        const core::Vec3 normal = m_normalArea[m_reference].normalized();
        Eigen::VectorXd press = Eigen::VectorXd::Zero(n);
        press[at] = 1.0;
        const double pressed = atRest.solve(press)[at];
        const double moved = normal.dot(core::Vec3(y.row(at)));
        // α = (1/q − 1) g·K⁻¹g: of the volume that a press would displace, the share q is kept.
        const double compliance = pressed - (keeping > 0.0 ? keeping * moved * moved / all : 0.0);
        m_kappa = m_network->m_parameters.stiffness_N_per_m * compliance;
        m_volumeCompliance = keeping > 0.0 ? (1.0 / keeping - 1.0) * all / m_kappa : 0.0;
        return std::isfinite(m_kappa) && m_kappa > 0.0 && std::isfinite(m_volumeCompliance);
    }

    void factor(const Sparse& shape) {
        const SpringNetworkParameters& p = m_network->m_parameters;
        double total = 0.0;
        for (const std::size_t vertex : m_vertexOf)
            total += m_area[vertex];
        const auto n = static_cast<Eigen::Index>(m_vertexOf.size());
        Sparse a = shape * (m_kappa * (1.0 + p.recoveryTime_s / p.step_s));
        for (Eigen::Index i = 0; i < n; ++i)
            a.coeffRef(i, i) +=
                p.mass_kg * m_area[m_vertexOf[static_cast<std::size_t>(i)]] / total / (p.step_s * p.step_s);
        const Solver solver(a);
        takeFactor(solver);
        takeNetwork(solver, total);
        takeVolume();
    }

    void takeFactor(const Solver& solver) {
        const Sparse lower = solver.matrixL().nestedExpression();
        SpringNetwork& net = *m_network;
        net.m_columnBegin.push_back(0);
        for (Eigen::Index j = 0; j < lower.outerSize(); ++j) {
            for (Sparse::InnerIterator it(lower, j); it; ++it)
                if (it.row() > j) {
                    net.m_row.push_back(static_cast<std::uint32_t>(it.row()));
                    net.m_lower.push_back(it.value());
                }
            net.m_columnBegin.push_back(static_cast<std::uint32_t>(net.m_row.size()));
            net.m_inverseDiagonal.push_back(1.0 / solver.vectorD()[j]);
        }
    }

    void takeNetwork(const Solver& solver, double total) {
        SpringNetwork& net = *m_network;
        const std::size_t n = m_vertexOf.size();
        net.m_unknownOf.assign(m_free.size(), -1);
        net.m_mass.assign(n, 0.0);
        net.m_ground.assign(n, 0.0);
        net.m_volumeGradient.assign(3 * n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            const auto unknown =
                static_cast<std::size_t>(solver.permutationP().indices()[static_cast<Eigen::Index>(i)]);
            const std::size_t vertex = m_vertexOf[i];
            net.m_unknownOf[vertex] = static_cast<std::int32_t>(unknown);
            net.m_mass[unknown] = net.m_parameters.mass_kg * m_area[vertex] / total;
            net.m_ground[unknown] = m_kappa * m_ground[i];
            for (std::size_t c = 0; c < 3; ++c)
                net.m_volumeGradient[3 * unknown + c] = m_normalArea[vertex][static_cast<Eigen::Index>(c)];
        }
        net.m_edgeStiffness = m_kappa * m_sigma;
        for (const auto& [a, b] : m_edges)
            if (net.m_unknownOf[a] >= 0 && net.m_unknownOf[b] >= 0)
                net.m_edges.push_back({static_cast<std::uint32_t>(net.m_unknownOf[a]),
                                       static_cast<std::uint32_t>(net.m_unknownOf[b])});
        net.m_u.assign(3 * n, 0.0);
        net.m_v.assign(3 * n, 0.0);
        net.m_delta.assign(3 * n, 0.0);
        net.m_columns.assign(core::kMaxTools * n, 0.0);
        net.m_largestPush_N = net.m_parameters.stiffness_N_per_m * net.m_parameters.deepest_m;
    }

    void takeVolume() {
        SpringNetwork& net = *m_network;
        net.m_volumeResponse.assign(net.m_volumeGradient.size(), 0.0);
        net.m_volumeCompliance = m_volumeCompliance;
        if (m_volumeCompliance <= 0.0)
            return; // no volume is kept: no response, and a diagonal of 1 to divide zeros by
        net.m_volumeResponse = net.m_volumeGradient;
        net.solveVolume();
        double sum = m_volumeCompliance;
        for (std::size_t i = 0; i < net.m_volumeGradient.size(); ++i)
            sum += net.m_volumeGradient[i] * net.m_volumeResponse[i];
        net.m_volumeDiagonal = sum;
    }

    SurfaceView m_surface;
    const std::vector<bool>& m_anchored;
    std::uint32_t m_reference;
    std::unique_ptr<SpringNetwork> m_network;
    std::vector<int> m_free;              ///< vertex → free number, -1 anchored
    std::vector<std::size_t> m_vertexOf;  ///< free number → vertex
    std::vector<double> m_area;           ///< of a vertex, m²
    std::vector<core::Vec3> m_normalArea; ///< a_i n_i
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_edges;
    std::vector<double> m_ground; ///< values for κ = 1
    double m_sigma = 0.0;         ///< value for κ = 1
    double m_kappa = 1.0;
    double m_volumeCompliance = 0.0;
};

core::Result<std::unique_ptr<SpringNetwork>>
SpringNetwork::create(const SurfaceView& surface, const std::vector<bool>& anchored, std::uint32_t reference,
                      const SpringNetworkParameters& parameters) {
    CHIRON_TRY(check(parameters));
    CHIRON_TRY(check(surface, anchored, reference));
    auto network = SpringNetworkBuilder(surface, anchored, reference, parameters).build();
    if (!network)
        return refuse("the mesh gives no sound network; expected a surface of triangles with area");
    return network;
}

} // namespace chiron::simulation
