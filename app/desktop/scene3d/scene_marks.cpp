// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/scene_marks.h"

namespace chiron::scene3d {

std::vector<std::string> stageMarks(const SceneSetup& setup, int tools) {
    std::vector<std::string> marks;
    if (setup.cues.arrow)
        marks.insert(marks.end(), {"force_arrow", "force_limit"});
    if (setup.cues.tool)
        marks.push_back("drop_line");
    if (setup.cues.tool && tools > 1)
        marks.push_back("tool_rings");
    return marks;
}

} // namespace chiron::scene3d
