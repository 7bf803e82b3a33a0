// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/comment_list.h"

#include "database/repositories/session_reader.h"

#include <algorithm>

namespace chiron::desktop {

core::Result<std::vector<FoundComment>> readComments(const database::Database& database, const database::Actor& actor, const ExerciseTitles& titles) {
    auto connection = database.openReader();
    if (!connection)
        return tl::unexpected(connection.error());
    auto sessions = database::SessionReader(**connection, actor).commentedSessions();
    if (!sessions)
        return tl::unexpected(sessions.error());
    const std::map<database::PersonId, std::string> names = shownNames(**connection);
    std::vector<FoundComment> found;
    for (database::CommentedSession& session : *sessions) {
        const bool own = session.session.person == actor.personId();
        const SessionRow row = makeSessionRow(std::move(session.session), titles);
        for (std::size_t i = 0; i < session.comments.size(); ++i) {
            const database::SessionComment& comment = session.comments[i];
            const auto name = names.find(comment.author);
            found.push_back({row, {comment, name == names.end() ? std::string() : name->second}, own && comment.author != actor.personId(),
                             static_cast<int>(i), static_cast<int>(session.comments.size())});
        }
    }
    std::sort(found.begin(), found.end(), [](const FoundComment& a, const FoundComment& b) { return a.named.comment.id > b.named.comment.id; });
    return found;
}

} // namespace chiron::desktop
