// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_report.h"

#include <algorithm>
#include <cstdio>

namespace chiron::simulation {

void MeshReport::add(MeshFinding finding) {
    for (MeshFinding& known : findings)
        if (known.problem == finding.problem && known.repaired == finding.repaired) {
            known.count += finding.count;
            return;
        }
    findings.push_back(std::move(finding));
}

const MeshFinding* MeshReport::find(MeshProblem problem) const noexcept {
    const auto found = std::find_if(findings.begin(), findings.end(),
                                    [&](const MeshFinding& f) { return f.problem == problem; });
    return found == findings.end() ? nullptr : &*found;
}

bool MeshReport::usable() const noexcept {
    return std::all_of(findings.begin(), findings.end(), [](const MeshFinding& f) { return f.repaired; });
}

std::string MeshReport::text() const {
    std::string out;
    for (const MeshFinding& f : findings) {
        out += f.repaired ? "put right: " : "refused: ";
        out += f.place + ": " + f.found;
        if (f.count > 1)
            out += " (" + std::to_string(f.count) + " such)";
        out += ", expected " + f.expected + "\n";
    }
    if (usable()) {
        char line[200];
        std::snprintf(line, sizeof line,
                      "%zu triangles, %zu vertices, %zu shell%s, %.1f x %.1f x %.1f mm, %.2f ml\n", triangles,
                      vertices, shells, shells == 1 ? "" : "s", 1e3 * size_m[0], 1e3 * size_m[1],
                      1e3 * size_m[2], 1e6 * volume_m3);
        out += line;
    }
    return out;
}

} // namespace chiron::simulation
